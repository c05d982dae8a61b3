#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim/elasticity/material.h"
#include "sim/linear_algebra.h"
#include "sim/mesh/box_pattern.h"
#include "sim/scene/region.h"

namespace griffith {

/// A box centred on the body's origin, cut into cells of about `element_size` and these into tetrahedra.
struct BoxShape {
  Vec3 size = Vec3::Ones();                 ///< edge lengths [m], > 0
  Vec3 element_size = Vec3::Constant(0.5);  ///< wanted cell edge along x, y, z [m], > 0; rounded to fit the box
  BoxPattern pattern = BoxPattern::five_tet;
  bool operator==(const BoxShape&) const = default;
};

/// A tetrahedral mesh from a file; for the CSV pair the folder that holds verts.csv and tets.csv.
struct MeshFileShape {
  std::filesystem::path path;  ///< as written in the scene; relative paths start at the scene file's folder
  double scale = 1;            ///< metres per unit of the file, > 0
  bool operator==(const MeshFileShape&) const = default;
};

using Shape = std::variant<BoxShape, MeshFileShape>;

/// The nodes of a region, held in place.
struct Support {
  Region region;
  bool operator==(const Support&) const = default;
};

struct BodyDescription {
  std::string name = "body";
  Shape shape;
  Vec3 position = Vec3::Zero();          ///< of the shape's origin [m]
  Vec3 rotation_degrees = Vec3::Zero();  ///< about the fixed x, then y, then z axis [degrees]
  Vec3 velocity = Vec3::Zero();          ///< at the start [m/s]
  Vec3 angular_velocity = Vec3::Zero();  ///< at the start, about the centre of mass [rad/s]
  Material material;
  std::vector<Support> supports;
  bool operator==(const BodyDescription&) const = default;
};

/// `count` spheres, `interval` apart, the first at `start`.
struct ProjectileBurst {
  int count = 1;                    ///< 1..10000
  double interval = 0.25;           ///< [s], >= 0
  double start = 0;                 ///< [s], >= 0
  Vec3 position = Vec3(0, 1, 5);    ///< of the sphere's centre [m]
  Vec3 direction = Vec3(0, 0, -1);  ///< of flight; any length but 0
  double speed = 40;                ///< [m/s], >= 0
  double mass = 25;                 ///< [kg], > 0
  double radius = 0.2;              ///< [m], > 0
  bool operator==(const ProjectileBurst&) const = default;
};

/// A horizontal plane that fills everything below `height`.
struct Ground {
  double height = 0;  ///< [m]
  double friction = 0.8;
  double restitution = 0.1;
  bool operator==(const Ground&) const = default;
};

/// How the step is carried out. Budgets count work, never time, so results do not depend on the machine.
struct SimulationSettings {
  double time_step = 1.0 / 120;     ///< [s], 1e-5..0.1
  int impact_substeps = 32;         ///< most substeps of a step in which something strikes, 1..256
  double relative_residual = 1e-4;  ///< the linear solver stops here, 1e-12..0.1
  int max_solver_iterations = 400;  ///< per body and substep, 1..100000
  bool fracture = true;
  int max_cracks_per_step = 400;  ///< splits a step; what is over waits for the next step, 1..1000000
  int min_fragment_tets = 1;      ///< a split that would part off fewer tets does not happen, 1..1000
  bool operator==(const SimulationSettings&) const = default;
};

struct Camera {
  std::string name = "main";
  Vec3 position = Vec3(4, 3, 8);      ///< [m]
  Vec3 target = Vec3::Zero();         ///< [m]
  double field_of_view_degrees = 40;  ///< vertical, 5..120
  bool operator==(const Camera&) const = default;
};

/// What is shown at first; nothing here influences the simulation.
struct ViewSettings {
  std::string quantity = "von_mises";  ///< one of view_quantities()
  std::string color_map = "viridis";   ///< viridis, coolwarm or cividis
  std::optional<Vec2> range;           ///< in the quantity's unit; automatic when absent
  bool edges = true;
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
  SimulationSettings simulation;
  std::vector<Camera> cameras;  ///< the first one is used unless another is named; none: frame everything
  ViewSettings view;
  std::filesystem::path folder;  ///< relative mesh paths start here; not written to the file
  bool operator==(const Scene&) const = default;
};

}  // namespace griffith
