#pragma once

#include <optional>
#include <span>

#include "sim/world/bodies/effective_law.h"
#include "sim/world/state/corners.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Returns the states of a quadratic tet at the present positions, without further flow.
inline QuadraticStates quadratic_states_at(const WorldState& world, const ElasticLaw& law,
                                           const std::optional<PlasticLaw>& plastic, TetId tet) {
  return quadratic_states(law, world.elements.rest_elements[tet], corners_of(world.mesh, tet, world.nodes.positions),
                          edges_of(world.tet_edges, tet, world.edges.offsets),
                          world.elements.corner_stress_free_strains(tet), plastic);
}

/// Calls write(tet, states) for quadratic tets of a body, with their states as quadratic_states_at() finds them.
template <class Write>
void find_quadratic_states(const WorldState& world, const Body& body, std::span<const TetId> tets, const Write& write) {
  const ElasticLaw law = effective_elastic_law(world, body);
  const std::optional<PlasticLaw> plastic = plastic_law(world.material_of(body));
  for (const TetId tet : tets) write(tet, quadratic_states_at(world, law, plastic, tet));
}

/// Returns the strains at the corners of a quadratic tet at the present positions [-].
inline CornerStrains corner_strains_at(const WorldState& world, ElementModel model, TetId tet) {
  return corner_strains(model, world.elements.rest_elements[tet], corners_of(world.mesh, tet, world.nodes.positions),
                        edges_of(world.tet_edges, tet, world.edges.offsets));
}

}  // namespace griffith
