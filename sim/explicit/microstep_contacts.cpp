#include "sim/explicit/microstep_contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "sim/core/parallel.h"
#include "sim/core/sort_unique.h"

namespace griffith::explicit_dynamics {
namespace {

/// Rounds of impulses over all touches of a microstep.
constexpr int kRounds = 4;
/// Fraction of the candidates' reach that objects may use up before they can enter a new crack.
constexpr double kReachOfCracks = 0.25;
/// Number of microsteps for which candidates are listed, within an edge length.
constexpr double kMicrostepsOfCandidates = 24;
/// Edge of the boxes in the search for candidates, in edge lengths of elements, and the number of positions below which
/// sorting does not pay.
constexpr double kGridEdge = 0.5;
constexpr std::size_t kFewPlaces = 64;
/// Work of a candidate in a microstep, half of them being too far away to be examined, of a touch, and of two bonded
/// nodes [µs].
constexpr double kCandidateWork = 0.012, kTouchWork = 0.3, kBondWork = 0.02;

/// Returns the undeformed height of the tet behind a side over it [m].
double height_behind(const ExplicitBodies& bodies, const SurfaceSide& side) {
  const std::array<int, 3> nodes = bodies.nodes_of_side(side.slot, side.face);
  const Vec3 a = bodies.reference(nodes[0]);
  const Vec3 area = (bodies.reference(nodes[1]) - a).cross(bodies.reference(nodes[2]) - a);
  return -area.dot(bodies.reference(bodies.corner(side.slot, side.face)) - a) / area.norm();
}

double grid_edge(std::size_t places, double element_size) {
  return places <= kFewPlaces ? std::numeric_limits<double>::infinity() : kGridEdge * element_size;
}

Eigen::AlignedBox3d box_of(const ExplicitBodies& bodies, const SurfaceSide& side) {
  Eigen::AlignedBox3d box;
  for (const int node : bodies.nodes_of_side(side.slot, side.face)) box.extend(bodies.position(node));
  return box;
}

/// True if an obstacle may be within `margin` of an object in that box: by its bounding sphere, or by its faces if it
/// has none.
bool may_be_near(const Obstacle& obstacle, const Eigen::AlignedBox3d& box, double margin) {
  const Pose& pose = obstacle.state.pose;
  if (std::isfinite(obstacle.radius)) {
    const double reach = obstacle.radius + margin;
    return !(box.squaredExteriorDistance(pose.translation) > reach * reach);
  }
  const Vec3 center = pose.to_local(box.center());
  return std::ranges::any_of(obstacle.solids, [&](const ConvexSolid& part) {
    const auto [outside, normal] = part.outermost_face(center);
    return outside - 0.5 * (pose.rotation * normal).cwiseAbs().dot(box.sizes()) < margin;
  });
}

/// Returns, per family, the box around all others. `boxes`: those around each family.
std::vector<Eigen::AlignedBox3d> boxes_of_others(std::span<const Eigen::AlignedBox3d> boxes) {
  std::vector<Eigen::AlignedBox3d> others(boxes.size());
  Eigen::AlignedBox3d before, after;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    others[i].extend(before);
    before.extend(boxes[i]);
  }
  for (std::size_t i = boxes.size(); i-- > 0;) {
    others[i].extend(after);
    after.extend(boxes[i]);
  }
  return others;
}

}  // namespace

MicrostepContacts::MicrostepContacts(const ExplicitBodies& bodies, std::span<const SurfaceSide> surface,
                                     std::span<const CrackSides> cracks, std::vector<Obstacle> obstacles,
                                     std::vector<SurfaceLaw> surfaces, double element_size)
    : obstacles_(std::move(obstacles)),
      surfaces_(std::move(surfaces)),
      candidates_(obstacles_.size()),
      element_size_(element_size) {
  for (const SurfaceSide& side : surface) add_side(bodies, side);
  for (const CrackSides& crack : cracks) cracks_.push_back({{}, crack});
  catch_up();
}

void MicrostepContacts::add_side(const ExplicitBodies& bodies, const SurfaceSide& side) {
  constexpr double kDeepest = 0.5;  // of the height behind, so that objects beyond a thin sheet are excluded
  surface_.push_back({side, kDeepest * height_behind(bodies, side)});
}

int MicrostepContacts::open(const ExplicitBodies& bodies, const CrackSides& sides) {
  cracks_.push_back({{}, sides});
  const auto add = [&](int slot, const std::array<int, 3>& corners) { add_side(bodies, {slot, face_of(corners)}); };
  add(sides.first_slot, sides.first_corners);
  add(sides.second_slot, sides.second_corners);
  // The new crack is still empty; objects have to get there first.
  listed_until_ = std::min(listed_until_, travelled_ + kReachOfCracks * margin_);
  lists_bonds_ = false;
  return crack_count() - 1;
}

MicrostepContacts::BoxedSurface MicrostepContacts::boxed_surface(const ExplicitBodies& bodies) const {
  std::vector<BoxedSide> sides;
  std::vector<Vec3> centers;
  Vec3 largest = Vec3::Zero();
  for (const Side& side : surface_) {
    const Eigen::AlignedBox3d& box = sides.emplace_back(BoxedSide{box_of(bodies, side), side}).box;
    centers.push_back(box.center());
    largest = largest.cwiseMax(0.5 * box.sizes());
  }
  return {std::move(sides), PointGrid(centers, grid_edge(centers.size(), element_size_)), largest, edge_boxes(bodies)};
}

/// Returns the sides of other families that may be near an obstacle, in the order of the surface.
std::vector<MicrostepContacts::BoxedSide> MicrostepContacts::sides_near(const ExplicitBodies& bodies,
                                                                        const Obstacle& obstacle,
                                                                        const BoxedSurface& surface) const {
  std::vector<BoxedSide> near;
  const auto take = [&](int index) {
    const BoxedSide& side = surface.sides[index];
    if (family_of(bodies, side.side) != obstacle.family && may_be_near(obstacle, side.box, margin_))
      near.push_back(side);
  };
  const Vec3 reach = Vec3::Constant(obstacle.radius + margin_) + surface.largest;
  if (!reach.allFinite()) {
    for (int index = 0; index < static_cast<int>(surface.sides.size()); ++index) take(index);
    return near;
  }
  const Vec3& center = obstacle.state.pose.translation;
  std::vector<int> indices;
  surface.grid.visit({center - reach, center + reach}, [&](int index) { indices.push_back(index); });
  std::ranges::sort(indices);
  std::ranges::for_each(indices, take);
  return near;
}

void MicrostepContacts::list_near_obstacle(const ExplicitBodies& bodies, const Obstacle& obstacle,
                                           const BoxedSurface& surface, Candidates& candidates) const {
  candidates.sides.clear(), candidates.nodes.clear(), candidates.samples.clear(), candidates.edges.clear();
  const std::vector<BoxedSide> sides = sides_near(bodies, obstacle, surface);
  if (obstacle.is_sphere()) {
    for (const BoxedSide& near : sides) candidates.sides.push_back({{}, near.side});
    return;
  }
  std::vector<int> nodes;
  for (const BoxedSide& near : sides)
    for (const int node : bodies.nodes_of_side(near.side.slot, near.side.face)) nodes.push_back(node);
  sort_unique(nodes);
  for (int part = 0; part < static_cast<int>(obstacle.solids.size()); ++part)
    list_near_part(bodies, obstacle, part, sides, nodes, candidates);
  if (!sides.empty() && !obstacle.is_ground()) list_edges_near(bodies, obstacle, surface.edges, candidates);
}

/// Lists, from the sides near an obstacle and their nodes, the nodes near one of its parts, and that part's samples
/// near the sides.
void MicrostepContacts::list_near_part(const ExplicitBodies& bodies, const Obstacle& obstacle, int part,
                                       std::span<const BoxedSide> sides, std::span<const int> nodes,
                                       Candidates& candidates) const {
  const ConvexSolid& convex = obstacle.solids[part];
  for (const int node : nodes)
    if (convex.outermost_face(obstacle.state.pose.to_local(bodies.position(node))).first < margin_)
      candidates.nodes.push_back({{}, part, node});
  for (int sample = 0; sample < static_cast<int>(convex.samples.size()); ++sample) {
    const Vec3 place = obstacle.state.pose.to_world(convex.samples[sample]);
    for (const BoxedSide& near : sides)
      if (near.box.squaredExteriorDistance(place) < margin_ * margin_)
        candidates.samples.push_back({{}, part, sample, near.side});
  }
}

const SurfaceLaw& MicrostepContacts::surface_at(const ExplicitBodies& bodies, int node) const {
  return surfaces_[bodies.body_of_node(node)];
}

int MicrostepContacts::family_of(const ExplicitBodies& bodies, const SurfaceSide& side) const {
  return surfaces_[bodies.body_of_slot(side.slot)].family;
}

/// Returns the listed sides that may be near bodies of other families.
std::vector<MicrostepContacts::BoxedSide> MicrostepContacts::sides_near_others(
    const ExplicitBodies& bodies, std::span<const BoxedSide> surface) const {
  std::vector<int> families;
  for (const SurfaceLaw& law : surfaces_) families.push_back(law.family);
  sort_unique(families);
  if (families.size() < 2) return {};
  const auto index_of = [&](const BoxedSide& boxed) {
    return std::ranges::lower_bound(families, family_of(bodies, boxed.side)) - families.begin();
  };
  std::vector<Eigen::AlignedBox3d> boxes(families.size());
  for (const BoxedSide& boxed : surface) boxes[index_of(boxed)].extend(boxed.box);
  const std::vector<Eigen::AlignedBox3d> others = boxes_of_others(boxes);
  std::vector<BoxedSide> near;
  std::ranges::copy_if(surface, std::back_inserter(near), [&](const BoxedSide& boxed) {
    const Eigen::AlignedBox3d& other = others[index_of(boxed)];
    return !other.isEmpty() && other.squaredExteriorDistance(boxed.box) < margin_ * margin_;
  });
  return near;
}

/// Lists nodes near sides of other bodies.
void MicrostepContacts::list_pairs(const ExplicitBodies& bodies, std::span<const BoxedSide> surface) {
  const std::vector<BoxedSide> sides = sides_near_others(bodies, surface);
  std::vector<int> nodes;
  for (const BoxedSide& boxed : sides)
    for (const int node : bodies.nodes_of_side(boxed.side.slot, boxed.side.face)) nodes.push_back(node);
  sort_unique(nodes);
  std::vector<Vec3> places;
  std::vector<int> families;
  for (const int node : nodes) {
    places.push_back(bodies.position(node));
    families.push_back(surface_at(bodies, node).family);
  }
  const PointGrid grid(places, grid_edge(places.size(), element_size_));
  const Vec3 reach = Vec3::Constant(margin_);
  std::vector<std::pair<int, int>> found;  // pairs of indices into `nodes` and `sides`
  parallel_collect(
      static_cast<int>(sides.size()), found, [&](int begin, int end, std::vector<std::pair<int, int>>& near) {
        for (int i = begin; i < end; ++i) {
          const Eigen::AlignedBox3d& box = sides[i].box;
          const int family = family_of(bodies, sides[i].side);
          grid.visit({box.min() - reach, box.max() + reach}, [&](int index) {
            if (families[index] != family && box.squaredExteriorDistance(places[index]) < margin_ * margin_)
              near.emplace_back(index, i);
          });
        }
      });
  std::vector<int> starts(nodes.size() + 1, 0);
  for (const auto& [index, side] : found) ++starts[index + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  pairs_.resize(found.size());
  for (const auto& [index, side] : found) pairs_[starts[index]++] = {{}, nodes[index], sides[side].side};
}

/// `displacement`: possible approach of two objects in a microstep [m].
void MicrostepContacts::list_candidates(const ExplicitBodies& bodies, double displacement) {
  margin_ = std::clamp(kMicrostepsOfCandidates * displacement, 0.25 * element_size_, element_size_);
  for (const Obstacle& obstacle : obstacles_)
    if (obstacle.may_move() && std::isfinite(obstacle.radius)) margin_ = std::max(margin_, 0.1 * obstacle.radius);
  catch_up();
  find_edges(bodies);
  const BoxedSurface surface = boxed_surface(bodies);
  parallel_for(static_cast<int>(obstacles_.size()), 8, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) list_near_obstacle(bodies, obstacles_[i], surface, candidates_[i]);
  });
  list_pairs(bodies, surface.sides);
  list_edge_pairs(bodies, surface.edges);
  list_grounded();
  listed_until_ = travelled_ + margin_;
}

std::size_t MicrostepContacts::candidate_count() const {
  std::size_t count = pairs_.size() + edge_pairs_.size() + cracks_.size();
  for (const Candidates& near : candidates_)
    count += near.sides.size() + near.nodes.size() + near.samples.size() + near.edges.size();
  return count;
}

double MicrostepContacts::closing_speed(const ExplicitBodies& bodies) const {
  double fastest = bodies.fastest();
  Eigen::AlignedBox3d velocities = bodies.velocities();
  for (const Obstacle& obstacle : obstacles_) {
    const double turning =
        std::isfinite(obstacle.radius) ? obstacle.state.angular_velocity.norm() * obstacle.radius : 0;
    fastest = std::max(fastest, obstacle.state.velocity.norm() + turning);
    velocities.extend(obstacle.state.velocity + Vec3::Constant(turning));
    velocities.extend(obstacle.state.velocity - Vec3::Constant(turning));
  }
  return std::min(2 * fastest, velocities.diagonal().norm());
}

void MicrostepContacts::catch_up() {
  for (Obstacle& obstacle : obstacles_) obstacle.move(0);
}

void MicrostepContacts::resolve(ExplicitBodies& bodies, double dt, double min_speed) {
  recorded_impacts_.clear();
  settle_pushed(bodies, std::exchange(last_dt_, dt));
  hold_cracks(bodies, dt);
  for (std::size_t i = 0; i < obstacles_.size(); ++i)
    candidates_[i].empty() ? obstacles_[i].wait(dt) : obstacles_[i].move(dt);
  const double displacement = dt * closing_speed(bodies);
  travelled_ += displacement;
  if (travelled_ > listed_until_) list_candidates(bodies, displacement);
  find_touches(bodies);
  work_ += kCandidateWork * static_cast<double>(candidate_count()) + kTouchWork * static_cast<double>(touches_.size()) +
           kBondWork * static_cast<double>(bonds_.size());
  bool any = !touches_.empty();
  if (any) touch_ground();
  for (int round = 0; round < kRounds && any; ++round) {
    any = false;
    for (const int index : order_) any |= push(bodies, touches_[index], dt);
    any |= stop_at_ground(bodies, dt);
  }
  if (!touches_.empty())
    travelled_ += std::max(0.0, dt * closing_speed(bodies) - displacement);  // impulses may throw objects back
  record_impacts(min_speed);
  if (!cracks_.empty()) close_cracks(bodies);
  record_pushed(bodies);
}

}  // namespace griffith::explicit_dynamics
