#include "sim/world/phases/separation_phase.h"

#include <algorithm>
#include <cmath>

#include "sim/core/parallel.h"
#include "sim/fracture/resistance.h"
#include "sim/world/world_state.h"

namespace griffith {

double element_size_at(const WorldState& world, NodeId node) {
  double volume = 0;
  for (TetId tet : world.mesh.stars[node]) volume += world.elements.rest_elements[tet].volume;
  return std::cbrt(6 * volume / static_cast<double>(world.mesh.stars[node].size()));
}

double resistance_at(const WorldState& world, const Material& material, NodeId node) {
  const bool at_front = world.nodes.at_crack_front[node] != 0;
  return resistance(material, at_front, at_front ? element_size_at(world, node) : 0,
                    world.nodes.strength_factors[node]);
}

NodeSeparation evaluate_node(const WorldState& world, const SeparationInput& input, const Body& body, NodeId node,
                             bool averaged) {
  const Material& material = world.material_of(body);
  const std::optional<Weakness>& weakness = world.model->weaknesses[body.scene_body];
  const DirectionalStrength strength = weakness ? strength_at(input, node, *weakness) : DirectionalStrength();

  NodeSeparation separation;
  separation.tensor = separation_tensor(input, node);
  const CandidatePlane plane = candidate_plane(input, node, separation.tensor, strength);
  separation.eigenvalue = plane.eigenvalue;
  separation.direction = plane.normal;
  separation.stress = averaged ? 0.5 * (plane.stress + world.nodes.separations[node].stress) : plane.stress;
  separation.resistance = strength.fraction(plane.normal) * resistance_at(world, material, node);
  const double load = material.criterion == FractureCriterion::strength ? separation.stress : separation.eigenvalue;
  separation.utilization = load / separation.resistance;
  return separation;
}

namespace {

void evaluate_body(WorldState& world, const SeparationInput& input, const Body& body, bool averaged) {
  parallel_for(static_cast<int>(body.nodes.size()), 512, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      world.nodes.separations[body.nodes[i]] = evaluate_node(world, input, body, body.nodes[i], averaged);
  });
}

}  // namespace

SeparationInput separation_input(const WorldState& world) {
  return {world.mesh.tets, world.mesh.stars, world.elements.rest_elements, world.elements.states,
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
  for (const Body& body : world.bodies)
    for (NodeId node : body.nodes)
      if (body.sways())
        world.report.peak_utilization =
            std::max(world.report.peak_utilization, world.nodes.separations[node].utilization);
}

}  // namespace griffith
