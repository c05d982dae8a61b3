#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>

#include "sim/explicit/microstep_contacts.h"

namespace griffith::explicit_dynamics {
namespace {

/// Largest overlap of edges, as a fraction of the shorter one: impulses stop edges where they meet.
constexpr double kDeepest = 0.05;

Eigen::AlignedBox3d box_of(const Vec3& from, const Vec3& to) {
  Eigen::AlignedBox3d box(from);
  return box.extend(to);
}

double deepest_of(const SharpEdge& first, const SharpEdge& second) {
  return kDeepest * std::min(first.length(), second.length());
}

template <class Place>
Vec3 normal_of(const std::array<int, 3>& nodes, Place place) {
  const Vec3 a = place(nodes[0]);
  return Vec3((place(nodes[1]) - a).cross(place(nodes[2]) - a)).normalized();
}

}  // namespace

/// True if bodies may touch each other.
bool MicrostepContacts::has_families() const {
  return std::ranges::any_of(surfaces_, [&](const SurfaceLaw& law) { return law.family != surfaces_[0].family; });
}

/// Finds the sharp convex edges of the surface if it has grown. Alone on the ground or under a sphere they touch no
/// other.
void MicrostepContacts::find_edges(const ExplicitBodies& bodies) {
  const auto has_edges = [](const ConvexSolid& solid) { return !solid.edges.empty(); };
  const bool any = has_families() || std::ranges::any_of(obstacles_, [&](const Obstacle& obstacle) {
                     return std::ranges::any_of(obstacle.solids, has_edges);
                   });
  if (!any || std::exchange(sides_with_edges_, surface_.size()) == surface_.size()) return;
  edges_.clear();
  std::map<std::pair<int, int>, std::vector<std::array<int, 3>>> sides;
  for (const Side& side : surface_) {
    const std::array<int, 3> nodes = bodies.nodes_of_side(side.slot, side.face);
    for (int i = 0; i < 3; ++i) sides[std::minmax(nodes[i], nodes[(i + 1) % 3])].push_back(nodes);
  }
  const auto reference = [&](int node) { return bodies.reference(node); };
  for (const auto& [ends, of_edge] : sides) {
    if (of_edge.size() != 2) continue;
    const Vec3 first = normal_of(of_edge[0], reference), second = normal_of(of_edge[1], reference);
    const auto opposite = std::ranges::find_if(
        of_edge[1], [&ends = ends](int node) { return node != ends.first && node != ends.second; });
    const bool is_convex = first.dot(reference(*opposite) - reference(ends.first)) < 0;
    if (is_convex && are_sharp(first, second)) edges_.push_back({{ends.first, ends.second}, {of_edge[0], of_edge[1]}});
  }
}

/// Returns an edge where it is now.
SharpEdge MicrostepContacts::sharp_edge(const ExplicitBodies& bodies, const SurfaceEdge& edge) const {
  const auto position = [&](int node) { return bodies.position(node); };
  return {{position(edge.nodes[0]), position(edge.nodes[1])},
          {normal_of(edge.sides[0], position), normal_of(edge.sides[1], position)}};
}

/// Returns the boxes of the edges where they are now.
std::vector<Eigen::AlignedBox3d> MicrostepContacts::edge_boxes(const ExplicitBodies& bodies) const {
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(edges_.size());
  for (const SurfaceEdge& edge : edges_)
    boxes.push_back(box_of(bodies.position(edge.nodes[0]), bodies.position(edge.nodes[1])));
  return boxes;
}

/// Lists the edges of the bodies of other families, in these `boxes`, near those of an obstacle.
void MicrostepContacts::list_edges_near(const ExplicitBodies& bodies, const Obstacle& obstacle,
                                        std::span<const Eigen::AlignedBox3d> boxes, Candidates& candidates) const {
  const Pose& pose = obstacle.state.pose;
  const double reach = obstacle.radius + margin_;
  for (int edge = 0; edge < static_cast<int>(boxes.size()); ++edge) {
    if (boxes[edge].squaredExteriorDistance(pose.translation) > reach * reach ||
        surface_at(bodies, edges_[edge].nodes[0]).family == obstacle.family)
      continue;
    for (int part = 0; part < static_cast<int>(obstacle.solids.size()); ++part) {
      const std::vector<SharpEdge>& of_part = obstacle.solids[part].edges;
      for (int other = 0; other < static_cast<int>(of_part.size()); ++other) {
        const auto& [first, second] = of_part[other].ends;
        if (box_of(pose.to_world(first), pose.to_world(second)).squaredExteriorDistance(boxes[edge]) <
            margin_ * margin_)
          candidates.edges.push_back({{}, part, other, edge});
      }
    }
  }
}

/// Lists pairs of near edges of different families, in these `boxes`.
void MicrostepContacts::list_edge_pairs(const ExplicitBodies& bodies, std::span<const Eigen::AlignedBox3d> boxes) {
  edge_pairs_.clear();
  if (!has_families()) return;
  std::vector<Vec3> centers;
  std::vector<int> families;
  Vec3 largest = Vec3::Zero();
  for (int edge = 0; edge < static_cast<int>(boxes.size()); ++edge) {
    centers.push_back(boxes[edge].center());
    families.push_back(surface_at(bodies, edges_[edge].nodes[0]).family);
    largest = largest.cwiseMax(0.5 * boxes[edge].sizes());
  }
  const PointGrid grid(centers, element_size_);
  const Vec3 reach = largest + Vec3::Constant(margin_);
  for (int edge = 0; edge < static_cast<int>(boxes.size()); ++edge)
    grid.visit({boxes[edge].min() - reach, boxes[edge].max() + reach}, [&](int other) {
      if (other < edge && families[other] != families[edge] &&
          boxes[edge].squaredExteriorDistance(boxes[other]) < margin_ * margin_)
        edge_pairs_.push_back({{}, edge, other});
    });
}

/// Returns the touch of an edge of the bodies, the first of a contact, without its other side.
MicrostepContacts::Touch MicrostepContacts::edge_touch(const SurfaceEdge& edge, const SharpEdge& present,
                                                       const EdgeContact& contact) const {
  const double along = contact.along[0];
  Touch touch{.nodes = {edge.nodes[0], edge.nodes[1], edge.nodes[0]}, .weights = {1 - along, along, 0}, .count = 2};
  touch.place = present.ends[0] + along * (present.ends[1] - present.ends[0]);
  touch.normal = contact.normal;
  touch.depth = contact.depth;
  return touch;
}

/// Adds touches of edges of the bodies and of an obstacle.
void MicrostepContacts::touch_edges(const ExplicitBodies& bodies, int index) {
  const Obstacle& obstacle = obstacles_[index];
  const Pose& pose = obstacle.state.pose;
  for (PartAndEdge& near : candidates_[index].edges) {
    if (is_clear(near)) continue;
    const SurfaceEdge& edge = edges_[near.edge];
    const SharpEdge present = sharp_edge(bodies, edge), &local = obstacle.solids[near.part].edges[near.of_part];
    const SharpEdge other = {{pose.to_world(local.ends[0]), pose.to_world(local.ends[1])},
                             {pose.rotation * local.normals[0], pose.rotation * local.normals[1]}};
    const EdgeTest test = test_edges(present, other, deepest_of(present, other));
    record_gap(near, test.clear);
    if (!test.contact) continue;
    touches_.push_back(edge_touch(edge, present, *test.contact));
    touches_.back().obstacle = index;
  }
}

/// Adds touches of edges of different bodies.
void MicrostepContacts::touch_edge_pairs(const ExplicitBodies& bodies) {
  for (EdgePair& pair : edge_pairs_) {
    if (is_clear(pair)) continue;
    const SurfaceEdge &edge = edges_[pair.first], &other = edges_[pair.second];
    const SharpEdge present = sharp_edge(bodies, edge), present_other = sharp_edge(bodies, other);
    const EdgeTest test = test_edges(present, present_other, deepest_of(present, present_other));
    record_gap(pair, test.clear);
    if (!test.contact) continue;
    Touch& touch = touches_.emplace_back(edge_touch(edge, present, *test.contact));
    touch.other_nodes = other.nodes;
    touch.other_weights = {1 - test.contact->along[1], test.contact->along[1]};
    touch.other_count = 2;
  }
}

}  // namespace griffith::explicit_dynamics
