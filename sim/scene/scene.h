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
#include "sim/scene/shape.h"
#include "sim/splinters/splinter_pattern.h"

namespace griffith {

/// What stands in for a body where it touches others.
enum class CollisionShape {
  elements,   ///< convex parts of its tets
  splinters,  ///< convex parts of the splinters that it owns
};

/// How displacements vary within the tets of a body.
enum class ElementOrder {
  automatic,  ///< quadratic where few lie across the body (choose_elements() in check_elements.h)
  linear,     ///< a constant strain a tet: cheap, but one or two across a thin body hardly bend
  quadratic,  ///< linear strains: bends right with a single layer of tets
};
inline constexpr ElementOrder kDefaultElementOrder = ElementOrder::linear;

struct BodyDescription {
  std::string name = "body";
  Shape shape;
  Vec3 position = Vec3::Zero();          ///< of the shape's origin [m]
  Vec3 rotation_degrees = Vec3::Zero();  ///< about the fixed x, then y, then z axis [degrees]
  Vec3 velocity = Vec3::Zero();          ///< at the start [m/s]
  Vec3 angular_velocity = Vec3::Zero();  ///< at the start, about the centre of mass [rad/s]
  Material material;
  ElementOrder elements = kDefaultElementOrder;
  bool remeshing = false;           ///< cracks cut tets along their plane instead of following faces
  double minimum_element_size = 0;  ///< edges that remeshing may make [m]; 0: a quarter of the first elements' size
  std::optional<Weakness> weakness;
  std::optional<StrengthScatter> strength_scatter;
  std::vector<Support> supports;
  std::vector<Load> loads;
  std::optional<SplinterPattern> splinters;             ///< what is seen of it when it breaks; none: its tets
  CollisionShape collision = CollisionShape::elements;  ///< `splinters` only where it has some
  bool operator==(const BodyDescription&) const = default;
};

/// `count` equal projectiles, `interval` apart, the first at `start`.
struct ProjectileBurst {
  int count = 1;                                        ///< 1..10000
  double interval = 0.25;                               ///< [s], >= 0
  double start = 0;                                     ///< [s], >= 0
  Vec3 position = Vec3(0, 1, 5);                        ///< of the centre of mass [m]
  Vec3 direction = Vec3(0, 0, -1);                      ///< of flight; any length but 0
  double speed = 40;                                    ///< [m/s], >= 0
  double mass = 25;                                     ///< [kg], > 0
  double radius = 0.2;                                  ///< of a sphere [m], > 0
  std::optional<double> density = std::nullopt;         ///< [kg/m³], > 0; says the mass in place of `mass`
  std::optional<ProjectileShape> shape = std::nullopt;  ///< none: a sphere
  Vec3 rotation_degrees = Vec3::Zero();                 ///< at launch, about the fixed x, then y, then z axis [degrees]
  Vec3 angular_velocity = Vec3::Zero();                 ///< at launch [rad/s]
  double friction = 0.6;                                ///< Coulomb's
  double restitution = 0.1;                             ///< 1 bounces back fully
  bool operator==(const ProjectileBurst&) const = default;
};

/// A horizontal plane that fills everything below `height`.
struct Ground {
  double height = 0;  ///< [m]
  double friction = 0.8;
  double restitution = 0.1;
  bool operator==(const Ground&) const = default;
};

/// How a scene is computed.
enum class Analysis {
  dynamic,      ///< step by step through time
  equilibrium,  ///< at rest under what acts at the time: no inertia
};

/// How a body moves through a step.
enum class Integrator {
  implicit_euler,    ///< a linear system a step: stable at any length
  hybrid,            ///< implicit, and microsteps at the stable step in bodies that are struck or crack
  symplectic_euler,  ///< no system, but as many substeps as stability asks for
};

/// How the step is carried out. Budgets count work, never time, so results do not depend on the machine.
struct SimulationSettings {
  double time_step = 1.0 / 120;  ///< [s], 1e-5..0.1
  Integrator integrator = Integrator::hybrid;
  bool static_start = true;         ///< supported bodies start at rest under gravity and their loads at time 0
  int impact_substeps = 32;         ///< most equilibria of a static step, 1..256
  double step_budget = 10;          ///< work of a step's microsteps, about milliseconds of a usual core, 0.1..1e6
  double relative_residual = 1e-4;  ///< the linear solver stops here, 1e-12..0.1
  int max_solver_iterations = 400;  ///< per body and substep, 1..100000
  bool fracture = true;
  int max_cracks_per_step = 10000;  ///< splits a step; what is over waits for the next step, 1..1000000
  int min_fragment_tets = 1;        ///< a split that would part off fewer tets does not happen, 1..1000
  bool operator==(const SimulationSettings&) const = default;
};

struct Camera {
  std::string name = "main";
  Vec3 position = Vec3(4, 3, 8);      ///< [m]
  Vec3 target = Vec3::Zero();         ///< [m]
  double field_of_view_degrees = 40;  ///< vertical, 5..120
  bool operator==(const Camera&) const = default;
};

/// How the tets of a body are drawn.
enum class ElementStyle {
  surface,    ///< the faces that nothing lies behind
  wireframe,  ///< all edges, and nothing else
  shrunken,   ///< each tet by itself, drawn smaller
};

/// How much a picture takes to be beautiful. Colours of scalars without shading are the same in each.
enum class PictureQuality {
  draft,     ///< plain light, hard shadows, rough edges: the fastest
  standard,  ///< soft shadows, ambient occlusion, see-through glass
  high,      ///< the same with more samples
};

/// What can be drawn besides the bodies; view_layers() has the names and what they mean, in this order.
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

/// What is shown at first; nothing here influences the simulation.
struct ViewSettings {
  std::string quantity = "von_mises";   ///< one of view_quantities()
  std::string color_map = "automatic";  ///< one of color_map_names()
  std::optional<Vec2> range;            ///< in the quantity's unit; automatic when absent
  PictureQuality quality = PictureQuality::standard;
  bool shading = true;     ///< off: a scalar's pixel has the legend's colour to the byte
  bool symmetric = false;  ///< the automatic range reaches as far below 0 as above
  bool edges = true;
  double edge_width = 1.1;  ///< of element edges, in pixels of a picture 720 pixels high, 0.25..10
  bool splinters = true;    ///< shown in place of tets where a body has them
  ElementStyle elements = ElementStyle::surface;
  bool dust = true;                 ///< cracks throw out dust and crumbs, in natural colours and not in draft
  double deformation_scale = 1;     ///< pieces are drawn deformed this many times as much as they are, 0..1e6
  double explode = 0;               ///< pieces are drawn this much farther from the middle, 0..20; 0: where they are
  double opacity = 1;               ///< of bodies, 0.05..1
  std::optional<SlicePlane> slice;  ///< bodies are drawn cut by it
  std::vector<ViewLayer> layers;
  int fracture_planes = 100;  ///< of how many cracks, newest first, 1..1000000
  double glyph_scale = 1;     ///< size of arrows and other signs, 0.01..100
  bool operator==(const ViewSettings&) const = default;
};

/// Everything the user authored. A plain value: copy it, compare it, keep it in an undo entry.
struct Scene {
  std::string name = "untitled";
  std::string description;
  Vec3 gravity = Vec3(0, -9.81, 0);  ///< [m/s²]
  std::optional<Ground> ground = Ground{};
  std::vector<BodyDescription> bodies;
  std::vector<ProjectileBurst> projectiles;
  Analysis analysis = Analysis::dynamic;
  SimulationSettings simulation;
  std::vector<Probe> probes;    ///< of different names
  std::vector<Camera> cameras;  ///< the first one is used unless another is named; none: frame everything
  ViewSettings view;
  std::vector<Material> materials;  ///< the file's own, by different names; bodies hold copies of those they have
  std::string schema;               ///< path of the file's schema, for text editors; empty: none
  std::filesystem::path folder;     ///< relative paths start here; not written to the file
  bool operator==(const Scene&) const = default;
};

}  // namespace griffith
