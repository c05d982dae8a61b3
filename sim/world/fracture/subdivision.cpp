#include "sim/world/fracture/subdivision.h"

#include <algorithm>
#include <limits>
#include <set>

#include "sim/mesh/topology.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/quadratic_states.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/state/corners.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Appends a half of an element, with the same deformation gradient and all that follows from it.
void append_element(WorldState& world, const TetBisection& halves) {
  ElementArrays& elements = world.elements;
  elements.append_copy(halves.tet);
  const int faces = elements.first_surface[halves.tet], outer = 1 << halves.kept, inner = 1 << halves.moved;
  std::vector<std::uint8_t>& first_surface = elements.first_surface.edit();
  first_surface[halves.child] = static_cast<std::uint8_t>(faces & ~inner);
  first_surface[halves.tet] = static_cast<std::uint8_t>(faces & ~outer);
  std::vector<OpenedFaces>& opened = elements.opened.edit();
  opened[halves.child][halves.moved] = opened[halves.tet][halves.kept] = kNeverOpened;
  world.bodies[elements.bodies[halves.tet]].tets.push_back(halves.child);
}

double kinetic_energy_of(const WorldState& world, const auto& nodes) {
  double energy = 0;
  for (const NodeId node : nodes) energy += 0.5 * world.nodes.masses[node] * world.nodes.velocities[node].squaredNorm();
  return energy;
}

/// Appends the node on a bisected edge and, if its tets are quadratic, their edges. All have the values that the field
/// has there.
void append_node(WorldState& world, const EdgeNode& node, std::span<const TetBisection> halves) {
  world.nodes.append_between(node);
  if (!world.tet_edges->is_quadratic(halves.front().tet)) return;
  const BisectedEdges edges = bisect_edges(node, halves, world.tet_edges.edit());
  for (const EdgePart& part : edges.parts) world.edges.append_part(part);
  const double bend = 4 * node.weight * (1 - node.weight);
  world.nodes.positions.back() += bend * world.edges.offsets[edges.bisected];
  world.nodes.velocities.back() += bend * world.edges.velocities[edges.bisected];
  for (const TetBisection& half : halves) world.elements.share_point_strains(half, node.weight);
}

/// Updates the states of quadratic tets of a body.
void update_quadratic_states(WorldState& world, std::span<const TetId> tets) {
  const Body& body = world.bodies[world.elements.bodies[tets.front()]];
  ElementArrays& elements = world.elements;
  find_quadratic_states(world, body, tets, [&](TetId tet, const QuadraticStates& found) {
    elements.states.edit()[tet] = found.mean;
    elements.quadratic_states.edit()[tet] = found.state;
    elements.stresses.edit()[tet] = found.mean_cauchy_stress;
  });
}

/// Returns all tets of a subdivision.
std::vector<TetId> tets_of(const Subdivision& subdivision) {
  std::set<TetId> tets;
  for (const TetBisection& halves : subdivision.tets) tets.insert({halves.tet, halves.child});
  return {tets.begin(), tets.end()};
}

/// Corners or faces of tets.
using Places = std::set<std::pair<TetId, int>>;

/// Returns the two corners common to both halves.
std::array<int, 2> common_corners(const TetBisection& halves) {
  std::array<int, 2> common{};
  for (int corner = 0, i = 0; corner < 4; ++corner)
    if (corner != halves.kept && corner != halves.moved) common[i++] = corner;
  return common;
}

/// Keeps the nodes, wherever their corners are now.
void follow_nodes(Places& places, const TetBisection& halves) {
  if (places.erase({halves.tet, halves.moved}) > 0) places.insert({halves.child, halves.moved});
}

/// Updates places that are all corners at the same nodes.
void follow_stars(Places& places, const TetBisection& halves) {
  follow_nodes(places, halves);
  for (int corner : common_corners(halves))
    if (places.contains({halves.tet, corner})) places.insert({halves.child, corner});
}

/// Updates places that are all corners at the nodes of a region, which includes the midpoint of an edge between two of
/// them.
void follow_region(Places& places, const TetBisection& halves) {
  const bool edge = places.contains({halves.tet, halves.kept}) && places.contains({halves.tet, halves.moved});
  follow_stars(places, halves);
  if (edge) places.insert({{halves.tet, halves.moved}, {halves.child, halves.kept}});
}

/// Updates faces: the one opposite the moved end stays, the one opposite the kept end goes to the child, two are
/// halved.
void follow_faces(Places& places, const TetBisection& halves) {
  if (places.erase({halves.tet, halves.kept}) > 0) places.insert({halves.child, halves.kept});
  for (int face : common_corners(halves))
    if (places.contains({halves.tet, face})) places.insert({halves.child, face});
}

/// Updates the corners at bisected tets; the others stay.
template <class Follow>
void follow_all(std::vector<TetCorner>& corners, const Subdivision& subdivision, Follow follow) {
  std::set<TetId> halved;
  for (const TetBisection& halves : subdivision.tets) halved.insert(halves.tet);
  Places places;
  std::erase_if(corners, [&](const TetCorner& corner) {
    return halved.contains(corner.tet) && places.insert({corner.tet, corner.corner}).second;
  });
  for (const TetBisection& halves : subdivision.tets) follow(places, halves);
  for (const auto& [tet, corner] : places) corners.push_back({tet, corner});
}

/// Updates a point in a tet that is now several: it is in the one that leaves it most room.
void follow_point(const WorldState& world, const Subdivision& subdivision, MaterialPoint& point) {
  std::vector<TetId> parts = {point.tet};
  for (const TetBisection& halves : subdivision.tets)
    if (std::ranges::find(parts, halves.tet) != parts.end()) parts.push_back(halves.child);
  if (parts.size() == 1) return;
  double most = -std::numeric_limits<double>::infinity();
  for (const TetId tet : parts) {
    const Vec3 arm = point.rest_position - world.mesh->rest_positions[world.mesh->tets[tet][0]];
    const Vec3 weights = world.elements.rest_elements[tet].shape_gradients.rightCols<3>().transpose() * arm;
    const double room = std::min(weights.minCoeff(), 1 - weights.sum());
    if (room <= most) continue;
    most = room;
    point.tet = tet;
    point.weights = weights;
  }
}

void follow_load(PlacedLoad& placed, const Subdivision& subdivision) {
  follow_all(placed.corners, subdivision, follow_nodes);
  std::vector<TetCorner> faces;
  for (const SurfaceFace& face : placed.faces) faces.push_back({face.tet, face.face});
  follow_all(faces, subdivision, follow_faces);
  placed.faces.clear();
  for (const TetCorner& face : faces) placed.faces.push_back({face.tet, face.corner});
  std::set<TetId> tets(placed.tets.begin(), placed.tets.end());
  for (const TetBisection& halves : subdivision.tets)
    if (tets.contains(halves.tet)) tets.insert(halves.child);
  placed.tets.assign(tets.begin(), tets.end());
}

void follow_probe(ProbedNode& probed, const Subdivision& subdivision) {
  for (const TetBisection& halves : subdivision.tets)
    if (probed.corner.tet == halves.tet && probed.corner.corner == halves.moved) probed.corner.tet = halves.child;
  follow_all(probed.star, subdivision, follow_stars);
}

void follow_places(WorldState& world, const Subdivision& subdivision) {
  for (PlacedSupport& placed : world.supports) follow_all(placed.corners, subdivision, follow_region);
  for (PlacedLoad& placed : world.loads) {
    follow_load(placed, subdivision);
    if (placed.point) follow_point(world, subdivision, *placed.point);
  }
  for (PlacedProbe& placed : world.probes)
    for (ProbedNode& probed : placed.nodes) follow_probe(probed, subdivision);
  update_supports(world, world.time, 0);
}

}  // namespace

void follow_subdivision(WorldState& world, const Subdivision& subdivision) {
  if (subdivision.tets.empty()) return;
  const std::vector<TetId> tets = tets_of(subdivision);
  if (!world.edges.offsets.empty()) world.tet_edges.edit().of_tet.resize(world.mesh->tets.size());
  const std::vector<EdgeId> edges_before = edges_of(world.tet_edges, tets);
  for (const TetBisection& halves : subdivision.tets) append_element(world, halves);
  auto first = subdivision.tets.begin();
  for (const EdgeNode& node : subdivision.nodes) {
    const auto last = std::find_if(first, subdivision.tets.end(),
                                   [&](const TetBisection& other) { return other.middle != node.node; });
    append_node(world, node, {first, last});
    first = last;
  }
  std::set<NodeId> relumped;  // new ones weigh nothing yet
  for (const EdgeNode& node : subdivision.nodes) relumped.insert({node.node, node.a, node.b});
  world.energy.regime_change += kinetic_energy_of(world, relumped) + kinetic_energy_of_edges(world, edges_before);
  std::vector<RestElement>& rest_elements = world.elements.rest_elements.edit();
  for (const TetBisection& halves : subdivision.tets)
    for (TetId tet : {halves.tet, halves.child})
      rest_elements[tet] = rest_element(corners_of(world.mesh, tet, world.mesh->rest_positions));
  for (const EdgeNode& node : subdivision.nodes)
    for (NodeId changed : {node.node, node.a, node.b}) world.nodes.masses[changed] = node_mass(world, changed);
  const std::vector<EdgeId> edges_after = edges_of(world.tet_edges, tets);
  for (const EdgeId edge : edges_after) world.edges.masses[edge] = edge_mass(world, edge);
  world.energy.regime_change -= kinetic_energy_of(world, relumped) + kinetic_energy_of_edges(world, edges_after);
  if (!edges_after.empty()) update_quadratic_states(world, tets);
  follow_places(world, subdivision);
}

void record_motion(const WorldState& world, const Body& body, MotionsBefore& motions) {
  const auto [noted, is_new] = motions.try_emplace(body.id);
  if (!is_new) return;
  const bool is_held = std::ranges::any_of(body.nodes, [&](NodeId node) { return world.nodes.has_support[node] != 0; });
  if (!is_held) noted->second = motion_of(world, body);
}

void restore_momenta(WorldState& world, const Body& body, const RigidMotion& before) {
  const RigidMotion now = motion_of(world, body);
  restore_spin(world, body, before, now);
  if (body.edges.empty()) return;  // linear interpolation keeps the momentum
  for (NodeId node : body.nodes) world.nodes.velocities[node] += before.velocity - now.velocity;
}

void restore_momenta(WorldState& world, const MotionsBefore& motions) {
  for (const auto& [id, before] : motions) {
    if (!before) continue;
    Body& body = world.bodies[id];
    body.nodes = nodes_of(world.mesh, body.tets);
    body.edges = edges_of(world.tet_edges, body.tets);
    const auto energy = [&] {
      return kinetic_energy_of(world, body.nodes) + kinetic_energy_of_edges(world, body.edges);
    };
    world.energy.regime_change += energy();
    restore_momenta(world, body, *before);
    world.energy.regime_change -= energy();
  }
}

}  // namespace griffith
