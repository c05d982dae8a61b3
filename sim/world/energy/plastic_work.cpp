#include "sim/world/energy/plastic_work.h"

#include "sim/world/bodies/quadratic_states.h"

namespace griffith {
namespace {

/// Returns the stresses at the corners of a quadratic tet, from which its forces follow [Pa].
CornerTensors corner_stresses(const WorldState& world, const Body& body, TetId tet) {
  const std::array<ElementState, 4>& corners = world.elements.quadratic_states[tet].corners;
  CornerTensors stresses = {corners[0].stress, corners[1].stress, corners[2].stress, corners[3].stress};
  if (!world.material_of(body).yield_strength) return stresses;
  const ElasticLaw law = elastic_law(world.material_of(body));
  const CornerStrains strains = corner_strains_at(world, law.model, tet);
  const CornerTensors free = world.elements.corner_stress_free_strains(tet);
  for (int v = 0; v < 4; ++v) {
    const Mat3 elastic = strains.corners[v] - free[v];
    stresses[v] = law.lambda * elastic.trace() * Mat3::Identity() + 2 * law.mu * elastic;
  }
  return stresses;
}

}  // namespace

std::vector<Mat3> stresses_of(const WorldState& world, const Body& body) {
  std::vector<Mat3> stresses;
  stresses.reserve(body.tets.size());
  for (TetId tet : body.tets) {
    if (body.edges.empty()) {
      stresses.push_back(world.elements.states[tet].stress);
    } else {
      const CornerTensors of_corners = corner_stresses(world, body, tet);
      stresses.insert(stresses.end(), of_corners.begin(), of_corners.end());
    }
  }
  return stresses;
}

double work_of_yielding(const WorldState& world, const Body& body, const BodySnapshot& before, double relieved) {
  const double mu = relieved * 2 * shear_modulus(world.material_of(body));
  double work = 0;
  const auto add = [&](double volume, const Mat3& stress, const Mat3& flowed) {
    work += volume * (stress + mu * flowed).cwiseProduct(flowed).sum();
  };
  for (std::size_t i = 0; i < before.plastic_strains.size(); ++i) {
    const TetId tet = body.tets[i];
    add(world.elements.rest_elements[tet].volume, world.elements.states[tet].stress,
        world.elements.plastic_strains[tet] - before.plastic_strains[i]);
  }
  for (std::size_t i = 0; i < before.point_strains.size(); ++i) {
    const TetId tet = body.tets[i];
    const CornerTensors stresses = at_integration_points(corner_stresses(world, body, tet));
    for (int k = 0; k < 4; ++k)
      add(world.elements.rest_elements[tet].volume / 4, stresses[k],
          world.elements.point_strains[tet][k] - before.point_strains[i][k]);
  }
  return work;
}

double plastic_work(const WorldState& world, const Body& body, const BodySnapshot& before) {
  return work_of_yielding(world, body, before, 0.5);
}

}  // namespace griffith
