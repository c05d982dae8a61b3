#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/natural_materials.h"
#include "sim/core/linear_algebra.h"
#include "sim/fracture/scaled_impact.h"

namespace griffith::app {

/// How a surface looks, as programs of pictures have it (metallic-roughness model).
struct BakedMaterial {
  std::string name;                   ///< unique, e.g. "pane_inside"
  Vec3 color = Vec3::Ones();          ///< linear RGB, 0 to 1
  double opacity = 1, roughness = 1;  ///< 0 to 1
};

/// A closed triangle mesh, in the frame of the thing that has it. Points on edges between flat faces stand there once
/// a face, so that each has its face's normal.
struct BakedMesh {
  std::vector<Vec3> points;   ///< [m]
  std::vector<Vec3> normals;  ///< unit, per point
  std::vector<Vec2> uvs;      ///< per point: texture coordinates of its surface, v upwards; else a box projection [m]
  /// By Look: of points, counter-clockwise seen from outside. Inside are the faces that cracks opened.
  std::array<std::vector<std::array<int, 3>>, kLooks> triangles;
};

/// A piece at the end of the baked frames, or a projectile.
struct BakedThing {
  std::string name;                  ///< unique among all things, a word of letters, digits and _, e.g. "pane_0012"
  int scene_body = -1;               ///< index into Scene::bodies; -1: a projectile
  double mass = 0;                   ///< [kg]
  bool is_supported = false;         ///< held by a support in the last frame
  std::optional<double> break_time;  ///< when it last parted from another piece [s]; none: never did, or before
  std::optional<ScaledImpact> broke_scaled;  ///< as BodyView
  std::array<int, kLooks> materials = {};    ///< by Look: indices into Bake::materials
  BakedMesh mesh;                            ///< its origin: the center of mass in the first frame it is seen in
  int first_frame = 0;      ///< index into Bake::times of the first frame it is there: 0, but for shots
  std::vector<Pose> poses;  ///< per frame from first_frame: its own frame in the world's
  /// Per frame from first_frame, per point of the mesh: where it is in the thing's own frame [m], with all elastic
  /// deformation. Empty unless asked for.
  std::vector<std::vector<Vec3>> deformed_points;
};

/// What held two pieces of one scene body together where they touched at rest.
struct BakedBond {
  int a = 0, b = 0;                  ///< indices into Bake::things, a < b
  double area = 0;                   ///< [m²]
  Vec3 center = Vec3::Zero();        ///< area-weighted, world, as in the first frame [m]
  Vec3 normal = Vec3::UnitY();       ///< unit, from a to b, as in the first frame
  double strength = 0;               ///< tensile strength, area-weighted with its scatter and weakness [Pa]
  std::optional<double> break_time;  ///< when its last face opened [s]; none: something still holds, or before
};

/// A stretch of a run as rigid pieces that move: what other programs can play and take apart. World axes: y up,
/// right-handed; SI units.
struct Bake {
  std::string scene_name;
  std::vector<std::string> body_names;  ///< of the scene, by number
  double frames_per_second = 60;        ///< of the times, rounded where steps are no whole fraction of a second
  std::vector<double> times;            ///< of the frames, ascending [s]; at least one
  std::vector<BakedMaterial> materials;
  std::vector<BakedThing> things;  ///< pieces by scene body and number, then projectiles
  std::vector<BakedBond> bonds;    ///< by a, then b
};

}  // namespace griffith::app
