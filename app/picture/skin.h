#pragma once

#include <array>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// What carries a corner of a body's original surface: the tet that holds it while that belongs to the body of the tet
/// that holds the triangle, else the triangle's.
struct SkinPart {
  TetId tet, triangle_tet;
};

/// The tet that carries a part in this frame.
TetId skin_carrier(const Frame& frame, const SkinPart& part);

/// A corner of a triangle of the surface.
struct SkinCorner {
  SkinPart part;
  std::array<double, 4> weights = {}, triangle_weights = {};  ///< barycentric, in the two tets
  Vec3 rest = Vec3::Zero(), normal = Vec3::Zero();            ///< as it stood in the world at the start [m], [-]
  Vec2 uv = Vec2::Zero();
};

/// The surface that a body was filled from, carried by its tets.
struct Skin {
  int scene_body = 0;
  bool has_uvs = false;
  std::vector<SkinCorner> corners;  ///< three a triangle, counter-clockwise seen from outside
};

/// Where a corner is in this frame [m].
Vec3 skin_position(const Frame& frame, const SkinCorner& corner);

/// The skins of all bodies that have one: filled from a surface, without splinters, and not remeshed, which would take
/// the tets away from under it. `frame`: before anything broke. Throws InputError when a file cannot be read.
std::vector<Skin> make_skins(const Frame& frame, const Scene& scene);

}  // namespace griffith::app
