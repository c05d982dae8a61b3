#include "sim/world/fracture/separation_phase.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/core/parallel.h"
#include "sim/fracture/crack_front.h"
#include "sim/fracture/fracture_law.h"
#include "sim/fracture/resistance.h"
#include "sim/mesh/topology.h"
#include "sim/world/bodies/acting_bonds.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/state/corners.h"
#include "sim/world/state/world_state.h"

namespace griffith {

double element_size_at(const WorldState& world, NodeId node) {
  return mean_element_size(world.elements.rest_elements, world.mesh->stars[node]);
}

double screening_resistance_at(const WorldState& world, const Material& material, NodeId node, bool at_front) {
  return screening_resistance(material, at_front, at_front ? element_size_at(world, node) : 0,
                              world.nodes.strength_factors[node]);
}

namespace {

DirectionalStrength directional_strength_at(const WorldState& world, const SeparationInput& input, NodeId node) {
  const std::optional<Weakness>& weakness = world.model->weaknesses[body_at(world, node).scene_body];
  return weakness ? strength_at(input, node, *weakness) : DirectionalStrength();
}

/// Returns the best advance of a crack through a node of its front, across a plane or straight on. Openings of a scaled
/// body are 1/f times as large.
CrackAdvance advance_at(const WorldState& world, NodeId node, const Vec3& normal) {
  std::vector<Corners> star;
  std::vector<Vec3> forces;
  for (const TetId tet : world.mesh->stars[node]) {
    star.push_back(corners_of(world.mesh, tet, world.nodes.positions));
    forces.push_back(corner_force(world.elements.rest_elements[tet], world.elements.states[tet],
                                  local_corner(world.mesh, tet, node)));
  }
  const Body& body = body_at(world, node);
  CrackAdvance advance =
      best_advance(world.mesh, node, star, forces, normal, path_offset_at(world, node), world.scratch.held_nodes);
  if (body.explicit_state) advance.energy_release *= body.explicit_state->similarity;
  return advance;
}

/// Utilization below which a node is not worth averaging.
constexpr double kWorthAveraging = 0.8;

/// Averages the load of a node over its zone, like the tension across its plane. Returns it over the strength.
///   tension  across the plane at the node [Pa]
double average_tension(const WorldState& world, const SeparationInput& input, TensionZones& zones, NodeId node,
                       double tension, double strength, NodeSeparation& separation) {
  separation.mean_tension = separation.stress;
  separation.averaging_radius = 0;
  if (separation.stress <= kWorthAveraging * strength) return separation.stress / strength;
  const TensionZone zone = tension_zone_at(world, zones, node);
  if (zone.parts.empty() || tension <= 0) return separation.stress / strength;
  separation.averaging_radius = zone.radius;
  separation.mean_tension =
      separation.stress * std::min(1.0, mean_tension(input, zone, separation.direction) / tension);
  return separation.mean_tension / strength;
}

void take_load(const WorldState& world, const SeparationInput& input, TensionZones& zones, NodeId node,
               const CandidatePlane& plane, const DirectionalStrength& strength, bool averaged,
               NodeSeparation& separation) {
  const Material& material = world.material_of(body_at(world, node));
  const FractureLaw& law = fracture_law(material);
  const double load = law.load(input, node, material, plane), stress = law.is_stress() ? load : plane.stress;
  const double fraction = strength.fraction(plane.normal);
  separation.eigenvalue = plane.eigenvalue;
  separation.direction = plane.normal;
  separation.stress = averaged ? 0.5 * (stress + separation.end_stress) : stress;
  separation.end_stress = stress;
  const double whole = fraction * resistance(material, world.nodes.strength_factors[node]);
  separation.resistance = whole;
  separation.energy_release = 0;
  if (!law.is_stress()) {
    separation.utilization = load / whole;
    return;
  }
  separation.utilization = average_tension(world, input, zones, node, plane.stress, whole, separation);
  if (world.nodes.at_crack_front[node] != 0) {
    separation.fracture_energy = fracture_energy(material, fraction);
    const CrackAdvance advance = advance_at(world, node, plane.normal);
    separation.energy_release = advance.energy_release;
    const double by_energy = std::sqrt(separation.energy_release / separation.fracture_energy);
    if (by_energy > separation.utilization) separation.direction = advance.normal;
    separation.utilization = std::max(separation.utilization, by_energy);
  }
  if (separation.stress > 0 && separation.utilization > 0 && separation.utilization != separation.stress / whole)
    separation.resistance = separation.stress / separation.utilization;
}

/// Judges nodes four side by side. loads_of(four): the loads of up to four of them, of which places to spare repeat the
/// last.
template <class LoadsOf>
void evaluate_fours(WorldState& world, const SeparationInput& input, std::span<const NodeId> nodes, bool averaged,
                    const LoadsOf& loads_of) {
  TensionZones zones(world.mesh, world.nodes.at_crack_front);
  for (std::size_t first = 0; first < nodes.size(); first += 4) {
    const std::span<const NodeId> four = nodes.subspan(first, std::min<std::size_t>(4, nodes.size() - first));
    const std::array<NodeLoad, 4> loads = loads_of(four);
    std::array<DirectionalStrength, 4> strengths;
    for (std::size_t i = 0; i < 4; ++i)
      strengths[i] = i < four.size() ? directional_strength_at(world, input, four[i]) : strengths[i - 1];
    const std::array<CandidatePlane, 4> planes = candidate_planes(loads, strengths);
    for (std::size_t i = 0; i < four.size(); ++i) {
      NodeSeparation& separation = world.nodes.separations[four[i]];
      separation.tensor = loads[i].tensor;
      take_load(world, input, zones, four[i], planes[i], strengths[i], averaged, separation);
    }
  }
}

/// Does the same as evaluate_nodes(), to the bit, for consecutive nodes of a body with accumulated loads.
void take_sums(WorldState& world, const SeparationInput& input, std::span<const NodeId> nodes, bool averaged) {
  evaluate_fours(world, input, nodes, averaged, [&](std::span<const NodeId> four) {
    std::array<NodeLoad, 4> loads;
    for (std::size_t i = 0; i < 4; ++i)
      loads[i] = i < four.size() ? world.scratch.node_load_sums[four[i]].load() : loads[i - 1];
    return loads;
  });
}

void evaluate_body(WorldState& world, const SeparationInput& input, const Body& body, bool averaged) {
  parallel_parts(static_cast<int>(body.nodes.size()), 512, [&](int begin, int end) {
    const std::span<const NodeId> nodes = std::span(body.nodes).subspan(begin, end - begin);
    accumulate_node_loads(input, body.tets, nodes, world.scratch.node_load_sums);
    take_sums(world, input, nodes, averaged);
  });
}

}  // namespace

Vec3 path_offset_at(const WorldState& world, NodeId node) {
  return world.elements.states[world.mesh->stars[node].front()].frame * world.nodes.path_offsets[node];
}

double fracture_energy_at(const WorldState& world, NodeId node, const Vec3& normal) {
  const double fraction = directional_strength_at(world, separation_input(world), node).fraction(normal);
  return fracture_energy(world.material_of(body_at(world, node)), fraction);
}

TensionZone tension_zone_at(const WorldState& world, TensionZones& zones, NodeId node) {
  const Body& body = body_at(world, node);
  TensionZone zone = zones.zone_of(node, characteristic_length(world.material_of(body)), body.depth);
  // At a front, the stress at the corner of a quadratic tet is as large as the tet is small: that of the whole counts.
  if (zone.parts.empty() && world.nodes.at_crack_front[node] != 0 && !body.edges.empty())
    zone = star_zone(world.mesh, node);
  return zone;
}

void evaluate_nodes(WorldState& world, const SeparationInput& input, std::span<const NodeId> nodes, bool averaged) {
  evaluate_fours(world, input, nodes, averaged, [&](std::span<const NodeId> four) { return node_loads(input, four); });
}

SeparationInput separation_input(const WorldState& world) {
  return {world.mesh->tets,        world.mesh->stars,       world.elements.rest_elements,   world.elements.states,
          world.nodes.constraints, world.tet_edges->of_tet, world.elements.quadratic_states};
}

void evaluate_separation(WorldState& world, const Body& body) {
  if (body.rigid) return;
  world.scratch.node_load_sums.resize(world.nodes.positions.size());
  evaluate_body(world, separation_input(world), body, false);
}

void reevaluate_separation(WorldState& world, int scene_body) {
  world.scratch.node_load_sums.resize(world.nodes.positions.size());
  world.scratch.held_nodes = held_nodes(world);
  for (const Body& body : world.bodies) {
    if (body.rigid || body.scene_body != scene_body) continue;
    for (const NodeId node : body.nodes) {
      NodeSeparation& separation = world.nodes.separations[node];
      separation.end_stress = 2 * separation.stress - separation.end_stress;  // at the start
    }
    evaluate_body(world, separation_input(world), body, true);
  }
  world.scratch.held_nodes.clear();
}

void evaluate_separation(WorldState& world, bool averaged) {
  const SeparationInput input = separation_input(world);
  world.scratch.node_load_sums.resize(world.nodes.positions.size());
  world.scratch.held_nodes = held_nodes(world);
  parallel_for(static_cast<int>(world.bodies.size()), 16, [&](int first, int last) {
    for (const Body& body : std::span(world.bodies).subspan(first, last - first))
      if (body.is_deformable()) evaluate_body(world, input, body, averaged);
  });
  world.scratch.held_nodes.clear();
  for (const Body& body : world.bodies) {
    if (body.rigid || body.explicit_state) continue;
    world.report.peak_utilization = std::max(world.report.peak_utilization, peak_utilization(world, body));
  }
}

double peak_utilization(const WorldState& world, const Body& body) {
  double peak = 0;
  for (NodeId node : body.nodes) peak = std::max(peak, world.nodes.separations[node].utilization);
  return peak;
}

}  // namespace griffith
