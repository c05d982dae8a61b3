#pragma once

#include <optional>
#include <vector>

#include "sim/elasticity/plasticity.h"
#include "sim/mesh/box_mesh.h"
#include "tests/elastic_mesh.h"

namespace griffith::testing {

/// A mesh moved by explicit, damped steps: elements alone, without solver and world.
struct ElasticBody : ElasticMesh {
  std::vector<Mat3> plastic_strains;

  ElasticBody(const TetSoup& soup, const Material& of) : ElasticMesh(soup, of) {
    plastic_strains.assign(rest_elements.size(), Mat3::Zero());
  }

  ElementState state(TetId tet) const {
    return element_state(law(), deformation(tet, positions), plastic_strains[tet]);
  }
  void flow_plastically() {
    const std::optional<PlasticLaw> plastic = plastic_law(material);
    if (!plastic) return;
    for (const TetId tet : IdRange<TetId>(0, mesh.tet_count()))
      plastic_strains[tet] = flow(*plastic, deformation(tet, positions), plastic_strains[tet]);
  }
  std::vector<Vec3> forces() const {
    std::vector<Vec3> sum(positions.size(), Vec3::Zero());
    for (const TetId tet : IdRange<TetId>(0, mesh.tet_count())) add_elastic_forces(tet, state(tet), sum);
    return sum;
  }
  int inverted_tets() const {
    int count = 0;
    for (const TetId tet : IdRange<TetId>(0, mesh.tet_count())) count += state(tet).inverted;
    return count;
  }
  double elastic_energy() const {
    double sum = 0;
    for (const TetId tet : IdRange<TetId>(0, mesh.tet_count()))
      sum += rest_elements[tet].volume * state(tet).energy_density;
    return sum;
  }
  /// Every node weighs `mass` [kg]; `damping` [1/s].
  void integrate(int steps, double dt, double mass, double damping) {
    for (int step = 0; step < steps; ++step) {
      const std::vector<Vec3> f = forces();
      for (std::size_t i = 0; i < positions.size(); ++i) {
        velocities[i] = (velocities[i] + dt / mass * f[i]) / (1 + dt * damping);
        positions[i] += dt * velocities[i];
      }
      flow_plastically();
    }
  }
};

}  // namespace griffith::testing
