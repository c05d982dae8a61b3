#include "sim/world/bodies/supported_motion.h"

#include <algorithm>

namespace griffith {

std::optional<Pivot> pivot_of(const WorldState& world, const Body& body) {
  return pivot_of(body.system->supports(), world.nodes.constraints, world.nodes.positions);
}

bool is_driven(const WorldState& world, const Body& body) {
  return std::ranges::any_of(body.system->supports(),
                             [&](NodeId node) { return !world.nodes.constraints[node].velocity.isZero(0); });
}

bool is_guided(const WorldState& world, const Body& body) {
  if (!body.supported()) return false;
  const std::optional<Pivot> pivot = pivot_of(world, body);
  return count_free_motions(body.system->supports(), world.nodes.constraints, world.nodes.positions) >
         (pivot ? static_cast<int>(pivot->axes.cols()) : 0);
}

}  // namespace griffith
