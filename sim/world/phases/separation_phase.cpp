#include "sim/world/phases/separation_phase.h"

#include <algorithm>
#include <optional>

#include "sim/core/parallel.h"
#include "sim/fracture/resistance.h"
#include "sim/world/world_state.h"

namespace griffith {

double element_size_at(const WorldState& world, NodeId node) {
  return mean_element_size(world.elements.rest_elements, world.mesh->stars[node]);
}

double resistance_at(const WorldState& world, const Material& material, NodeId node) {
  const bool at_front = world.nodes.at_crack_front[node] != 0;
  return resistance(material, at_front, at_front ? element_size_at(world, node) : 0,
                    world.nodes.strength_factors[node]);
}

namespace {

const Body& body_at(const WorldState& world, NodeId node) {
  return world.bodies[world.elements.bodies[world.mesh->stars[node].front()]];
}

DirectionalStrength directional_strength_at(const WorldState& world, const SeparationInput& input, NodeId node) {
  const std::optional<Weakness>& weakness = world.model->weaknesses[body_at(world, node).scene_body];
  return weakness ? strength_at(input, node, *weakness) : DirectionalStrength();
}

void take_load(const WorldState& world, NodeId node, const CandidatePlane& plane, const DirectionalStrength& strength,
               bool averaged, NodeSeparation& separation) {
  const Material& material = world.material_of(body_at(world, node));
  separation.eigenvalue = plane.eigenvalue;
  separation.direction = plane.normal;
  separation.stress = averaged ? 0.5 * (plane.stress + separation.stress) : plane.stress;
  separation.resistance = strength.fraction(plane.normal) * resistance_at(world, material, node);
  const double load = material.criterion == FractureCriterion::strength ? separation.stress : separation.eigenvalue;
  separation.utilization = load / separation.resistance;
}

constexpr std::size_t kNodes = 4;  // side by side

/// What four nodes are judged by.
struct FourNodes {
  std::array<NodeId, kNodes> nodes;
  std::array<Mat3, kNodes> tensors;
  std::array<DirectionalStrength, kNodes> strengths;
};

/// Takes the first `count` of them.
void take_planes(WorldState& world, const FourNodes& four, const std::array<CandidatePlane, kNodes>& planes,
                 std::size_t count, bool averaged) {
  for (std::size_t i = 0; i < count; ++i) {
    NodeSeparation& separation = world.nodes.separations[four.nodes[i]];
    separation.tensor = four.tensors[i];
    take_load(world, four.nodes[i], planes[i], four.strengths[i], averaged, separation);
  }
}

/// As evaluate_nodes() does, to the bit: nodes in a row of a body whose stars are added up.
void take_sums(WorldState& world, const SeparationInput& input, std::span<const NodeId> nodes, bool averaged) {
  for (std::size_t first = 0; first < nodes.size(); first += kNodes) {
    const std::size_t count = std::min(kNodes, nodes.size() - first);
    FourNodes four;
    std::array<StarLoad, kNodes> loads;
    for (std::size_t i = 0; i < kNodes; ++i) {
      four.nodes[i] = nodes[first + std::min(i, count - 1)];  // lanes to spare repeat the last
      loads[i] = world.scratch.stars[four.nodes[i]].load();
      four.tensors[i] = loads[i].tensor;
      four.strengths[i] = directional_strength_at(world, input, four.nodes[i]);
    }
    take_planes(world, four, candidate_planes(loads, four.strengths), count, averaged);
  }
}

void evaluate_body(WorldState& world, const SeparationInput& input, const Body& body, bool averaged) {
  parallel_parts(static_cast<int>(body.nodes.size()), 512, [&](int begin, int end) {
    const std::span<const NodeId> nodes = std::span(body.nodes).subspan(begin, end - begin);
    add_up_stars(input, body.tets, nodes, world.scratch.stars);
    take_sums(world, input, nodes, averaged);
  });
}

}  // namespace

void evaluate_nodes(WorldState& world, const SeparationInput& input, std::span<const NodeId> nodes, bool averaged) {
  for (std::size_t first = 0; first < nodes.size(); first += kNodes) {
    const std::size_t count = std::min(kNodes, nodes.size() - first);
    FourNodes four;
    for (std::size_t i = 0; i < kNodes; ++i) {
      four.nodes[i] = nodes[first + std::min(i, count - 1)];  // lanes to spare repeat the last
      four.tensors[i] = i < count ? separation_tensor(input, four.nodes[i]) : four.tensors[i - 1];
      four.strengths[i] = directional_strength_at(world, input, four.nodes[i]);
    }
    take_planes(world, four, candidate_planes(input, four.nodes, four.tensors, four.strengths), count, averaged);
  }
}

SeparationInput separation_input(const WorldState& world) {
  return {world.mesh->tets, world.mesh->stars, world.elements.rest_elements, world.elements.states,
          world.nodes.constraints};
}

void evaluate_separation(WorldState& world, const Body& body) {
  if (body.rigid) return;
  world.scratch.stars.resize(world.nodes.positions.size());
  evaluate_body(world, separation_input(world), body, false);
}

void evaluate_separation(WorldState& world, bool averaged) {
  const SeparationInput input = separation_input(world);
  world.scratch.stars.resize(world.nodes.positions.size());
  parallel_for(static_cast<int>(world.bodies.size()), 16, [&](int first, int last) {
    for (const Body& body : std::span(world.bodies).subspan(first, last - first))
      if (body.sways()) evaluate_body(world, input, body, averaged);
  });
  for (const Body& body : world.bodies) {
    if (!body.sways()) continue;
    for (NodeId node : body.nodes)
      world.report.peak_utilization =
          std::max(world.report.peak_utilization, world.nodes.separations[node].utilization);
  }
}

}  // namespace griffith
