#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "sim/elasticity/material.h"
#include "sim/fracture/strength_variation.h"
#include "sim/scene/boundary_condition.h"
#include "sim/scene/probe.h"
#include "sim/scene/projectile_shape.h"
#include "sim/scene/residual_stress.h"
#include "sim/scene/shape.h"
#include "sim/splinters/splinter_pattern.h"

namespace griffith {

/// Shape of a body in contacts.
enum class CollisionShape {
  elements,   ///< convex parts of its tets
  splinters,  ///< convex parts of its splinters
};

/// Order of the displacements within the tets of a body.
enum class ElementOrder {
  automatic,  ///< quadratic in slender bodies with few across (choose_elements() in choose_elements.h)
  linear,     ///< constant strain per tet: cheap, but too stiff in bending with one or two layers
  quadratic,  ///< linear strain: bends correctly with a single layer of tets
};
inline constexpr ElementOrder kDefaultElementOrder = ElementOrder::automatic;

struct BodyDescription {
  std::string name = "body";
  Shape shape;
  Vec3 position = Vec3::Zero();          ///< position of the shape's origin [m]
  Vec3 rotation_degrees = Vec3::Zero();  ///< rotation about the fixed x, then y, then z axis [degrees]
  Vec3 velocity = Vec3::Zero();          ///< initial velocity [m/s]
  Vec3 angular_velocity = Vec3::Zero();  ///< initial angular velocity about the center of mass [rad/s]
  Material material;
  ElementOrder elements = kDefaultElementOrder;
  bool remeshing = false;           ///< cracks cut tets along their plane instead of following faces
  double minimum_element_size = 0;  ///< shortest edge of remeshing [m]; 0: a quarter of the initial element size
  std::optional<Weakness> weakness;
  std::optional<StrengthScatter> strength_scatter;
  std::optional<ResidualStress> residual_stress;
  std::vector<Support> supports;
  std::vector<Load> loads;
  std::optional<SplinterPattern> splinters;             ///< visible fragments when it breaks; none: its tets
  CollisionShape collision = CollisionShape::elements;  ///< `splinters` requires some
  bool operator==(const BodyDescription&) const = default;
};

/// Burst of `count` equal projectiles, `interval` apart, the first one at `start`.
struct ProjectileBurst {
  int count = 1;                                        ///< number of projectiles, 1..10000
  double interval = 0.25;                               ///< [s], >= 0
  double start = 0;                                     ///< [s], >= 0
  Vec3 position = Vec3(0, 1, 5);                        ///< initial position of the center of mass [m]
  Vec3 direction = Vec3(0, 0, -1);                      ///< direction of flight; any length but 0
  double speed = 40;                                    ///< [m/s], >= 0
  double mass = 25;                                     ///< [kg], > 0
  double radius = 0.2;                                  ///< radius of a sphere [m], > 0
  std::optional<double> density = std::nullopt;         ///< [kg/m³], > 0; sets the mass in place of `mass`
  std::optional<ProjectileShape> shape = std::nullopt;  ///< none: a sphere
  Vec3 rotation_degrees = Vec3::Zero();  ///< rotation at launch about the fixed x, then y, then z axis [degrees]
  Vec3 angular_velocity = Vec3::Zero();  ///< angular velocity at launch [rad/s]
  double friction = 0.6;                 ///< Coulomb's coefficient
  double restitution = 0.1;              ///< coefficient of restitution; 1: no loss
  bool operator==(const ProjectileBurst&) const = default;
};

/// Horizontal plane; everything below `height` is solid.
struct Ground {
  double height = 0;  ///< [m]
  double friction = 0.8;
  double restitution = 0.1;
  bool operator==(const Ground&) const = default;
};

/// Kind of analysis of a scene.
enum class Analysis {
  dynamic,  ///< integration in time
  static_,  ///< equilibrium with the loads at each time, without inertia
};

/// Time integration of a body.
enum class Integrator {
  implicit,   ///< one linear system per step: stable at any length
  hybrid,     ///< implicit, with microsteps at the stable step in bodies that are hit or crack
  explicit_,  ///< no linear system, but as many substeps as stability requires
};

/// Settings of a step. Budgets count work, not time, so results do not depend on the machine.
struct SimulationSettings {
  double time_step = 1.0 / 120;  ///< [s], 1e-5..0.1
  Integrator integrator = Integrator::hybrid;
  bool static_start = true;         ///< supported bodies start in equilibrium with gravity and their loads at time 0
  int impact_substeps = 32;         ///< largest number of equilibria of a static step, 1..256
  double step_budget = 10;          ///< work of a step's microsteps, about milliseconds of a typical core, 0.1..1e6
  double relative_residual = 1e-4;  ///< tolerance of the linear solver, 1e-12..0.1
  int max_solver_iterations = 400;  ///< limit per body and substep, 1..100000
  bool fracture = true;
  int max_cracks_per_step = 10000;  ///< limit of splits per step; the rest waits for the next step, 1..1000000
  int min_fragment_tets = 1;        ///< splits that would cut off fewer tets are skipped, 1..1000
  bool operator==(const SimulationSettings&) const = default;
};

struct Camera {
  std::string name = "main";
  Vec3 position = Vec3(4, 3, 8);      ///< [m]
  Vec3 target = Vec3::Zero();         ///< [m]
  double field_of_view_degrees = 40;  ///< vertical angle of view, 5..120
  bool operator==(const Camera&) const = default;
};

/// Style of drawing the tets of a body.
enum class ElementStyle {
  surface,    ///< faces without a neighbor
  wireframe,  ///< only the edges
  shrunken,   ///< separate tets, drawn smaller
};

/// Quality of a picture. Colors of scalars without shading are the same in each.
enum class PictureQuality {
  draft,     ///< plain light, hard shadows, jagged edges: the fastest
  standard,  ///< soft shadows, ambient occlusion, transparent glass
  high,      ///< like standard, with more samples
};

/// Layers drawn besides the bodies. view_layers() has their names and meanings in this order.
enum class ViewLayer {
  stress_axes,
  stress_ellipsoids,
  separation_axes,
  velocities,
  contacts,
  fracture_planes,
  candidate_plane,
  element_forces,
  body_frames,
  collision_shapes,
  supports,
  loads,
  probes,
};

/// Hides the points x with x · normal/|normal| > offset.
struct SlicePlane {
  Vec3 normal = Vec3::UnitZ();  ///< any length but 0
  double offset = 0;            ///< [m]
  bool operator==(const SlicePlane&) const = default;
};

/// Initial view. It does not affect the simulation.
struct ViewSettings {
  std::string quantity = "von_mises";   ///< one of view_quantities()
  std::string color_map = "automatic";  ///< one of color_map_names()
  std::optional<Vec2> range;  ///< values of the ends of the color map, in the quantity's unit; absent: automatic
  PictureQuality quality = PictureQuality::standard;
  bool shading = true;     ///< off: the pixels of a scalar have exactly the legend's color
  bool symmetric = false;  ///< the automatic range extends equally below and above 0
  bool edges = true;
  double edge_width = 1.1;  ///< width of element edges, in pixels of a picture 720 pixels high, 0.25..10
  bool splinters = true;    ///< drawn in place of tets where a body has them
  ElementStyle elements = ElementStyle::surface;
  bool dust = true;                 ///< cracks emit dust and crumbs, in natural colors and not in draft quality
  double deformation_scale = 1;     ///< magnification of the drawn deformation of pieces, 0..1e6
  double explode = 0;               ///< relative extra distance of pieces from the center, 0..20; 0: true positions
  double opacity = 1;               ///< opacity of bodies, 0.05..1
  std::optional<SlicePlane> slice;  ///< plane that cuts the drawn bodies
  std::vector<ViewLayer> layers;
  int fracture_planes = 100;  ///< number of cracks with a drawn plane, newest first, 1..1000000
  double glyph_scale = 1;     ///< size of arrows and other symbols, 0.01..100
  bool operator==(const ViewSettings&) const = default;
};

/// Everything authored by the user. A plain value, to be copied, compared and kept in undo entries.
struct Scene {
  std::string name = "untitled";
  std::string description;
  Vec3 gravity = Vec3(0, -9.81, 0);  ///< [m/s²]
  std::optional<Ground> ground = Ground{};
  std::vector<BodyDescription> bodies;
  std::vector<ProjectileBurst> projectiles;
  Analysis analysis = Analysis::dynamic;
  SimulationSettings simulation;
  std::vector<Probe> probes;    ///< probes of different names
  std::vector<Camera> cameras;  ///< the first one is the default; none: a view of everything
  ViewSettings view;
  std::vector<Material> materials;  ///< materials of the file, of different names; bodies hold copies of theirs
  std::string schema;               ///< path of the file's schema, for text editors; empty: none
  std::filesystem::path folder;     ///< start of relative paths; not written to the file
  bool operator==(const Scene&) const = default;
};

}  // namespace griffith
