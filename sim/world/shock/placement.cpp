#include "sim/world/shock/placement.h"

#include "sim/elasticity/polar_decomposition.h"

namespace griffith {

Placement placement_of(const WorldState& world, const std::vector<NodeId>& nodes) {
  Placement placement;
  double mass = 0;
  for (const NodeId node : nodes) {
    mass += world.nodes.masses[node];
    placement.center += world.nodes.masses[node] * world.nodes.positions[node];
    placement.rest_center += world.nodes.masses[node] * world.mesh.rest_positions[node];
  }
  placement.center /= mass, placement.rest_center /= mass;
  Mat3 correlation = Mat3::Zero();
  for (const NodeId node : nodes)
    correlation += world.nodes.masses[node] * (world.nodes.positions[node] - placement.center) *
                   (world.mesh.rest_positions[node] - placement.rest_center).transpose();
  placement.turn = polar_rotation(correlation / correlation.norm());
  return placement;
}

}  // namespace griffith
