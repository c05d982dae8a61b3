#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "sim/elasticity/quadratic_batch.h"
#include "sim/world/bodies/effective_law.h"
#include "sim/world/state/corners.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Returns a quadratic tet at the present positions.
inline PlacedQuadratic placed_quadratic(const WorldState& world, TetId tet) {
  return {&world.elements.rest_elements[tet], corners_of(world.mesh, tet, world.nodes.positions),
          edges_of(world.tet_edges, tet, world.edges.offsets), world.elements.corner_stress_free_strains(tet)};
}

/// Returns its states there, without further flow.
inline QuadraticStates quadratic_states_at(const WorldState& world, const ElasticLaw& law,
                                           const std::optional<PlasticLaw>& plastic, TetId tet) {
  const PlacedQuadratic placed = placed_quadratic(world, tet);
  return quadratic_states(law, *placed.rest, placed.corners, placed.offsets, placed.stress_free, plastic);
}

/// Calls write(tet, states) for quadratic tets of a body, with their states as quadratic_states_at() finds them.
template <class Write>
void find_quadratic_states(const WorldState& world, const Body& body, std::span<const TetId> tets, const Write& write) {
  const ElasticLaw law = effective_elastic_law(world, body);
  const std::optional<PlasticLaw> plastic = plastic_law(world.material_of(body));
  for (const TetId tet : tets) write(tet, quadratic_states_at(world, law, plastic, tet));
}

/// Calls write(tet, states) likewise, with states that lack their forces.
template <class Write>
void find_quadratic_stresses(const WorldState& world, const Body& body, std::span<const TetId> tets,
                             const Write& write) {
  const ElasticLaw law = effective_elastic_law(world, body);
  const std::optional<PlasticLaw> plastic = plastic_law(world.material_of(body));
  for (std::size_t first = 0; first < tets.size(); first += 4) {
    std::array<PlacedQuadratic, 4> placed;
    for (std::size_t i = 0; i < 4; ++i) placed[i] = placed_quadratic(world, tets[std::min(first + i, tets.size() - 1)]);
    const std::array<QuadraticStates, 4> states = quadratic_stresses(law, placed, plastic);
    for (std::size_t i = 0; i < 4 && first + i < tets.size(); ++i) write(tets[first + i], states[i]);
  }
}

/// Returns the strains at the corners of a quadratic tet at the present positions [-].
inline CornerStrains corner_strains_at(const WorldState& world, ElementModel model, TetId tet) {
  return corner_strains(model, world.elements.rest_elements[tet], corners_of(world.mesh, tet, world.nodes.positions),
                        edges_of(world.tet_edges, tet, world.edges.offsets));
}

}  // namespace griffith
