#include "sim/world/bodies/bonded_pieces.h"

#include <algorithm>

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

/// Calls `visit(first, second, face)` for each cohesive face between two parts of a body.
template <class Visit>
void each_bond_between(const WorldState& world, const Body& body, const std::vector<std::vector<TetId>>& parts,
                       const Visit& visit) {
  const std::vector<int> part_of = part_of_tets(body, parts);
  const auto part_at = [&](TetId tet) {
    const auto found = std::ranges::lower_bound(body.tets, tet);
    return found == body.tets.end() || *found != tet ? -1 : part_of[found - body.tets.begin()];
  };
  for (const CohesiveFace& known : world.cohesive_faces) {
    const int first = part_at(known.face.first), second = part_at(known.face.second);
    if (first >= 0 && second >= 0 && first != second) visit(first, second, known);
  }
}

}  // namespace

std::vector<std::vector<TetId>> bonded_pieces(const WorldState& world, const Body& body) {
  std::vector<std::vector<TetId>> parts = connected_components(world.mesh, body.tets);
  if (parts.size() == 1 || world.cohesive_faces.empty()) return parts;
  DisjointSets sets(static_cast<int>(parts.size()));
  each_bond_between(world, body, parts, [&](int first, int second, const CohesiveFace& face) {
    if (std::ranges::any_of(face.bonds, &Bond::holds)) sets.join(first, second);
  });
  std::vector<std::vector<TetId>> pieces;
  std::vector<int> piece_of(parts.size(), -1);
  for (int part = 0; part < static_cast<int>(parts.size()); ++part) {
    int& piece = piece_of[sets.find(part)];
    if (piece < 0) {
      piece = static_cast<int>(pieces.size());
      pieces.emplace_back();
    }
    pieces[piece].insert(pieces[piece].end(), parts[part].begin(), parts[part].end());
  }
  for (std::vector<TetId>& piece : pieces) std::ranges::sort(piece);
  return pieces;
}

void part_at_bonds(WorldState& world) {
  Opened opened;
  opened.first_event = world.crack_events.size();
  for (const Body& body : world.bodies)
    if (body.bonded && !body.rigid && !body.explicit_state) opened.bodies.insert(body.id);
  if (opened.bodies.empty()) return;
  std::erase_if(world.cohesive_faces, [&](const CohesiveFace& face) {
    return opened.bodies.contains(world.elements.bodies[face.face.first]);
  });
  part_opened(world, opened);
}

}  // namespace griffith
