#include <algorithm>

#include "sim/core/sort_unique.h"
#include "sim/core/tet_edge_corners.h"
#include "sim/elasticity/quadratic_frequency.h"
#include "sim/explicit/explicit_bodies.h"

namespace griffith::explicit_dynamics {

RestElement ExplicitBodies::rest_element(int slot) const {
  const ElementBlock& block = blocks_[slot / kLanes];
  const int lane = slot % kLanes;
  RestElement rest{Corners::Zero(), block.volume[lane]};
  for (int corner = 0; corner < 3; ++corner)
    for (int i = 0; i < 3; ++i) rest.shape_gradients(i, corner + 1) = block.gradients[corner][i][lane];
  rest.shape_gradients.col(0) = -rest.shape_gradients.rightCols<3>().rowwise().sum();
  return rest;
}

int ExplicitBodies::slot_of_edge_entry(int entry) const {
  return kLanes * block_of_quadratic_[entry / 6 / kLanes] + entry / 6 % kLanes;
}

/// Returns the bounding_frequency() of a quadratic tet with the present stars of its nodes and edges [rad/s].
double ExplicitBodies::bounding_frequency(int slot) const {
  const ExplicitBody& body = bodies_[body_of_slot(slot)];
  std::array<double, 4> corners;
  std::array<double, 6> edges;
  for (int i = 0; i < 4; ++i) {
    NodeStiffness sums;
    for (const int entry : star(corner(slot, i))) add_corner_stiffness(rest_element(entry / 4), entry % 4, sums);
    corners[i] = sums.ratio();
  }
  for (int i = 0; i < 6; ++i) {
    NodeStiffness sums;
    const ExplicitEdge& edge = edges_[quadratics_[quadratic_of_block_[slot / kLanes]].edges[i][slot % kLanes]];
    for (int e = edge.first; e < edge.first + edge.count; ++e)
      add_edge_stiffness(rest_element(slot_of_edge_entry(edge_stars_[e])), edge_stars_[e] % 6, sums);
    edges[i] = sums.ratio();
  }
  const ElasticLaw law{body.law.model, body.law.lambda, body.law.mu};
  return griffith::bounding_frequency(law, body.density, rest_element(slot), corners, edges);
}

bool ExplicitBodies::raise_frequencies() {
  sort_unique(parted_);
  bool raised = false;
  for (const int slot : parted_) {
    double& highest = bodies_[body_of_slot(slot)].frequency;
    const double frequency = bounding_frequency(slot) / kFewOverMost;
    raised |= frequency > highest;
    highest = std::max(highest, frequency);
  }
  parted_.clear();
  return raised;
}

}  // namespace griffith::explicit_dynamics
