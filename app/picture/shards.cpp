#include "app/picture/shards.h"

#include <algorithm>

namespace griffith::app {
namespace {

/// Returns the splinters of a frame without their crack state.
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

Shards::Shards(const Frame& frame, const Scene& scene, const Monitor& monitor, const KnownShards& known)
    : neighbors_(frame.elements.neighbors.begin(), frame.elements.neighbors.end()),
      tets_(frame.elements.tets.begin(), frame.elements.tets.end()),
      centers_(scene.bodies.size()) {
  if (std::ssize(tets_) <= kMaxTets && std::ranges::any_of(scene.bodies, may_have_shards))
    make(frame, scene, monitor, known);
  else
    skins_ = make_skins(frame, scene);
}

void Shards::make(const Frame& frame, const Scene& scene, const Monitor& monitor, const KnownShards& known) {
  SplinterSet set = set_of(frame.splinters);
  std::vector<Skin> skins;
  std::vector<int> radial;
  KnownShards made;
  for (int i = 0; i < std::ssize(scene.bodies); ++i) {
    if (!may_have_shards(scene.bodies[i])) continue;
    const PlacedTets placed = placed_tets(frame, tets_, i);
    const BodyShards& body = *made.emplace_back(body_shards(frame, scene, i, placed.soup, centers_[i], known, monitor));
    append(set, body.set, placed.tets.front(), i);
    if (body.order.surface) skins.push_back(make_skin(body, placed, i));
    if (body.order.is_radial()) radial.push_back(i);
  }
  set_ = std::move(set);
  skins_ = std::move(skins);
  radial_ = std::move(radial);
  bodies_ = std::move(made);
}

/// Returns the places of first cracks around which shards lie in that frame; unchanged before the first crack.
FirstCracks Shards::centers_in(const Frame& frame, const Scene& scene) const {
  FirstCracks centers = centers_;
  const FirstCracks cracks = first_cracks(frame, scene.bodies.size());
  for (const int body : radial_)
    if (cracks[body]) centers[body] = cracks[body];
  return centers;
}

bool Shards::are_behind(const Frame& frame, const Scene& scene) const {
  return !radial_.empty() && centers_in(frame, scene) != centers_;
}

bool Shards::follow(const Frame& frame, const Scene& scene) {
  if (!are_behind(frame, scene)) return false;
  centers_ = centers_in(frame, scene);
  make(frame, scene, {}, bodies_);
  return true;
}

SplinterState Shards::state(const Frame& frame) const {
  SplinterState state = intact_state(set_);
  std::ranges::copy(frame.splinters.attached, state.attached.begin());
  state.open_walls.assign(frame.splinters.open_walls.begin(), frame.splinters.open_walls.end());
  std::vector<TetId> cracked;
  for (const TetId tet : IdRange<TetId>(0, std::ssize(neighbors_)))
    if (frame.elements.neighbors[tet] != neighbors_[tet]) cracked.push_back(tet);
  follow_cracks(set_, frame.elements.neighbors, cracked, state);
  return state;
}

FrameWithShards::FrameWithShards(const Frame& frame, const Shards& shards) : frame_(frame) {
  if (shards.empty()) return;
  state_ = shards.state(frame);
  const SplinterSet& set = shards.set();
  frame_.splinters = {set.splinters, set.parts, set.faces, set.corners, state_.attached, state_.open_walls};
}

}  // namespace griffith::app
