#include "sim/world/fracture/fracture_phase.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "sim/fracture/crack_front.h"
#include "sim/fracture/remesh.h"
#include "sim/fracture/split.h"
#include "sim/world/bodies/acting_bonds.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/bodies/bonded_pieces.h"
#include "sim/world/energy/energy_phase.h"
#include "sim/world/fracture/new_bonds.h"
#include "sim/world/fracture/separation_phase.h"
#include "sim/world/fracture/subdivision.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/state/corners.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Opens postponed cracks as they were then, unless the load has grown since.
void restore_postponed(WorldState& world) {
  for (const PostponedCrack& crack : world.postponed) {
    const Body& body = body_at(world, crack.node);
    NodeSeparation& now = world.nodes.separations[crack.node];
    if (!body.rigid && now.utilization < crack.separation.utilization) now = crack.separation;
  }
  world.postponed.clear();
}

/// Returns nodes above their resistance, the worst of all bodies first.
std::vector<NodeId> overloaded_nodes(const WorldState& world) {
  std::vector<NodeId> nodes;
  for (const Body& body : world.bodies) {
    if (!body.is_deformable()) continue;
    for (NodeId node : body.nodes)
      if (world.nodes.separations[node].utilization > 1) nodes.push_back(node);
  }
  std::sort(nodes.begin(), nodes.end(), [&](NodeId a, NodeId b) {
    const double utilization_a = world.nodes.separations[a].utilization,
                 utilization_b = world.nodes.separations[b].utilization;
    return utilization_a != utilization_b ? utilization_a > utilization_b : a < b;
  });
  return nodes;
}

void append_copy(WorldState& world, const NodeCopy& copy) {
  NodeArrays& nodes = world.nodes;
  nodes.append_copy(copy.original);
  for (const NodeId node : {copy.original, copy.copy}) nodes.masses[node] = node_mass(world, node);
  nodes.at_crack_front[copy.original] = 0;
  for (const NodeId node : {copy.original, copy.copy}) nodes.path_offsets[node].setZero();
  nodes.separations[copy.original] = {};
}

/// Splits the edges of quadratic tets whose nodes were split.
void part_edges(WorldState& world, std::span<const NodeCopy> copies, std::vector<EdgeCopy>& edge_copies) {
  if (world.edges.offsets.empty() || copies.empty()) return;
  std::vector<NodeId> copied;
  for (const NodeCopy& copy : copies) copied.push_back(copy.copy);
  for (const EdgeCopy& copy : part_edges(world.mesh, copied, world.tet_edges.edit())) {
    world.edges.append_copy(copy.original);
    edge_copies.push_back(copy);
  }
  std::vector<TetId> tets;
  for (const NodeCopy& copy : copies)
    for (const NodeId node : {copy.original, copy.copy})
      tets.insert(tets.end(), world.mesh->stars[node].begin(), world.mesh->stars[node].end());
  for (const EdgeId edge : edges_of(world.tet_edges, tets)) world.edges.masses[edge] = edge_mass(world, edge);
}

/// True if elements are cut for the body's cracks. Elements too small to separate would be cut again and again and
/// never break.
bool is_remeshed(const WorldState& world, const Body& body) {
  const Scene& scene = world.model->scene;
  return scene.bodies[body.scene_body].remeshing &&
         static_cast<int>(body.tets.size()) >= scene.simulation.min_fragment_tets;
}

/// Cuts the tets of a node along the plane. Returns 1 for those above it.
std::vector<std::uint8_t> remesh(WorldState& world, const Body& body, NodeId node, const Vec3& normal, Opened& opened) {
  record_motion(world, body, opened.motions);
  RemeshOptions options;
  options.limits.min_length = world.model->min_edges[body.scene_body];
  StarCut cut = cut_star(world.mesh.edit(), world.nodes.positions, world.nodes.at_crack_front, node, normal, options);
  world.report.remeshing_refused += cut.refused_edges;
  follow_subdivision(world, cut.subdivision);
  if (!cut.subdivision.tets.empty()) {
    opened.bodies.insert(body.id);
    world.bodies[body.id].system.reset();
  }
  return std::move(cut.above);
}

/// Returns for each tet of a node's star whether it lies on the upper side of the node's plane (1) or not (0).
std::vector<std::uint8_t> sides_at(const WorldState& world, NodeId node) {
  const Vec3& normal = world.nodes.separations[node].direction;
  if (world.nodes.at_crack_front[node] == 0) return tets_above(world.mesh, world.nodes.positions, node, normal);
  std::vector<Corners> star;
  for (const TetId tet : world.mesh->stars[node]) star.push_back(corners_of(world.mesh, tet, world.nodes.positions));
  return sides_of_crack(world.mesh, node, star, normal, path_offset_at(world, node));
}

/// Returns the event of a crack. `above`: per tet of the node.
CrackEvent describe(const WorldState& world, NodeId node, const std::vector<std::uint8_t>& above) {
  const Body& body = body_at(world, node);
  const NodeSeparation& separation = world.nodes.separations[node];
  CrackEvent event;
  event.step = world.step;
  event.time = world.time;
  event.body = body.id;
  event.node = node;
  event.position = world.nodes.positions[node];
  event.rest_position = world.mesh->rest_positions[node];
  event.normal = separation.direction;
  event.eigenvalue = separation.eigenvalue;
  event.load = separation.utilization * separation.resistance;
  event.resistance = separation.resistance;
  if (body.explicit_state && body.explicit_state->similarity < 1) event.scaled = body.scaled;
  const SeparationInput input = separation_input(world);
  const std::vector<TetId>& star = world.mesh->stars[node];
  for (std::size_t i = 0; i < star.size(); ++i)
    event.elements.push_back({star[i], above[i] != 0, split_force(input, star[i], node)});
  return event;
}

/// Returns the unit normal at rest of the path of a crack that opens the plane of a node. Planes of nodes scatter by
/// some degrees with the pattern of tets. If the faces that open follow the plane as closely, they are the path.
Vec3 path_normal(const WorldState& world, NodeId node, const Vec3& normal, std::span<const std::uint8_t> above) {
  constexpr double kScatter = 0.97;  // cosine of 14°
  const Mat3& frame = world.elements.states[world.mesh->stars[node].front()].frame;
  const Vec3 plane = (frame.transpose() * normal).normalized();
  const Vec3 faces = linked_area(world.mesh, node, above);
  return faces.dot(plane) > kScatter * faces.norm() ? faces.normalized() : plane;
}

/// Takes nodes at the front of a crack that has opened across a plane at rest. Its path goes on from that plane.
void lead_on(WorldState& world, const Vec3& through, const Vec3& normal, std::span<const NodeId> front) {
  for (const NodeId node : front) {
    const Vec3 offset = normal.dot(through - world.mesh->rest_positions[node]) * normal;
    Vec3& known = world.nodes.path_offsets[node];
    known = world.nodes.at_crack_front[node] != 0 ? Vec3((known + offset) / 2) : offset;
    world.nodes.at_crack_front[node] = 1;
  }
}

/// Records when the faces without a neighbor were opened.
void date_open_faces(WorldState& world, const std::vector<TetId>& parted) {
  for (TetId tet : parted)
    for (int face = 0; face < 4; ++face) {
      const bool open = !world.mesh->neighbors[tet][face].valid() && !(world.elements.first_surface[tet] >> face & 1);
      if (!open || !std::isnan(world.elements.opened[tet][face])) continue;
      world.elements.opened.edit()[tet][face] = world.time;
      account_crack(world, tet, face);
    }
}

}  // namespace

bool may_crack(const WorldState& world, NodeId node) {
  const Body& body = body_at(world, node);
  if (is_remeshed(world, body) || world.nodes.has_support[node] != 0) return true;
  const std::vector<std::uint8_t> above = sides_at(world, node);
  return std::ranges::adjacent_find(above, std::ranges::not_equal_to()) != above.end();
}

bool crack(WorldState& world, NodeId node, Opened& opened) {
  const Body& body = body_at(world, node);
  const Vec3 normal = world.nodes.separations[node].direction;
  const std::vector<std::uint8_t> above =
      is_remeshed(world, body) ? remesh(world, body, node, normal, opened) : sides_at(world, node);
  CrackEvent event = describe(world, node, above);
  const Vec3 through = world.mesh->rest_positions[node] + world.nodes.path_offsets[node];
  const Vec3 rest_normal = path_normal(world, node, normal, above);
  const SplitResult result =
      split_node(world.mesh.edit(), node, above, world.model->scene.simulation.min_fragment_tets);
  world.report.cracks_suppressed += result.too_small;
  if (result.too_small) return false;
  for (const NodeCopy& copy : result.copies) append_copy(world, copy);
  part_edges(world, result.copies, opened.edge_copies);
  opened.copies.insert(opened.copies.end(), result.copies.begin(), result.copies.end());
  lead_on(world, through, rest_normal, result.front);
  event.nodes_made = static_cast<int>(result.copies.size());
  event.torn_off =
      result.changed_tets.empty() ? tear_off(world, node, event.normal) : reassign_supports(world, result.copies);
  if (result.changed_tets.empty() && !event.torn_off) return false;
  date_open_faces(world, result.changed_tets);
  opened.parted.insert(opened.parted.end(), result.changed_tets.begin(), result.changed_tets.end());
  world.report.supports_torn += event.torn_off;
  keep_least(world.bodies[event.body].broke_scaled, event.scaled);
  world.crack_events.push_back(std::move(event));
  return true;
}

namespace {

/// True if a wave from a crack of this substep relieves the node within it (Mott 1947). Running cracks outrun such
/// waves.
bool is_relieved(const WorldState& world, NodeId node, std::size_t first_event, double substep) {
  if (world.nodes.at_crack_front[node]) return false;
  const Body& body = body_at(world, node);
  const double reach = bar_wave_speed(world.material_of(body)) * substep;
  return std::any_of(world.crack_events.begin() + static_cast<std::ptrdiff_t>(first_event), world.crack_events.end(),
                     [&](const CrackEvent& event) {
                       return event.body == body.id && (event.position - world.nodes.positions[node]).norm() < reach;
                     });
}

/// Bonds the nodes that came apart when one did, which had this utilization.
void bond(WorldState& world, NodeId opened, std::span<const NodeCopy> copies, double utilization) {
  std::map<NodeId, std::vector<NodeId>> parted;
  for (const NodeCopy& copy : copies) parted[copy.original].push_back(copy.copy);
  for (const auto& [original, made] : parted) bond_copies(world, original, made, original == opened ? utilization : 1);
  follow_front(world);
}

/// Adds to overloaded nodes of fronts those beside them in the front that are loaded as much within the scatter of
/// single nodes. Opened one after the other they would take turns to lag behind and to hold the front up.
std::vector<NodeId> with_fronts(const WorldState& world, const std::vector<NodeId>& overloaded) {
  constexpr double kScatter = 0.86;  // of loads: energy release rates scatter by 15 % in each direction
  std::vector<NodeId> nodes;
  std::set<NodeId> known(overloaded.begin(), overloaded.end());
  for (const NodeId node : overloaded) {
    nodes.push_back(node);
    if (world.nodes.at_crack_front[node] == 0) continue;
    for (const TetId tet : world.mesh->stars[node])
      for (const NodeId near : world.mesh->tets[tet])
        if (world.nodes.at_crack_front[near] != 0 && world.nodes.separations[near].utilization > kScatter &&
            known.insert(near).second)
          nodes.push_back(near);
  }
  return nodes;
}

/// Opens cracks at nodes in their order, within the budget. Bonds relieve nothing at once: a front advances as a whole.
Opened crack_in_turn(WorldState& world, const std::vector<NodeId>& overloaded, double substep) {
  Opened opened;
  opened.first_event = world.crack_events.size();
  const bool is_bonded = bonds_act(world);
  for (NodeId node : is_bonded ? with_fronts(world, overloaded) : overloaded) {
    if (world.nodes.separations[node].utilization == 0) continue;  // came apart beside another one
    if (opened.waiting.contains(node) || is_relieved(world, node, opened.first_event, substep)) continue;
    if (world.report.cracks >= world.model->scene.simulation.max_cracks_per_step) {
      world.postponed.push_back({node, world.nodes.separations[node]});
      continue;
    }
    const std::vector<TetId> star = world.mesh->stars[node];
    const BodyId body = world.elements.bodies[star.front()];
    const double utilization = world.nodes.separations[node].utilization;
    const std::size_t first_copy = opened.copies.size();
    std::set<NodeId> beside;
    for (const TetId tet : star)
      for (const NodeId near : world.mesh->tets[tet])
        if (!is_bonded || world.nodes.at_crack_front[near] == 0) beside.insert(near);
    if (!crack(world, node, opened)) continue;
    if (is_bonded) bond(world, node, std::span(opened.copies).subspan(first_copy), utilization);
    ++world.report.cracks;
    opened.bodies.insert(body);
    if (world.crack_events.back().torn_off) world.bodies[body].system.reset();
    opened.waiting.insert(beside.begin(), beside.end());
  }
  return opened;
}

/// Returns the bodies of the elements of a crack if there are several.
std::vector<BodyId> children_of(const WorldState& world, const CrackEvent& event) {
  std::set<BodyId> bodies;
  for (const CrackElement& element : event.elements) bodies.insert(world.elements.bodies[element.tet]);
  if (bodies.size() < 2) return {};
  return {bodies.begin(), bodies.end()};
}

}  // namespace

void part_opened(WorldState& world, const Opened& opened) {
  restore_momenta(world, opened.motions);
  follow_cracks(world.model->splinters, world.mesh->neighbors, opened.parted, world.splinter_state);
  const std::vector<BodyId> pieces =
      part_bodies(world, std::vector<BodyId>(opened.bodies.begin(), opened.bodies.end()));
  release_unbonded(world, pieces);
  rebuild_pieces(world, pieces);
  for (std::size_t i = opened.first_event; i < world.crack_events.size(); ++i)
    world.crack_events[i].children = children_of(world, world.crack_events[i]);
}

void open_cracks(WorldState& world, double substep) {
  restore_postponed(world);
  const std::vector<NodeId> overloaded = overloaded_nodes(world);
  const std::vector<BodyId> broke = std::exchange(world.scratch.bonds_broke_in, {});
  if (overloaded.empty() && broke.empty()) return;
  Opened opened = crack_in_turn(world, overloaded, substep);
  opened.bodies.insert(broke.begin(), broke.end());
  part_opened(world, opened);
  world.report.cracks_postponed = static_cast<int>(world.postponed.size());
}

}  // namespace griffith
