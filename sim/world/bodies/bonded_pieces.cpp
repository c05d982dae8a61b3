#include "sim/world/bodies/bonded_pieces.h"

#include <algorithm>
#include <utility>

#include "sim/fracture/cohesion.h"
#include "sim/geometry/disjoint_sets.h"
#include "sim/mesh/topology.h"
#include "sim/world/fracture/fracture_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Returns the part of each tet of a body, in the order of its tets.
std::vector<int> part_of_tets(const Body& body, const std::vector<std::vector<TetId>>& parts) {
  std::vector<int> part_of(body.tets.size());
  for (std::size_t part = 0; part < parts.size(); ++part)
    for (const TetId tet : parts[part])
      part_of[std::ranges::lower_bound(body.tets, tet) - body.tets.begin()] = static_cast<int>(part);
  return part_of;
}

/// Returns the pairs of a body's parts between which bonds hold.
std::vector<std::pair<int, int>> bonded_parts(const WorldState& world, const Body& body,
                                              const std::vector<std::vector<TetId>>& parts) {
  const std::vector<int> part_of = part_of_tets(body, parts);
  const auto part_at = [&](TetId tet) { return part_of[std::ranges::lower_bound(body.tets, tet) - body.tets.begin()]; };
  std::vector<std::pair<int, int>> bonded;
  for (const CohesiveFace& known : world.cohesive_faces) {
    const auto [first, second] = std::pair(known.face.first, known.face.second);
    if (world.elements.bodies[first] != body.id || world.elements.bodies[second] != body.id) continue;
    if (std::ranges::any_of(known.bonds, &Bond::holds)) bonded.emplace_back(part_at(first), part_at(second));
  }
  return bonded;
}

bool has_bonds(const WorldState& world, const Body& body) {
  return std::ranges::any_of(world.cohesive_faces, [&](const CohesiveFace& face) {
    return world.elements.bodies[face.face.first] == body.id;
  });
}

}  // namespace

std::vector<std::vector<TetId>> bonded_pieces(const WorldState& world, const Body& body) {
  const std::vector<std::vector<TetId>> parts = connected_components(world.mesh, body.tets);
  if (parts.size() == 1 || world.cohesive_faces.empty()) return parts;
  const std::vector<int> groups = connected_groups(static_cast<int>(parts.size()), bonded_parts(world, body, parts));
  std::vector<std::vector<TetId>> pieces(parts.size());
  for (std::size_t part = 0; part < parts.size(); ++part)
    pieces[groups[part]].insert(pieces[groups[part]].end(), parts[part].begin(), parts[part].end());
  std::erase_if(pieces, [](const std::vector<TetId>& piece) { return piece.empty(); });
  for (std::vector<TetId>& piece : pieces) std::ranges::sort(piece);
  return pieces;
}

void drop_bonds(WorldState& world, const Body& body) {
  std::erase_if(world.cohesive_faces,
                [&](const CohesiveFace& face) { return world.elements.bodies[face.face.first] == body.id; });
}

void part_at_bonds(WorldState& world) {
  Opened opened;
  opened.first_event = world.crack_events.size();
  for (const Body& body : world.bodies) {
    if (!body.bonded || body.explicit_state || (body.rigid && has_bonds(world, body))) continue;
    drop_bonds(world, body);
    opened.bodies.insert(body.id);
  }
  if (!opened.bodies.empty()) part_opened(world, opened);
}

}  // namespace griffith
