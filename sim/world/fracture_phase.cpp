#include <algorithm>
#include <cmath>
#include <set>

#include "sim/fracture/remesh.h"
#include "sim/fracture/resistance.h"
#include "sim/fracture/separation_tensor.h"
#include "sim/fracture/split.h"
#include "sim/parallel.h"
#include "sim/world/phases.h"
#include "sim/world/subdivision.h"

namespace griffith {
namespace {

/// Edge length of the cells round a node: that of a cube of six tets.
double element_size(const WorldState& world, NodeId node) {
  double volume = 0;
  for (TetId tet : world.mesh.stars[node]) volume += world.elements.rests[tet].volume;
  return std::cbrt(6 * volume / static_cast<double>(world.mesh.stars[node].size()));
}

NodeSeparation evaluate_node(const WorldState& world, const SeparationInput& input, const Material& material,
                             NodeId node, bool averaged) {
  NodeSeparation separation;
  separation.tensor = separation_tensor(input, node, world.nodes.held[node] != 0);
  const PrincipalValues principal = principal_values(separation.tensor);
  separation.eigenvalue = principal.values[2];
  separation.direction = principal.directions.col(2);
  const double stress = separation_stress(input, node, separation.eigenvalue, separation.direction);
  separation.stress = averaged ? 0.5 * (stress + world.nodes.separations[node].stress) : stress;
  separation.resistance = resistance(material, world.nodes.at_crack_front[node] != 0, element_size(world, node));
  const double load =
      material.criterion == FractureCriterion::strength ? separation.stress : separation.eigenvalue;
  separation.margin = load / separation.resistance;
  return separation;
}

/// Nodes past their resistance, the worst first.
std::vector<NodeId> overloaded_nodes(const WorldState& world) {
  std::vector<NodeId> nodes;
  for (const Body& body : world.bodies) {
    if (body.rigid) continue;
    for (NodeId node : body.nodes)
      if (world.nodes.separations[node].margin > 1) nodes.push_back(node);
  }
  std::sort(nodes.begin(), nodes.end(), [&](NodeId a, NodeId b) {
    const double margin_a = world.nodes.separations[a].margin, margin_b = world.nodes.separations[b].margin;
    return margin_a != margin_b ? margin_a > margin_b : a < b;
  });
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

void append_copy(WorldState& world, const NodeCopy& copy) {
  NodeArrays& nodes = world.nodes;
  nodes.positions.push_back(Vec3(nodes.positions[copy.original]));
  nodes.velocities.push_back(Vec3(nodes.velocities[copy.original]));
  nodes.constraints.push_back(NodeConstraint(nodes.constraints[copy.original]));
  nodes.held.push_back(std::uint8_t(nodes.held[copy.original]));
  nodes.masses.push_back(node_mass(world, copy.copy));
  nodes.masses[copy.original] = node_mass(world, copy.original);
  nodes.at_crack_front.push_back(0);
  nodes.at_crack_front[copy.original] = 0;
  nodes.rows.push_back(-1);
  nodes.separations.emplace_back();
  nodes.reactions.emplace_back(Vec3::Zero());
  nodes.separations[copy.original] = {};
}

CrackEvent describe(const WorldState& world, NodeId node, const Material& material) {
  const NodeSeparation& separation = world.nodes.separations[node];
  CrackEvent event;
  event.step = world.step;
  event.body = world.elements.bodies[world.mesh.stars[node].front()];
  event.node = node;
  event.position = world.nodes.positions[node];
  event.rest_position = world.mesh.rest_positions[node];
  event.normal = separation.direction;
  event.load = material.criterion == FractureCriterion::strength ? separation.stress : separation.eigenvalue;
  event.resistance = separation.resistance;
  return event;
}

/// What remeshing did in a step, for what is brought up to date at its end.
struct Remeshing {
  std::vector<TetBisection> bisections;
  MotionsBefore motions;   ///< of free bodies
  std::set<BodyId> bodies;
};

SplitResult remesh(WorldState& world, const Body& body, NodeId node, const Vec3& normal, Remeshing& remeshing) {
  if (!body.supported() && !remeshing.bodies.contains(body.id)) remeshing.motions[body.id] = motion_of(world, body);
  remeshing.bodies.insert(body.id);
  RemeshOptions options;
  options.limits.least_length = world.least_edges[body.scene_body];
  options.min_fragment_tets = world.scene.simulation.min_fragment_tets;
  RemeshResult result =
      remesh_node(world.mesh, world.nodes.positions, world.nodes.at_crack_front, node, normal, options);
  world.report.remeshing_refused += result.refused_edges;
  follow_subdivision(world, result.subdivision);
  remeshing.bisections.insert(remeshing.bisections.end(), result.subdivision.tets.begin(),
                              result.subdivision.tets.end());
  return std::move(result.split);
}

/// Brings up to date what single cracks leave as it was about remeshed bodies; their systems are made anew.
void finish(WorldState& world, const Remeshing& remeshing) {
  if (remeshing.bisections.empty()) return;
  restore_angular_momentum(world, remeshing.motions);
  follow_bisections(world, remeshing.bisections);
  update_supports(world, world.time, world.scene.simulation.time_step);
  for (BodyId body : remeshing.bodies) world.bodies[body].system.reset();
}

/// Opens the mesh at one node; whether anything was parted.
bool crack(WorldState& world, NodeId node, Remeshing& remeshing) {
  const Body& body = world.bodies[world.elements.bodies[world.mesh.stars[node].front()]];
  CrackEvent event = describe(world, node, world.material_of(body));
  const SplitResult result = world.scene.bodies[body.scene_body].remeshing
                                 ? remesh(world, body, node, event.normal, remeshing)
                                 : split_node(world.mesh, world.nodes.positions, node, event.normal,
                                              world.scene.simulation.min_fragment_tets);
  world.report.cracks_suppressed += result.too_small;
  if (result.changed_tets.empty()) return false;
  for (const NodeCopy& copy : result.copies) append_copy(world, copy);
  for (NodeId front : result.front) world.nodes.at_crack_front[front] = 1;
  event.nodes_made = static_cast<int>(result.copies.size());
  world.crack_events.push_back(event);
  return true;
}

}  // namespace

void evaluate_separation(WorldState& world, bool averaged) {
  const SeparationInput input{world.mesh, world.elements.rests, world.elements.states};
  for (const Body& body : world.bodies) {
    if (body.rigid) continue;
    const Material& material = world.material_of(body);
    parallel_for(static_cast<int>(body.nodes.size()), 512, [&](int begin, int end) {
      for (int i = begin; i < end; ++i)
        world.nodes.separations[body.nodes[i]] = evaluate_node(world, input, material, body.nodes[i], averaged);
    });
    for (NodeId node : body.nodes)
      world.report.peak_margin = std::max(world.report.peak_margin, world.nodes.separations[node].margin);
  }
}

void open_cracks(WorldState& world) {
  const std::vector<NodeId> overloaded = overloaded_nodes(world);
  if (overloaded.empty()) return;
  // A split relieves its neighbourhood: nodes there wait until their stress is known again.
  std::set<NodeId> waiting;
  std::set<BodyId> cracked;
  Remeshing remeshing;
  for (NodeId node : overloaded) {
    if (world.report.cracks >= world.scene.simulation.max_cracks_per_step) {
      ++world.report.cracks_postponed;
      continue;
    }
    if (waiting.contains(node)) continue;
    const std::vector<TetId> star = world.mesh.stars[node];
    const BodyId body = world.elements.bodies[star.front()];
    if (!crack(world, node, remeshing)) continue;
    ++world.report.cracks;
    cracked.insert(body);
    for (TetId tet : star) waiting.insert(world.mesh.tets[tet].begin(), world.mesh.tets[tet].end());
  }
  finish(world, remeshing);
  cracked.insert(remeshing.bodies.begin(), remeshing.bodies.end());
  for (BodyId body : cracked) part_body(world, body);
}

}  // namespace griffith
