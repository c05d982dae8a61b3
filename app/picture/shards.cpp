#include "app/picture/shards.h"

#include <Eigen/Geometry>

#include "app/picture/fit_walls.h"
#include "app/picture/natural_materials.h"
#include "app/picture/placed_surface.h"
#include "sim/mesh/topology.h"

namespace griffith::app {
namespace {

/// Along the grain where the scene tells it, else along the longest edge of the body's box.
Vec3 grain_of(const TetSoup& soup, const std::optional<Weakness>& weakness) {
  if (weakness && weakness->kind == WeaknessKind::grain) return weakness->direction;
  Eigen::AlignedBox3d box;
  for (const Vec3& point : soup.points) box.extend(point);
  int longest = 0;
  box.sizes().maxCoeff(&longest);
  return Vec3::Unit(longest);
}

ShardPattern shard_pattern(const Frame& frame, int scene_body, const TetSoup& soup) {
  constexpr double kWoodElongation = 4;
  ShardPattern pattern;
  pattern.seed = scene_body + 1;
  if (!preset_alike(frame.materials[scene_body]).starts_with("wood")) return pattern;
  pattern.grain = grain_of(soup, frame.weaknesses[scene_body]);
  pattern.elongation = kWoodElongation;
  return pattern;
}

bool may_have_shards(const BodyDescription& body) { return !body.splinters && !body.remeshing; }

BodyShards shards_of(const Frame& frame, const Scene& scene, int scene_body, const Monitor& monitor) {
  BodyShards shards;
  shards.scene_body = scene_body;
  shards.placed = placed_tets(frame, scene_body);
  const TetMesh mesh = build_mesh(shards.placed.soup);
  shards.cells = make_shard_cells(mesh, shard_pattern(frame, scene_body, shards.placed.soup));
  shards.set = make_splinters(mesh, shards.cells, monitor);
  if (const BodyDescription& body = scene.bodies[scene_body]; shows_surface(body))
    fit_walls(shards.set, shards.placed, placed_surface(scene, body));
  return shards;
}

/// The splinters of a frame, for others to follow them; cracks are followed by the frame.
SplinterSet set_of(const Frame::Splinters& splinters) {
  SplinterSet set;
  set.splinters.assign(splinters.splinters.begin(), splinters.splinters.end());
  set.parts.assign(splinters.parts.begin(), splinters.parts.end());
  set.faces.assign(splinters.faces.begin(), splinters.faces.end());
  set.corners.assign(splinters.corners.begin(), splinters.corners.end());
  set.first_link.assign(set.splinters.size() + 1, 0);
  return set;
}

}  // namespace

Shards::Shards(const Frame& frame, const Scene& scene, const Monitor& monitor)
    : neighbours_(frame.elements.neighbours.begin(), frame.elements.neighbours.end()) {
  if (std::ssize(frame.elements.tets) > kMaxTets) return;
  for (int i = 0; i < std::ssize(scene.bodies); ++i)
    if (may_have_shards(scene.bodies[i])) bodies_.push_back(shards_of(frame, scene, i, monitor));
  set_ = set_of(frame.splinters);
  for (const BodyShards& body : bodies_) append(set_, body.set, body.placed.tets.front(), body.scene_body);
}

SplinterState Shards::state(const Frame& frame) const {
  SplinterState state = intact_state(set_);
  std::ranges::copy(frame.splinters.attached, state.attached.begin());
  state.open_walls.assign(frame.splinters.open_walls.begin(), frame.splinters.open_walls.end());
  std::vector<TetId> cracked;
  for (TetId tet(0); tet < std::ssize(neighbours_); ++tet.value)
    if (frame.elements.neighbours[tet] != neighbours_[tet]) cracked.push_back(tet);
  follow_cracks(set_, frame.elements.neighbours, cracked, state);
  return state;
}

FrameWithShards::FrameWithShards(const Frame& frame, const Shards& shards) : frame_(frame) {
  if (shards.empty()) return;
  state_ = shards.state(frame);
  const SplinterSet& set = shards.set();
  frame_.splinters = {set.splinters, set.parts, set.faces, set.corners, state_.attached, state_.open_walls};
}

}  // namespace griffith::app
