#pragma once

#include <optional>
#include <vector>

#include "sim/elasticity/plasticity.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/topology.h"

namespace griffith::testing {

/// A mesh moved by explicit, damped steps: elements alone, without solver and world.
struct ElasticBody {
  TetMesh mesh;
  Material material;
  std::vector<ElementRest> rests;
  std::vector<Mat3> plastic_strains;
  std::vector<Vec3> positions, velocities;

  ElasticBody(const TetSoup& soup, const Material& of) : mesh(build_mesh(soup)), material(of) {
    positions = mesh.rest_positions;
    velocities.assign(positions.size(), Vec3::Zero());
    for (int tet = 0; tet < mesh.tet_count(); ++tet) rests.push_back(element_rest(corners(TetId(tet))));
    plastic_strains.assign(rests.size(), Mat3::Zero());
  }

  Corners corners(TetId tet) const {
    Corners c;
    for (int i = 0; i < 4; ++i) c.col(i) = positions[mesh.tets[tet][i]];
    return c;
  }
  ElementState state(TetId tet) const {
    const ElasticLaw law = elastic_law(material);
    return element_state(law, element_deformation(law.model, rests[tet], corners(tet)), plastic_strains[tet]);
  }
  void flow_plastically() {
    const std::optional<PlasticLaw> plastic = plastic_law(material);
    for (TetId tet(0); plastic && tet < mesh.tet_count(); ++tet.value)
      plastic_strains[tet] =
          flow(*plastic, element_deformation(material.element_model, rests[tet], corners(tet)), plastic_strains[tet]);
  }
  std::vector<Vec3> forces() const {
    std::vector<Vec3> sum(positions.size(), Vec3::Zero());
    for (TetId tet(0); tet < mesh.tet_count(); ++tet.value) {
      const ElementState s = state(tet);
      const Corners f = nodal_forces(rests[tet], s.frame, s.stress);
      for (int i = 0; i < 4; ++i) sum[mesh.tets[tet][i]] += f.col(i);
    }
    return sum;
  }
  int inverted_tets() const {
    int count = 0;
    for (TetId tet(0); tet < mesh.tet_count(); ++tet.value) count += state(tet).inverted;
    return count;
  }
  double elastic_energy() const {
    double sum = 0;
    for (TetId tet(0); tet < mesh.tet_count(); ++tet.value) sum += rests[tet].volume * state(tet).energy_density;
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
