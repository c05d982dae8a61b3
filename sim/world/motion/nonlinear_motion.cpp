#include "sim/world/motion/deformation.h"
#include "sim/world/motion/motion_phase.h"

namespace griffith {

bool move_nonlinearly(WorldState& world, Body& body, const BodySnapshot& before, const std::vector<Vec3>& external,
                      double dt) {
  const NodeVectors moved = body.system->gather(world.nodes.positions, world.edges.offsets);
  move_without_deforming(world, body, before, external, dt);
  const NodeVectors start = body.system->gather(world.nodes.positions, world.edges.offsets);
  Deformation deformation(world, body, before, start, dt);
  deformation.set_load(external, body.system->gather(world.nodes.velocities, world.edges.velocities));
  const bool converged = deformation.minimize((moved - start) / dt);
  const NodeVectors& e = deformation.deforming();
  const std::span<const NodeId> nodes = body.system->nodes();
  const std::span<const EdgeId> edges = body.system->edges();
  for (std::size_t i = 0; i < nodes.size(); ++i) world.nodes.velocities[nodes[i]] += e.col(i);
  for (std::size_t i = 0; i < edges.size(); ++i) world.edges.velocities[edges[i]] += e.col(nodes.size() + i);
  restore_angular_momentum(world, body, before);
  return converged;
}

}  // namespace griffith
