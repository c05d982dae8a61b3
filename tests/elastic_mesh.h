#pragma once

#include <span>
#include <vector>

#include "sim/elasticity/element.h"
#include "sim/mesh/topology.h"

namespace griffith::testing {

/// Tets of one material whose nodes have positions and velocities, at rest at first.
struct ElasticMesh {
  TetMesh mesh;
  Material material;
  std::vector<RestElement> rest_elements;
  std::vector<Vec3> positions, velocities;

  ElasticMesh(const TetSoup& soup, const Material& of) : mesh(build_mesh(soup)), material(of) {
    positions = mesh.rest_positions;
    velocities.assign(positions.size(), Vec3::Zero());
    for (const TetId tet : IdRange<TetId>(0, mesh.tet_count()))
      rest_elements.push_back(rest_element(corners(tet, positions)));
  }

  ElasticLaw law() const { return elastic_law(material); }
  Corners corners(TetId tet, std::span<const Vec3> nodes) const {
    Corners c;
    for (int i = 0; i < 4; ++i) c.col(i) = nodes[mesh.tets[tet][i]];
    return c;
  }
  ElementDeformation deformation(TetId tet, std::span<const Vec3> nodes) const {
    return element_deformation(material.element_model, rest_elements[tet], corners(tet, nodes));
  }
  void add_elastic_forces(TetId tet, const ElementState& state, std::vector<Vec3>& forces) const {
    const Corners f = nodal_forces(rest_elements[tet], state.frame, state.stress);
    for (int i = 0; i < 4; ++i) forces[mesh.tets[tet][i]] += f.col(i);
  }
};

}  // namespace griffith::testing
