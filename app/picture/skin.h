#pragma once

#include <array>
#include <span>
#include <vector>

#include "app/picture/body_shards.h"
#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Carrier of a corner of a body's original surface: the tet that contains it, as long as it belongs to the same body
/// as the tet that owns the polygon; else the owner.
struct SkinPart {
  TetId tet, owner;
};

/// Returns the tet that carries a part in this frame.
TetId skin_carrier(const Frame& frame, const SkinPart& part);

/// A corner of a polygon of the surface.
struct SkinCorner {
  SkinPart part;
  std::array<double, 4> weights = {}, owner_weights = {};  ///< barycentric, in the two tets
  Vec3 rest = Vec3::Zero(), normal = Vec3::Zero();         ///< initial position [m] and normal [-] in the world
  Vec2 uv = Vec2::Zero();
};

/// Original surface of a body, carried by its tets: triangles owned by the tets at their centers or, if the body has
/// shards, the polygons into which these split the triangles, owned by the shards' owners.
struct Skin {
  int scene_body = 0;
  bool has_uvs = false;
  std::vector<int> first_corner = {0};  ///< index of the first corner of each polygon, and the end
  std::vector<SkinCorner> corners;      ///< by polygon, counterclockwise seen from outside

  int polygons() const { return static_cast<int>(first_corner.size()) - 1; }
  std::span<const SkinCorner> polygon(int i) const {
    return std::span(corners).subspan(first_corner[i], first_corner[i + 1] - first_corner[i]);
  }
};

/// Returns the position of a corner in this frame [m].
Vec3 skin_position(const Frame& frame, const SkinCorner& corner);

/// Returns the skins of all bodies that have one, with undivided triangles: bodies made from a surface, without
/// splinters and not remeshed, which would remove the tets below. `frame`: before any fracture. Throws InputError if a
/// file cannot be read.
std::vector<Skin> make_skins(const Frame& frame, const Scene& scene);

/// Returns the original surface in `shards`, split by them. `placed`: their tets in the frame.
Skin make_skin(const BodyShards& shards, const PlacedTets& placed, int scene_body);

}  // namespace griffith::app
