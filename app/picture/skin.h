#pragma once

#include <array>
#include <span>
#include <vector>

#include "app/picture/body_shards.h"
#include "sim/scene/scene.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// What carries a corner of a body's original surface: the tet that holds it while that belongs to the body of the tet
/// that owns the polygon, else the owner.
struct SkinPart {
  TetId tet, owner;
};

/// The tet that carries a part in this frame.
TetId skin_carrier(const Frame& frame, const SkinPart& part);

/// A corner of a polygon of the surface.
struct SkinCorner {
  SkinPart part;
  std::array<double, 4> weights = {}, owner_weights = {};  ///< barycentric, in the two tets
  Vec3 rest = Vec3::Zero(), normal = Vec3::Zero();         ///< as it stood in the world at the start [m], [-]
  Vec2 uv = Vec2::Zero();
};

/// The surface that a body was filled from, carried by its tets: its triangles, owned by the tets in their middles; or,
/// where the body has shards, the polygons into which these part them, owned by the shards' owners.
struct Skin {
  int scene_body = 0;
  bool has_uvs = false;
  std::vector<int> first_corner = {0};  ///< per polygon, and the end
  std::vector<SkinCorner> corners;      ///< by polygon, counter-clockwise seen from outside

  int polygons() const { return static_cast<int>(first_corner.size()) - 1; }
  std::span<const SkinCorner> polygon(int i) const {
    return std::span(corners).subspan(first_corner[i], first_corner[i + 1] - first_corner[i]);
  }
};

/// Where a corner is in this frame [m].
Vec3 skin_position(const Frame& frame, const SkinCorner& corner);

/// The skins of all bodies that have one, their triangles whole: filled from a surface, without splinters, and not
/// remeshed, which would take the tets away from under it. `frame`: before anything broke. Throws InputError when a
/// file cannot be read.
std::vector<Skin> make_skins(const Frame& frame, const Scene& scene);

/// The surface that a body shows, which `shards` has, parted by them.
Skin make_skin(const BodyShards& shards);

}  // namespace griffith::app
