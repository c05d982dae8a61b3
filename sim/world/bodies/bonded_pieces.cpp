#include "sim/world/bodies/bonded_pieces.h"

#include <algorithm>
#include <ranges>
#include <utility>

#include "sim/geometry/disjoint_sets.h"
#include "sim/mesh/topology.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

std::ptrdiff_t index_in(const Body& body, TetId tet) {
  return std::ranges::lower_bound(body.tets, tet) - body.tets.begin();
}

/// Returns the fraction of the energy of an opened face that its bonds have not taken yet; corners at a front have all
/// of theirs.
double untaken_part(const CohesiveFace& face) {
  double part = 0;
  for (const Bond& bond : face.bonds) part += bond.untaken() / 3;
  return part;
}

/// Counts the part of an opened face whose energy its bonds have not taken as crack area, or not. `sign`: 1 if it is
/// free from now on, −1 if it is held.
void account_held(WorldState& world, const CohesiveFace& face, double sign) {
  account_crack(world, face.face.first, face_of(face.face.first_corners), 2 * sign * untaken_part(face));  // both sides
}

}  // namespace

bool is_held_by_bonds(const WorldState& world, const Body& body) {
  return body.bonded && world.model->scene.simulation.integrator == Integrator::hybrid;
}

bool still_holds(const CohesiveFace& face) { return std::ranges::any_of(face.bonds, &Bond::holds); }

ConnectedParts::ConnectedParts(const WorldState& world, const Body& body)
    : body_(body), tets_(connected_components(world.mesh, body.tets)), part_of_(body.tets.size()) {
  for (std::size_t part = 1; part < tets_.size(); ++part)  // 0 as it is
    for (const TetId tet : tets_[part]) part_of_[index_in(body, tet)] = static_cast<int>(part);
}

int ConnectedParts::of(TetId tet) const { return part_of_[index_in(body_, tet)]; }

BondedPieces::BondedPieces(const WorldState& world) : world_(world) {
  if (world.cohesive_faces.empty()) return;
  faces_.resize(world.bodies.size());
  for (const CohesiveFace& face : world.cohesive_faces)
    if (still_holds(face)) faces_[world.elements.bodies[face.face.first].index()].push_back(&face);
}

std::vector<std::vector<TetId>> BondedPieces::of(const Body& body) const {
  const ConnectedParts connected(world_, body);
  const std::vector<std::vector<TetId>>& parts = connected.tets();
  if (parts.size() == 1 || faces_.empty()) return parts;
  std::vector<std::pair<int, int>> bonded;
  for (const CohesiveFace* known : faces_[body.id.index()])
    if (world_.elements.bodies[known->face.second] == body.id)
      bonded.emplace_back(connected.of(known->face.first), connected.of(known->face.second));
  const std::vector<int> groups = connected_groups(static_cast<int>(parts.size()), bonded);
  std::vector<std::vector<TetId>> pieces(parts.size());
  for (std::size_t part = 0; part < parts.size(); ++part)
    pieces[groups[part]].insert(pieces[groups[part]].end(), parts[part].begin(), parts[part].end());
  std::erase_if(pieces, [](const std::vector<TetId>& piece) { return piece.empty(); });
  for (std::vector<TetId>& piece : pieces) std::ranges::sort(piece);
  return pieces;
}

namespace {

bool is_of_use(const CohesiveFace& face) {
  return still_holds(face) || std::ranges::any_of(face.bonds, &Bond::is_closed);
}

/// True if a corner of both sides of a face is the same place at rest: no longer so where tets have been cut.
bool is_whole(const TetMesh& mesh, const OpenFace& face) {
  return std::ranges::all_of(std::views::iota(0, 3), [&](int i) {
    return mesh.rest_positions[mesh.tets[face.first][face.first_corners[i]]] ==
           mesh.rest_positions[mesh.tets[face.second][face.second_corners[i]]];
  });
}

}  // namespace

void add_cohesive_face(WorldState& world, const CohesiveFace& face) {
  if (!is_of_use(face)) return;
  world.cohesive_faces.push_back(face);
  account_held(world, face, -1);
}

void remove_cohesive_face(WorldState& world, std::ptrdiff_t index) {
  account_held(world, world.cohesive_faces[index], 1);
  world.cohesive_faces.erase(world.cohesive_faces.begin() + index);
}

double open_cohesive_face(WorldState& world, int index, int corner, double opening) {
  CohesiveFace& face = world.cohesive_faces[index];
  account_held(world, face, 1);
  const double taken = open(face.bonds[corner], opening);
  account_held(world, face, -1);
  return taken;
}

bool is_at_front(const TetMesh& mesh, const OpenFace& face, int corner) {
  return mesh.tets[face.first][face.first_corners[corner]] == mesh.tets[face.second][face.second_corners[corner]];
}

void follow_front(WorldState& world) {
  for (CohesiveFace& face : world.cohesive_faces) {
    CohesiveFace now = is_whole(world.mesh, face.face) ? face : CohesiveFace{face.face, {}};
    for (int i = 0; i < 3; ++i)
      if (now.bonds[i].is_closed() && !is_at_front(world.mesh, face.face, i)) now.bonds[i] = {};
    if (untaken_part(now) == untaken_part(face)) continue;
    account_held(world, face, 1);
    account_held(world, now, -1);
    face = now;
  }
  forget_broken_faces(world);
}

void forget_broken_faces(WorldState& world) {
  std::erase_if(world.cohesive_faces, [&](const CohesiveFace& face) { return !is_of_use(face); });
}

void free_cohesive_faces(WorldState& world, const std::vector<bool>& is_freed) {
  std::erase_if(world.cohesive_faces, [&](const CohesiveFace& face) {
    if (!is_freed[face.face.first] && !is_freed[face.face.second]) return false;
    account_held(world, face, 1);
    return true;
  });
}

}  // namespace griffith
