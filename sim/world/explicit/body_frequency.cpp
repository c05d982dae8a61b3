#include "sim/world/explicit/body_frequency.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <type_traits>
#include <vector>

#include "sim/elasticity/element_frequency.h"
#include "sim/elasticity/quadratic_frequency.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Returns the indices of each tet's items in the body's, which are sorted.
template <class Items, class Item>
auto indices_of(const Items& of_tets, const std::vector<TetId>& tets, const std::vector<Item>& of_body) {
  std::vector<std::array<int, std::tuple_size_v<std::remove_cvref_t<decltype(of_tets[TetId()])>>>> indices;
  for (const TetId tet : tets)
    std::ranges::transform(of_tets[tet], indices.emplace_back().begin(), [&](Item item) {
      return static_cast<int>(std::ranges::lower_bound(of_body, item) - of_body.begin());
    });
  return indices;
}

}  // namespace

double highest_frequency(const WorldState& world, const Body& body) {
  const Material& material = world.material_of(body);
  std::vector<RestElement> rest_elements;
  for (const TetId tet : body.tets) rest_elements.push_back(world.elements.rest_elements[tet]);
  const ElasticLaw law = elastic_law(material);
  if (body.edges.empty()) return highest_frequency(law, material.density, rest_elements);
  return highest_quadratic_frequency(law, material.density, rest_elements,
                                     indices_of(world.mesh->tets, body.tets, body.nodes),
                                     indices_of(world.tet_edges->of_tet, body.tets, body.edges));
}

void limit_frequency(const WorldState& world, Body& body) {
  body.explicit_state->frequency = highest_frequency(world, body);
}

}  // namespace griffith
