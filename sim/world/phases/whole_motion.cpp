#include "sim/world/phases/whole_motion.h"

#include <utility>

#include "sim/world/bodies/bodies.h"

namespace griffith {

WholeMotion whole_motion(const WorldState& world, const Body& body, double dt) {
  const std::optional<Pivot> pivot = pivot_of(world, body);
  if (body.supported() && !pivot) return {};
  const std::span<const NodeId> nodes = body.system->nodes();
  Eigen::VectorXd masses(static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t row = 0; row < nodes.size(); ++row) masses[row] = world.nodes.masses[nodes[row]];
  NodeVectors places = body.system->gather(world.nodes.positions, world.edges.offsets);
  WholeMotion whole = pivot ? swinging_motion(std::move(places), std::move(masses), *pivot)
                            : free_motion(std::move(places), std::move(masses));
  whole.damping = 1 + dt * world.material_of(body).mass_damping;
  return whole;
}

}  // namespace griffith
