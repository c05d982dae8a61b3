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

void evaluate_body(WorldState& world, const SeparationInput& input, const Body& body, bool averaged) {
  parallel_for(static_cast<int>(body.nodes.size()), 512, [&](int begin, int end) {
    evaluate_nodes(world, input, std::span(body.nodes).subspan(begin, end - begin), averaged);
  });
}

}  // namespace

void evaluate_nodes(WorldState& world, const SeparationInput& input, std::span<const NodeId> nodes, bool averaged) {
  constexpr std::size_t kLanes = 4;
  for (std::size_t first = 0; first < nodes.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, nodes.size() - first);
    std::array<NodeId, kLanes> lanes;
    std::array<Mat3, kLanes> tensors;
    std::array<DirectionalStrength, kLanes> strengths;
    for (std::size_t i = 0; i < kLanes; ++i) {
      lanes[i] = nodes[first + std::min(i, count - 1)];  // lanes to spare repeat the last
      tensors[i] = i < count ? separation_tensor(input, lanes[i]) : tensors[i - 1];
      strengths[i] = directional_strength_at(world, input, lanes[i]);
    }
    const std::array<CandidatePlane, kLanes> planes = candidate_planes(input, lanes, tensors, strengths);
    for (std::size_t i = 0; i < count; ++i) {
      NodeSeparation& separation = world.nodes.separations[lanes[i]];
      separation.tensor = tensors[i];
      take_load(world, lanes[i], planes[i], strengths[i], averaged, separation);
    }
  }
}

SeparationInput separation_input(const WorldState& world) {
  return {world.mesh->tets, world.mesh->stars, world.elements.rest_elements, world.elements.states,
          world.nodes.constraints};
}

void evaluate_separation(WorldState& world, const Body& body) {
  if (!body.rigid) evaluate_body(world, separation_input(world), body, false);
}

void evaluate_separation(WorldState& world, bool averaged) {
  const SeparationInput input = separation_input(world);
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
