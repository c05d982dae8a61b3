#include "sim/world/regime/part_at_bonds.h"

#include <algorithm>
#include <vector>

#include "sim/mesh/topology.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/bonded_pieces.h"
#include "sim/world/fracture/fracture_phase.h"
#include "sim/world/regime/regime_change.h"
#include "sim/world/regime/torn_bonds.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Marks the tets of the parts of a body that have to deform: those with supports, or all if there are none.
void mark_deformable_parts(const WorldState& world, const Body& body, std::vector<bool>& marked) {
  for (const std::vector<TetId>& part : connected_components(world.mesh, body.tets)) {
    const auto is_held = [&](NodeId node) { return world.nodes.has_support[node] != 0; };
    const bool deforms = !body.supported() || std::ranges::any_of(nodes_of(world.mesh, part), is_held);
    for (const TetId tet : part) marked[tet] = deforms;
  }
}

bool is_parted(const Body& body) { return body.bonded && body.is_deformable(); }

}  // namespace

void part_at_bonds(WorldState& world) {
  if (std::ranges::none_of(world.bodies, is_parted)) return;
  Opened opened;
  opened.first_event = world.crack_events.size();
  std::vector<bool> is_freed(world.mesh->tets.size());
  for (const Body& body : world.bodies) {
    if (!is_parted(body)) continue;
    mark_deformable_parts(world, body, is_freed);
    opened.bodies.insert(body.id);
  }
  free_cohesive_faces(world, is_freed);
  part_opened(world, opened);
  std::vector<BodyId> parted;
  for (const Body& body : world.bodies)
    if (is_parted(body)) parted.push_back(body.id);
  for (const BodyId id : part_at_torn_bonds(world, parted))
    if (is_parted(world.bodies[id])) stop_vibration(world, world.bodies[id]);
}

}  // namespace griffith
