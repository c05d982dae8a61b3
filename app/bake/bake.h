#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/natural_materials.h"
#include "sim/core/linear_algebra.h"
#include "sim/fracture/scaled_impact.h"

namespace griffith::app {

/// Appearance of a surface in the metallic-roughness model.
struct BakedMaterial {
  std::string name;                   ///< unique, e.g. "pane_inside"
  Vec3 color = Vec3::Ones();          ///< linear RGB, 0 to 1
  double opacity = 1, roughness = 1;  ///< 0 to 1
};

/// A closed triangle mesh in the frame of its object. Points on edges between flat faces are duplicated for each face,
/// with that face's normal.
struct BakedMesh {
  std::vector<Vec3> points;   ///< positions [m]
  std::vector<Vec3> normals;  ///< unit, per point
  std::vector<Vec2> uvs;      ///< texture coordinates per point, v upward; a box projection without a texture [m]
  /// Indices of points by Look, counterclockwise seen from outside. Inside are the faces opened by cracks.
  std::array<std::vector<std::array<int, 3>>, kLooks> triangles;
};

/// A piece at the end of the baked frames, or a projectile.
struct BakedObject {
  std::string name;                  ///< unique identifier of letters, digits and _, e.g. "pane_0012"
  int scene_body = -1;               ///< index into Scene::bodies; -1: a projectile
  double mass = 0;                   ///< [kg]
  bool is_supported = false;         ///< has a support in the last frame
  std::optional<double> break_time;  ///< last separation from another piece [s]; none: never, or before the first frame
  std::optional<ScaledImpact> broke_scaled;  ///< as BodyView
  std::array<int, kLooks> materials = {};    ///< by Look: indices into Bake::materials
  BakedMesh mesh;                            ///< relative to the center of mass in its first frame
  int first_frame = 0;      ///< index into Bake::times of the first frame in which it exists: 0, except for shots
  std::vector<Pose> poses;  ///< per frame from first_frame: object frame in the world
  /// Per frame from first_frame and per point of the mesh: position in the object frame including elastic deformation
  /// [m]. Empty unless requested.
  std::vector<std::vector<Vec3>> deformed_points;
};

/// Former connection of two pieces of one scene body that touched at rest.
struct BakedBond {
  int a = 0, b = 0;             ///< indices into Bake::objects, a < b
  double area = 0;              ///< [m²]
  Vec3 center = Vec3::Zero();   ///< area-weighted, world, as in the first frame [m]
  Vec3 normal = Vec3::UnitY();  ///< unit, from a to b, as in the first frame
  double strength = 0;          ///< tensile strength, area-weighted with its scatter and weakness [Pa]
  std::optional<double>
      break_time;  ///< opening of the last face [s]; none: still holds, or opened before the first frame
};

/// A part of a run as moving rigid pieces, for other programs. World axes: y up, right-handed; SI units.
struct Bake {
  std::string scene_name;
  std::vector<std::string> body_names;  ///< names of the scene's bodies by index
  double frames_per_second = 60;        ///< rate of the frames, rounded if a second is no whole number of steps
  std::vector<double> times;            ///< times of the frames, ascending [s]; at least one
  std::vector<BakedMaterial> materials;
  std::vector<BakedObject> objects;  ///< pieces by scene body and number, then projectiles
  std::vector<BakedBond> bonds;      ///< sorted by a, then b
};

}  // namespace griffith::app
