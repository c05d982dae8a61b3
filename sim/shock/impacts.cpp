#include "sim/shock/impacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>

#include "sim/core/sort_unique.h"
#include "sim/geometry/closest_on_triangle.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith::shock {
namespace {

/// Rounds of impulses over all touches of a microstep.
constexpr int kRounds = 4;
/// What of the reach of candidates things may use up before they get into a fresh crack.
constexpr double kReachOfCracks = 0.25;
/// Candidates are listed for about so many microsteps, within an edge length.
constexpr double kMicrostepsOfCandidates = 24;
/// What a candidate takes in a microstep, half of them being too far away to be looked at, and a touch [µs].
constexpr double kCandidateWork = 0.012, kTouchWork = 0.3;

std::array<int, 3> nodes_of(const Solid& solid, const SurfaceSide& side) {
  std::array<int, 3> nodes{};
  for (int i = 0; i < 3; ++i) nodes[i] = solid.corner(side.slot, kTetFaces[side.face][i]);
  return nodes;
}

int body_at(const Solid& solid, int node) { return solid.body_of_slot(solid.star(node).front() / 4); }

/// How high the tet behind a side is over it, undeformed [m].
double height_behind(const Solid& solid, const SurfaceSide& side) {
  const std::array<int, 3> nodes = nodes_of(solid, side);
  const Vec3 a = solid.reference(nodes[0]);
  const Vec3 area = (solid.reference(nodes[1]) - a).cross(solid.reference(nodes[2]) - a);
  return -area.dot(solid.reference(solid.corner(side.slot, side.face)) - a) / area.norm();
}

Eigen::AlignedBox3d box_of(const Solid& solid, const SurfaceSide& side) {
  Eigen::AlignedBox3d box;
  for (const int node : nodes_of(solid, side)) box.extend(solid.position(node));
  return box;
}

/// How far a point is outside a convex solid that lies there, at most, and across which face.
std::pair<double, Vec3> outermost_face(const ConvexSolid& solid, const Vec3& local) {
  double maximum = -std::numeric_limits<double>::infinity();
  Vec3 normal = Vec3::UnitY();
  for (const HalfSpace& face : solid.faces) {
    const double distance = face.distance(local);
    if (distance > maximum) maximum = distance, normal = face.normal;
  }
  return {maximum, normal};
}

/// Whether an obstacle may be no further than `margin` from something in that box: by the sphere round it, or by the
/// faces of what has none.
bool may_be_near(const Obstacle& obstacle, const Eigen::AlignedBox3d& box, double margin) {
  const Pose& pose = obstacle.state.pose;
  if (std::isfinite(obstacle.radius)) {
    const double reach = obstacle.radius + margin;
    return !(box.squaredExteriorDistance(pose.translation) > reach * reach);
  }
  const Vec3 center = pose.to_local(box.center());
  return std::ranges::any_of(obstacle.solids, [&](const ConvexSolid& solid) {
    const auto [outside, normal] = outermost_face(solid, center);
    return outside - 0.5 * (pose.rotation * normal).cwiseAbs().dot(box.sizes()) < margin;
  });
}

}  // namespace

Impacts::Impacts(const Solid& solid, std::span<const SurfaceSide> surface, std::span<const CrackSides> cracks,
                 std::vector<Obstacle> obstacles, std::vector<SurfaceLaw> surfaces, double element_size)
    : obstacles_(std::move(obstacles)),
      surfaces_(std::move(surfaces)),
      candidates_(obstacles_.size()),
      element_size_(element_size) {
  for (const SurfaceSide& side : surface) add_side(solid, side);
  for (const CrackSides& crack : cracks) cracks_.push_back({{}, crack});
  catch_up();
}

void Impacts::add_side(const Solid& solid, const SurfaceSide& side) {
  constexpr double kDeepest = 0.5;  // of the height behind: what is beyond a thin sheet does not lie behind its side
  surface_.push_back({side, kDeepest * height_behind(solid, side)});
}

void Impacts::open(const Solid& solid, const CrackSides& sides) {
  cracks_.push_back({{}, sides});
  const auto add = [&](int slot, const std::array<int, 3>& corners) {
    add_side(solid, {slot, 6 - corners[0] - corners[1] - corners[2]});
  };
  add(sides.first_slot, sides.first_corners);
  add(sides.second_slot, sides.second_corners);
  // Nothing is between them yet: it has to get there.
  listed_until_ = std::min(listed_until_, travelled_ + kReachOfCracks * margin_);
}

void Impacts::list_near_obstacle(const Solid& solid, const Obstacle& obstacle, Candidates& candidates) {
  candidates.sides.clear(), candidates.nodes.clear(), candidates.samples.clear();
  near_.clear();
  for (const BoxedSide& boxed : boxed_)
    if (may_be_near(obstacle, boxed.box, margin_)) near_.push_back(boxed);
  if (obstacle.is_sphere()) {
    for (const BoxedSide& near : near_) candidates.sides.push_back({{}, near.side});
    return;
  }
  near_nodes_.clear();
  for (const BoxedSide& near : near_)
    for (const int node : nodes_of(solid, near.side)) near_nodes_.push_back(node);
  sort_unique(near_nodes_);
  for (int part = 0; part < static_cast<int>(obstacle.solids.size()); ++part)
    list_near_part(solid, obstacle, part, candidates);
}

/// Lists, of the nodes of the sides near an obstacle, those that are near one of its parts, and that part's samples
/// near the sides.
void Impacts::list_near_part(const Solid& solid, const Obstacle& obstacle, int part, Candidates& candidates) const {
  const ConvexSolid& convex = obstacle.solids[part];
  for (const int node : near_nodes_)
    if (outermost_face(convex, obstacle.state.pose.to_local(solid.position(node))).first < margin_)
      candidates.nodes.push_back({{}, part, node});
  for (int sample = 0; sample < static_cast<int>(convex.samples.size()); ++sample) {
    const Vec3 place = obstacle.state.pose.to_world(convex.samples[sample]);
    for (const BoxedSide& near : near_)
      if (near.box.squaredExteriorDistance(place) < margin_ * margin_)
        candidates.samples.push_back({{}, part, sample, near.side});
  }
}

const SurfaceLaw& Impacts::surface_at(const Solid& solid, int node) const { return surfaces_[body_at(solid, node)]; }

/// The listed sides that may be near bodies of other families.
std::vector<Impacts::BoxedSide> Impacts::sides_near_others(const Solid& solid) const {
  const auto family_of = [&](const BoxedSide& boxed) { return surfaces_[solid.body_of_slot(boxed.side.slot)].family; };
  std::map<int, Eigen::AlignedBox3d> families;
  for (const BoxedSide& boxed : boxed_) families[family_of(boxed)].extend(boxed.box);
  std::vector<BoxedSide> near;
  std::ranges::copy_if(boxed_, std::back_inserter(near), [&](const BoxedSide& boxed) {
    return std::ranges::any_of(families, [&, own = family_of(boxed)](const auto& family) {
      return family.first != own && family.second.squaredExteriorDistance(boxed.box) < margin_ * margin_;
    });
  });
  return near;
}

/// The nodes of these sides, in the order of their places along an axis.
std::vector<Impacts::PlacedNode> Impacts::nodes_along(const Solid& solid, std::span<const BoxedSide> sides,
                                                      int axis) const {
  std::vector<int> nodes;
  for (const BoxedSide& boxed : sides)
    for (const int node : nodes_of(solid, boxed.side)) nodes.push_back(node);
  sort_unique(nodes);
  std::vector<PlacedNode> placed;
  for (const int node : nodes) placed.push_back({solid.position(node), node, surface_at(solid, node).family});
  std::ranges::sort(placed, {}, [&](const PlacedNode& node) { return node.place[axis]; });
  return placed;
}

/// Nodes near sides of other bodies, by a sweep along the axis in which those extend most.
void Impacts::list_pairs(const Solid& solid) {
  pairs_.clear();
  const std::vector<BoxedSide> sides = sides_near_others(solid);
  if (sides.empty()) return;
  Eigen::AlignedBox3d all;
  for (const BoxedSide& boxed : sides) all.extend(boxed.box);
  int axis = 0;
  all.sizes().maxCoeff(&axis);
  const std::vector<PlacedNode> nodes = nodes_along(solid, sides, axis);
  const auto along = [&](const PlacedNode& node) { return node.place[axis]; };
  for (const auto& [box, side] : sides) {
    const int family = surfaces_[solid.body_of_slot(side.slot)].family;
    for (auto at = std::ranges::lower_bound(nodes, box.min()[axis] - margin_, {}, along);
         at != nodes.end() && along(*at) <= box.max()[axis] + margin_; ++at)
      if (at->family != family && box.squaredExteriorDistance(at->place) < margin_ * margin_)
        pairs_.push_back({{}, at->node, side});
  }
  std::ranges::stable_sort(pairs_, {}, &NodeAndSide::node);
}

/// `displacement`: that two things may come nearer to each other in a microstep [m].
void Impacts::list_candidates(const Solid& solid, double displacement) {
  margin_ = std::clamp(kMicrostepsOfCandidates * displacement, 0.25 * element_size_, element_size_);
  for (const Obstacle& obstacle : obstacles_)
    if (obstacle.inverse_mass > 0 && std::isfinite(obstacle.radius)) margin_ = std::max(margin_, 0.1 * obstacle.radius);
  catch_up();
  boxed_.clear();
  for (const Side& side : surface_) boxed_.push_back({box_of(solid, side), side});
  for (std::size_t i = 0; i < obstacles_.size(); ++i) list_near_obstacle(solid, obstacles_[i], candidates_[i]);
  list_pairs(solid);
  listed_until_ = travelled_ + margin_;
}

/// Records that things are so far apart [m].
void Impacts::record_gap(Watched& watched, double gap) const {
  if (gap > 0) watched.clear_until = travelled_ + gap;
}

void Impacts::touch_sphere(const Solid& solid, int index) {
  const Obstacle& sphere = obstacles_[index];
  const Vec3& center = sphere.state.pose.translation;
  for (WatchedSide& near : candidates_[index].sides) {
    if (is_clear(near)) continue;
    Touch touch{.nodes = nodes_of(solid, near.side), .obstacle = index};
    const Vec3 a = solid.position(touch.nodes[0]), b = solid.position(touch.nodes[1]),
               c = solid.position(touch.nodes[2]);
    const Vec3 weights = closest_on_triangle(center, {a, b, c});
    touch.weights = {weights[0], weights[1], weights[2]};
    touch.place = touch.weights[0] * a + touch.weights[1] * b + touch.weights[2] * c;
    const Vec3 away = center - touch.place;
    touch.depth = sphere.radius - away.norm();
    record_gap(near, -touch.depth);
    if (touch.depth < 0 || (b - a).cross(c - a).dot(center - a) <= 0) continue;
    touch.normal = away.normalized();
    touches_.push_back(touch);
  }
}

double Impacts::gap_behind(const Solid& solid, const Side& side, const Vec3& point, Touch& touch) const {
  constexpr double kOutside = 0.02;  // of a side: corners that meet corners touch though they shift a little
  constexpr double kFraction = 0.5;  // sides turn about their edges
  touch.nodes = nodes_of(solid, side);
  const Vec3 a = solid.position(touch.nodes[0]), b = solid.position(touch.nodes[1]), c = solid.position(touch.nodes[2]);
  const Vec3 normal = (b - a).cross(c - a);
  const double area = normal.norm();
  touch.normal = normal / area;
  touch.depth = -touch.normal.dot(point - a);
  if (touch.depth < 0) return -touch.depth;
  if (touch.depth > side.deepest) return kFraction * (touch.depth - side.deepest);
  touch.weights = weights_in_triangle(a, b, c, normal, area * area, point);
  touch.place = point;
  const double beyond = -kOutside - std::ranges::min(touch.weights);
  if (!(beyond > 0)) return 0;
  const double longest = std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  return kFraction * beyond * area / longest;
}

bool Impacts::is_nearer(const Solid& solid, const Touch& touch, const Touch& other) const {
  // Of an edge: beyond rounding and what a microstep brings. Things that overlap would else leap from side to side.
  constexpr double kSameDepth = 1e-4;
  if (std::abs(touch.depth - other.depth) > kSameDepth * element_size_) return touch.depth < other.depth;
  return approach_of(solid, touch).dot(touch.normal) < approach_of(solid, other).dot(other.normal);
}

/// Nodes inside a convex part, and its sample points behind sides.
void Impacts::touch_convex(const Solid& solid, int index) {
  const Obstacle& obstacle = obstacles_[index];
  Candidates& candidates = candidates_[index];
  const Pose& pose = obstacle.state.pose;
  const std::size_t first_touch = touches_.size();
  for (PartAndNode& near : candidates.nodes) {
    if (is_clear(near)) continue;
    const Vec3 place = solid.position(near.node);
    const auto [outside, normal] = outermost_face(obstacle.solids[near.part], pose.to_local(place));
    record_gap(near, outside);
    if (outside > 0) continue;
    Touch touch{.nodes = {near.node, near.node, near.node}, .count = 1, .obstacle = index, .place = place};
    touch.normal = -(pose.rotation * normal);
    touch.depth = -outside;
    touches_.push_back(touch);
  }
  const auto same_sample = [](const SampleAndSide& a, const SampleAndSide& b) {
    return a.part == b.part && a.sample == b.sample;
  };
  for (auto first = candidates.samples.begin(); first != candidates.samples.end();) {
    const Vec3 place = pose.to_world(obstacle.solids[first->part].samples[first->sample]);
    std::optional<Touch> nearest;
    auto at = first;
    for (; at != candidates.samples.end() && same_sample(*at, *first); ++at) {
      if (is_clear(*at)) continue;
      Touch touch{.obstacle = index};
      const double gap = gap_behind(solid, at->side, place, touch);
      record_gap(*at, gap);
      if (gap == 0 && (!nearest || is_nearer(solid, touch, *nearest))) nearest = touch;
    }
    if (nearest) touches_.push_back(*nearest);
    first = at;
  }
  drop_clamps(solid, first_touch);
}

/// Of touches with one other thing, those from `first` on: what has got through a body is behind sides that look away
/// from each other. Both would be held, and whatever vibrates between them pressed ever tighter: it goes out the
/// shorter way alone.
void Impacts::drop_clamps(const Solid& solid, std::size_t first) {
  constexpr double kOpposite = -0.5;  // cosine
  const auto clamp = [&](const Touch& a, const Touch& b) {
    return a.normal.dot(b.normal) < kOpposite && (b.place - a.place).dot(a.normal) < 0 &&
           body_at(solid, a.nodes[0]) == body_at(solid, b.nodes[0]);
  };
  const std::span<Touch> found = std::span(touches_).subspan(first);
  if (found.size() < 2) return;
  std::vector<std::uint8_t> dropped(found.size(), 0);
  for (std::size_t a = 0; a < found.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (clamp(found[a], found[b])) dropped[found[a].depth > found[b].depth ? a : b] = 1;
  std::size_t kept = first;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (dropped[i] == 0) touches_[kept++] = found[i];
  touches_.resize(kept);
}

/// Each node against the side of another body that it lies behind least deep.
void Impacts::touch_bodies(const Solid& solid) {
  std::size_t first_touch = touches_.size();  // of one body
  int body = -1;
  for (auto at = pairs_.begin(); at != pairs_.end();) {
    const int node = at->node;
    if (body_at(solid, node) != body) {
      drop_clamps(solid, first_touch);
      first_touch = touches_.size();
      body = body_at(solid, node);
    }
    const Vec3 place = solid.position(node);
    std::optional<Touch> nearest;
    for (; at != pairs_.end() && at->node == node; ++at) {
      if (is_clear(*at)) continue;
      Touch touch{.other_node = node};
      const double gap = gap_behind(solid, at->side, place, touch);
      record_gap(*at, gap);
      if (gap == 0 && (!nearest || is_nearer(solid, touch, *nearest))) nearest = touch;
    }
    if (nearest) touches_.push_back(*nearest);
  }
  drop_clamps(solid, first_touch);
}

void Impacts::find_touches(const Solid& solid) {
  touches_.clear();
  for (int i = 0; i < static_cast<int>(obstacles_.size()); ++i)
    obstacles_[i].is_sphere() ? touch_sphere(solid, i) : touch_convex(solid, i);
  touch_bodies(solid);
  order_.resize(touches_.size());
  std::iota(order_.begin(), order_.end(), 0);
  std::ranges::stable_sort(order_, std::ranges::greater(), [&](int index) { return touches_[index].depth; });
}

std::size_t Impacts::candidate_count() const {
  std::size_t count = pairs_.size() + cracks_.size();
  for (const Candidates& near : candidates_) count += near.sides.size() + near.nodes.size() + near.samples.size();
  return count;
}

double Impacts::fastest_of(const Solid& solid) const {
  double fastest = solid.fastest();
  for (const Obstacle& obstacle : obstacles_) {
    const double turning =
        std::isfinite(obstacle.radius) ? obstacle.state.angular_velocity.norm() * obstacle.radius : 0;
    fastest = std::max(fastest, obstacle.state.velocity.norm() + turning);
  }
  return fastest;
}

void Impacts::catch_up() {
  for (Obstacle& obstacle : obstacles_) obstacle.move(0);
}

void Impacts::resolve(Solid& solid, double dt, double min_speed) {
  blows_.clear();
  settle_pushed(solid, dt);
  for (std::size_t i = 0; i < obstacles_.size(); ++i)
    candidates_[i].empty() ? obstacles_[i].wait(dt) : obstacles_[i].move(dt);
  const double displacement = 2 * dt * fastest_of(solid);
  travelled_ += displacement;
  if (travelled_ > listed_until_) list_candidates(solid, displacement);
  find_touches(solid);
  work_ += kCandidateWork * static_cast<double>(candidate_count()) + kTouchWork * static_cast<double>(touches_.size());
  bool any = !touches_.empty();
  for (int round = 0; round < kRounds && any; ++round) {
    any = false;
    for (const int index : order_) any |= push(solid, touches_[index], dt, min_speed);
  }
  if (!touches_.empty())
    travelled_ += std::max(0.0, 2 * dt * fastest_of(solid) - displacement);  // pushes may throw things back
  if (!cracks_.empty()) close_cracks(solid);
  record_pushed(solid);
}

}  // namespace griffith::shock
