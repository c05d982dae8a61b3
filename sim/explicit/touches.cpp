#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/core/parallel.h"
#include "sim/explicit/four_sides.h"
#include "sim/explicit/microstep_contacts.h"
#include "sim/geometry/triangle.h"

namespace griffith::explicit_dynamics {
namespace {

/// Positions of four points relative to one side each.
struct FourBehind {
  FourVectors normals;                 ///< unit normals out of the sides
  std::array<DoubleLanes, 3> weights;  ///< weights of the corners
  DoubleLanes depth;                   ///< depth below the planes of the sides [m]
  DoubleLanes clear;                   ///< distance that they may still approach without getting behind [m]
  DoubleMask are_behind;
};

/// Finds the points behind a side, at most `deepest` deep [m].
FourBehind behind(const FourSides& sides, const FourVectors& points, const DoubleLanes& deepest) {
  constexpr double kOutside = 0.02;  // of a side, so that corners that meet corners touch in spite of small shifts
  constexpr double kFraction = 0.5;  // sides rotate about their edges
  FourBehind found;
  const FourVectors across = double_areas(sides);
  const DoubleLanes size = simd::root(dot(across, across)), square = size * size;
  found.normals = across / size;
  found.depth = -dot(found.normals, points - sides[0]);
  found.weights = weights_in(sides, across, square, points);
  const DoubleLanes least = smaller(smaller(found.weights[0], found.weights[1]), found.weights[2]);
  const DoubleLanes beyond = -kOutside - least;
  const DoubleLanes outside = distance_beyond(sides, square, beyond);
  found.clear = found.depth < 0.0       ? -found.depth
                : found.depth > deepest ? kFraction * (found.depth - deepest)
                                        : outside;
  found.are_behind = (found.depth >= 0.0) & (found.depth <= deepest) & (beyond <= 0.0);
  return found;
}

}  // namespace

/// Records the distance of a pair [m].
void MicrostepContacts::record_gap(Watched& watched, double gap) const {
  if (gap > 0) watched.clear_until = travelled_ + gap;
}

void MicrostepContacts::touch_sphere(const ExplicitBodies& bodies, int index) {
  const Obstacle& sphere = obstacles_[index];
  const Vec3& center = sphere.state.pose.translation;
  for (WatchedSide& near : candidates_[index].sides) {
    if (is_clear(near)) continue;
    Touch touch{.nodes = bodies.nodes_of_side(near.side.slot, near.side.face), .obstacle = index};
    const Vec3 a = bodies.position(touch.nodes[0]), b = bodies.position(touch.nodes[1]),
               c = bodies.position(touch.nodes[2]);
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

bool MicrostepContacts::is_nearer(const ExplicitBodies& bodies, const Touch& touch, const Touch& other) const {
  // Relative to an edge: beyond rounding and the motion of a microstep. Otherwise overlapping objects would jump from
  // side to side.
  constexpr double kSameDepth = 1e-4;
  if (std::abs(touch.depth - other.depth) > kSameDepth * element_size_) return touch.depth < other.depth;
  return approach_of(bodies, touch).dot(touch.normal) < approach_of(bodies, other).dot(other.normal);
}

/// Appends the candidates that lie behind the side that they are listed with.
template <class Candidate, class PlaceOf>
void MicrostepContacts::find_behind(const ExplicitBodies& bodies, std::span<Candidate> candidates, std::size_t first,
                                    PlaceOf place_of, std::vector<Found>& found) const {
  std::array<std::size_t, simd::kDoubleLanes> four{};
  int count = 0;
  const auto look = [&] {
    std::fill(four.begin() + count, four.end(), four[0]);
    const auto side = [&](int lane) -> const Side& { return candidates[four[lane]].side; };
    const auto nodes = [&](int lane) { return bodies.nodes_of_side(side(lane).slot, side(lane).face); };
    const auto place = [&](int lane) {
      const Vec3 point = place_of(candidates[four[lane]]);
      return simd::WideQuad{point[0], point[1], point[2], 0};
    };
    const FourVectors points = simd::side_by_side(place(0), place(1), place(2), place(3));
    const FourBehind four_behind =
        behind(four_sides(bodies, nodes), points,
               DoubleLanes{side(0).deepest, side(1).deepest, side(2).deepest, side(3).deepest});
    for (int lane = 0; lane < count; ++lane) {
      record_gap(candidates[four[lane]], four_behind.clear[lane]);
      if (four_behind.are_behind[lane] == 0) continue;
      const auto& weights = four_behind.weights;
      found.push_back({first + four[lane],
                       {.nodes = nodes(lane),
                        .weights = {weights[0][lane], weights[1][lane], weights[2][lane]},
                        .place = vector_of(points, lane),
                        .normal = vector_of(four_behind.normals, lane),
                        .depth = four_behind.depth[lane]}});
    }
    count = 0;
  };
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (is_clear(candidates[i])) continue;
    four[count++] = i;
    if (count == simd::kDoubleLanes) look();
  }
  if (count > 0) look();
}

/// Finds all candidates behind their sides. `place_of`: returns the position of a candidate.
template <class Candidate, class PlaceOf>
void MicrostepContacts::find_behind(const ExplicitBodies& bodies, std::vector<Candidate>& candidates,
                                    PlaceOf place_of) {
  found_.clear();
  parallel_collect(static_cast<int>(candidates.size()), found_, [&](int begin, int end, std::vector<Found>& found) {
    find_behind(bodies, std::span(candidates).subspan(begin, end - begin), begin, place_of, found);
  });
}

/// Touches the nearest of the sides that one object lies behind.
void MicrostepContacts::touch_nearest(const ExplicitBodies& bodies, std::span<const Found> found) {
  const Found* nearest = &found.front();
  for (const Found& other : found.subspan(1))
    if (is_nearer(bodies, other.touch, nearest->touch)) nearest = &other;
  touches_.push_back(nearest->touch);
}

/// Adds touches of nodes inside a convex part, and of its sample points behind sides.
void MicrostepContacts::touch_convex(const ExplicitBodies& bodies, int index) {
  const std::size_t first_touch = touches_.size();
  touch_inside(bodies, index);
  const Obstacle& obstacle = obstacles_[index];
  std::vector<SampleAndSide>& samples = candidates_[index].samples;
  find_behind(bodies, samples, [&](const SampleAndSide& near) {
    return obstacle.state.pose.to_world(obstacle.solids[near.part].samples[near.sample]);
  });
  for (Found& found : found_) found.touch.obstacle = index;
  const auto same_sample = [&](const Found& a, const Found& b) {
    return samples[a.candidate].part == samples[b.candidate].part &&
           samples[a.candidate].sample == samples[b.candidate].sample;
  };
  for (auto first = found_.begin(); first != found_.end();) {
    const auto last =
        std::find_if(first, found_.end(), [&](const Found& found) { return !same_sample(found, *first); });
    touch_nearest(bodies, {first, last});
    first = last;
  }
  drop_clamps(bodies, first_touch);
}

/// Adds touches of nodes inside a convex part.
void MicrostepContacts::touch_inside(const ExplicitBodies& bodies, int index) {
  const Obstacle& obstacle = obstacles_[index];
  const Pose& pose = obstacle.state.pose;
  for (PartAndNode& near : candidates_[index].nodes) {
    if (is_clear(near)) continue;
    const Vec3 place = bodies.position(near.node);
    const auto [outside, normal] = obstacle.solids[near.part].outermost_face(pose.to_local(place));
    record_gap(near, outside);
    if (outside > 0) continue;
    Touch touch{.nodes = {near.node, near.node, near.node}, .count = 1, .obstacle = index, .place = place};
    touch.normal = -(pose.rotation * normal);
    touch.depth = -outside;
    touches_.push_back(touch);
  }
}

/// Examines touches with one other object, those from `first` on. An object that penetrated a body is behind sides that
/// face away from each other. With both touches it would be clamped, and a vibrating object would be pressed ever
/// tighter. Only the touch on the shorter way out is kept.
void MicrostepContacts::drop_clamps(const ExplicitBodies& bodies, std::size_t first) {
  constexpr double kOpposite = -0.5;  // cosine
  const auto clamp = [&](const Touch& a, const Touch& b) {
    return a.normal.dot(b.normal) < kOpposite && (b.place - a.place).dot(a.normal) < 0 &&
           bodies.body_of_node(a.nodes[0]) == bodies.body_of_node(b.nodes[0]);
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

/// Touches each node with the side of another body that it lies least deep behind.
void MicrostepContacts::touch_bodies(const ExplicitBodies& bodies) {
  find_behind(bodies, pairs_, [&](const NodeAndSide& pair) { return bodies.position(pair.node); });
  for (Found& found : found_) found.touch.other_nodes[0] = pairs_[found.candidate].node, found.touch.other_count = 1;
  std::size_t first_touch = touches_.size();  // first touch of one body
  int body = -1;
  for (auto first = found_.begin(); first != found_.end();) {
    const int node = first->touch.other_nodes[0];
    if (bodies.body_of_node(node) != body) {
      drop_clamps(bodies, first_touch);
      first_touch = touches_.size();
      body = bodies.body_of_node(node);
    }
    const auto last =
        std::find_if(first, found_.end(), [&](const Found& found) { return found.touch.other_nodes[0] != node; });
    touch_nearest(bodies, {first, last});
    first = last;
  }
  drop_clamps(bodies, first_touch);
}

void MicrostepContacts::find_touches(const ExplicitBodies& bodies) {
  touches_.clear();
  for (int i = 0; i < static_cast<int>(obstacles_.size()); ++i)
    obstacles_[i].is_sphere() ? touch_sphere(bodies, i) : touch_convex(bodies, i);
  touch_bodies(bodies);
  for (int i = 0; i < static_cast<int>(obstacles_.size()); ++i) touch_edges(bodies, i);
  touch_edge_pairs(bodies);
  order_.resize(touches_.size());
  std::iota(order_.begin(), order_.end(), 0);
  std::ranges::stable_sort(order_, std::ranges::greater(), [&](int index) { return touches_[index].depth; });
}

}  // namespace griffith::explicit_dynamics
