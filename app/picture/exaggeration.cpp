#include "app/picture/exaggeration.h"

#include "sim/elasticity/placement.h"

namespace griffith::app {
namespace {

constexpr double kHeldWeight = 1e8;  // weight of a held node; a free one has 1

double fit_weight(const Frame& frame, NodeId node) {
  if (!frame.nodes.positions[node].allFinite()) return 0;
  return frame.nodes.constraints[node].is_held() ? kHeldWeight : 1;
}

BodyId piece_of(const Frame& frame, NodeId node) {
  const std::vector<TetId>& star = frame.nodes.stars[node];
  return star.empty() ? BodyId() : frame.elements.bodies[star.front()];
}

/// Returns the rigid placement of each body from which its deformation is measured; undefined for a body without nodes.
std::vector<Placement> placements_of(const Frame& frame) {
  std::vector<std::vector<NodeId>> nodes(frame.bodies.size());
  std::vector<double> weights;
  for (const NodeId node : IdRange<NodeId>(0, std::ssize(frame.nodes.positions))) {
    weights.push_back(fit_weight(frame, node));
    if (const BodyId piece = piece_of(frame, node); piece.valid() && weights.back() > 0) nodes[piece].push_back(node);
  }
  std::vector<Placement> placements;
  for (const std::vector<NodeId>& of_body : nodes)
    placements.push_back(best_placement(frame.nodes.rest_positions, frame.nodes.positions, weights, of_body));
  return placements;
}

}  // namespace

std::vector<Vec3> exaggerated_positions(const Frame& frame, double factor) {
  std::vector<Vec3> positions(frame.nodes.positions.begin(), frame.nodes.positions.end());
  if (factor == 1) return positions;
  const std::vector<Placement> placements = placements_of(frame);
  for (const NodeId node : IdRange<NodeId>(0, std::ssize(positions))) {
    const BodyId piece = piece_of(frame, node);
    if (!piece.valid() || !positions[node].allFinite()) continue;
    const Vec3 rigid = placements[piece].to_world(frame.nodes.rest_positions[node]);
    positions[node] = rigid + factor * (positions[node] - rigid);
  }
  return positions;
}

}  // namespace griffith::app
