#include "sim/world/bodies/acting_bonds.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "sim/core/sort_unique.h"
#include "sim/core/tet_edge_corners.h"
#include "sim/world/bodies/bonded_pieces.h"

namespace griffith {
namespace {

/// Corner of an opened face with a bond, and its nodes in ascending order.
struct BondedCorner {
  BodyId body;
  NodeId first, second;
  BondedPair::Part part;
};

const Body& body_of(const WorldState& world, const OpenFace& face) {
  return world.bodies[world.elements.bodies[face.first]];
}

std::pair<NodeId, NodeId> nodes_at(const WorldState& world, const OpenFace& face, int corner) {
  const NodeId first = world.mesh->tets[face.first][face.first_corners[corner]],
               second = world.mesh->tets[face.second][face.second_corners[corner]];
  return {std::min(first, second), std::max(first, second)};
}

/// Lists the bonds that hold in bodies that deform, by body and nodes.
std::vector<BondedCorner> bonded_corners(const WorldState& world) {
  std::vector<BondedCorner> corners;
  for (std::size_t i = 0; i < world.cohesive_faces.size(); ++i) {
    const CohesiveFace& known = world.cohesive_faces[i];
    const Body& body = body_of(world, known.face);
    if (!body.is_deformable()) continue;
    for (int corner = 0; corner < 3; ++corner) {
      if (!known.bonds[corner].holds()) continue;
      const auto [first, second] = nodes_at(world, known.face, corner);
      corners.push_back({body.id, first, second, {static_cast<int>(i), corner}});
    }
  }
  std::ranges::stable_sort(corners, {},
                           [](const BondedCorner& at) { return std::tuple(at.body, at.first, at.second); });
  return corners;
}

const Bond& bond_at(const WorldState& world, const BondedPair::Part& part) {
  return world.cohesive_faces[part.face].bonds[part.corner];
}

/// Lists the copies of the edges of an opened face that are tied: until the bonds at both of their ends have broken or,
/// next to a front, until it has passed.
void list_ties(const WorldState& world, const CohesiveFace& known, std::vector<TiedEdges>& ties) {
  const OpenFace& face = known.face;
  const auto is_broken = [&](int i) {
    const auto [first, second] = nodes_at(world, face, i);
    return !known.bonds[i].holds() && first != second;
  };
  const auto& edges = world.tet_edges->of_tet;
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3;
    if (is_broken(i) && is_broken(next)) continue;
    const EdgeId first = edges[face.first][tet_edge(face.first_corners[i], face.first_corners[next])],
                 second = edges[face.second][tet_edge(face.second_corners[i], face.second_corners[next])];
    if (first != second) ties.push_back({std::min(first, second), std::max(first, second)});
  }
}

}  // namespace

double BondedPair::force_up_to(double now) const {
  double force = 0;
  for (const Bond& bond : bonds) force += mean_force(bond, std::max(now, bond.opening));
  return force;
}

bool bonds_act(const WorldState& world) {
  const Scene& scene = world.model->scene;
  return scene.analysis == Analysis::dynamic && scene.simulation.integrator != Integrator::hybrid;
}

std::vector<BondsOfBody> acting_bonds(const WorldState& world) {
  std::vector<BondsOfBody> bonds;
  if (world.cohesive_faces.empty() || !bonds_act(world)) return bonds;
  for (const BondedCorner& at : bonded_corners(world)) {
    if (bonds.empty() || bonds.back().body != at.body) bonds.push_back({at.body, {}, {}});
    std::vector<BondedPair>& pairs = bonds.back().pairs;
    if (pairs.empty() || pairs.back().first != at.first || pairs.back().second != at.second)
      pairs.push_back({at.first, at.second, {}, {}});
    pairs.back().parts.push_back(at.part);
    pairs.back().bonds.push_back(bond_at(world, at.part));
    pairs.back().opening = std::max(pairs.back().opening, bond_at(world, at.part).opening);
  }
  for (const CohesiveFace& known : world.cohesive_faces) {
    const Body& body = body_of(world, known.face);
    if (!body.is_deformable() || body.edges.empty()) continue;
    auto of = std::ranges::lower_bound(bonds, body.id, {}, &BondsOfBody::body);
    if (of == bonds.end() || of->body != body.id) of = bonds.insert(of, {body.id, {}, {}});
    list_ties(world, known, of->ties);
  }
  for (BondsOfBody& of : bonds) sort_unique(of.ties);
  return bonds;
}

std::vector<HeldNode> held_nodes(const WorldState& world) {
  constexpr double kOfLargest = 0.999;
  if (world.cohesive_faces.empty() || !bonds_act(world)) return {};
  std::vector<HeldNode> held(world.nodes.positions.size(), {0, 0});
  std::vector<double> areas(held.size(), 0);
  for (const CohesiveFace& known : world.cohesive_faces) {
    const double third = third_of_face(world.mesh, known.face.first, known.face.first_corners).norm();
    for (int i = 0; i < 3; ++i) {
      const auto [first, second] = nodes_at(world, known.face, i);
      const Bond& bond = known.bonds[i];
      const double opening = (world.nodes.positions[second] - world.nodes.positions[first]).norm();
      for (const NodeId node : {first, second}) {
        areas[node] += third;
        held[node].taken += third * (1 - bond.untaken());
        if (bond.holds() && opening >= kOfLargest * bond.opening) held[node].traction += bond.strength();
      }
    }
  }
  for (std::size_t i = 0; i < held.size(); ++i)
    held[i] = areas[i] > 0 ? HeldNode{held[i].traction / areas[i], held[i].taken / areas[i]} : HeldNode();
  return held;
}

std::vector<bool> bodies_with_bonds(const WorldState& world) {
  std::vector<bool> has_bonds(world.bodies.size(), false);
  if (!bonds_act(world)) return has_bonds;
  for (const CohesiveFace& known : world.cohesive_faces)
    if (still_holds(known)) has_bonds[body_of(world, known.face).id.index()] = true;
  return has_bonds;
}

void open_bonds(WorldState& world) {
  for (const BondsOfBody& of : acting_bonds(world)) {
    bool breaks = false;
    for (const BondedPair& pair : of.pairs) {
      const double opening = (world.nodes.positions[pair.second] - world.nodes.positions[pair.first]).norm();
      if (opening <= pair.opening) continue;
      for (const BondedPair::Part& part : pair.parts) {
        const double taken = open_cohesive_face(world, part.face, part.corner, opening);
        world.energy.fracture += taken;
        world.energy.contacts -= taken;
        breaks |= !bond_at(world, part).holds();
      }
    }
    if (breaks) world.scratch.bonds_broke_in.push_back(of.body);
  }
  if (!world.scratch.bonds_broke_in.empty()) forget_broken_faces(world);
}

}  // namespace griffith
