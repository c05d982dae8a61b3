#pragma once

#include <vector>

#include "sim/fracture/split.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/topology.h"
#include "sim/solver/elastic_system.h"

namespace griffith::testing {

/// One elastic box with everything the solver needs, and nothing of the world.
struct ElasticBox {
  TetMesh mesh;
  Material material;
  std::vector<TetId> tets;
  std::vector<ElementRest> rests;
  std::vector<ElementState> states;
  std::vector<Vec3> positions, velocities, forces;
  std::vector<double> masses;
  std::vector<NodeConstraint> constraints;
  std::vector<int> rows;

  ElasticBox(const Vec3& size, double element_size, double young_modulus)
      : ElasticBox(make_box(size, Vec3::Constant(element_size), BoxPattern::five_tet), young_modulus) {}
  ElasticBox(const TetSoup& soup, double young_modulus) {
    mesh = build_mesh(soup);
    material.young_modulus = young_modulus;
    positions = mesh.rest_positions;
    velocities.assign(positions.size(), Vec3::Zero());
    forces.assign(positions.size(), Vec3::Zero());
    masses.assign(positions.size(), 0);
    constraints.resize(positions.size());
    rows.assign(positions.size(), -1);
    for (int t = 0; t < mesh.tet_count(); ++t) {
      tets.push_back(TetId(t));
      Corners corners;
      for (int i = 0; i < 4; ++i) corners.col(i) = mesh.rest_positions[mesh.tets[t][i]];
      rests.push_back(element_rest(corners));
      for (NodeId node : mesh.tets[t]) masses[node] += material.density * rests.back().volume / 4;
    }
    update_states();
  }

  ElementState state(TetId tet, std::span<const Vec3> nodes) const {
    Corners corners;
    for (int i = 0; i < 4; ++i) corners.col(i) = nodes[mesh.tets[tet][i]];
    return element_state(law(), element_deformation(material.element_model, rests[tet], corners));
  }
  void update_states() {
    states.clear();
    for (TetId tet : tets) states.push_back(state(tet, positions));
  }
  void add_elastic_forces() {
    for (TetId tet : tets) {
      const Corners f = nodal_forces(rests[tet], states[tet].frame, states[tet].stress);
      for (int i = 0; i < 4; ++i) forces[mesh.tets[tet][i]] += f.col(i);
    }
  }
  double lumped_mass(NodeId node) const {
    double mass = 0;
    for (TetId tet : mesh.stars[node]) mass += material.density * rests[tet].volume / 4;
    return mass;
  }
  /// Opens the mesh at a node; everything per node follows.
  void split(NodeId node, const Vec3& normal) {
    for (const NodeCopy& copy : split_node(mesh, positions, node, normal).copies) {
      positions.push_back(Vec3(positions[copy.original]));
      velocities.push_back(Vec3(velocities[copy.original]));
      forces.push_back(Vec3(forces[copy.original]));
      constraints.push_back(NodeConstraint(constraints[copy.original]));
      masses.push_back(lumped_mass(copy.copy));
      masses[copy.original] = lumped_mass(copy.original);
      rows.push_back(-1);
    }
  }
  ElasticLaw law() const { return elastic_law(material); }
  ElasticSystem system() { return ElasticSystem(mesh, tets, constraints, rows); }
  void assemble(ElasticSystem& system, const ImplicitStep& step) const {
    system.assemble(step, law(), rests, states, positions, masses);
  }
  SolveReport solve(ElasticSystem& system, const ImplicitStep& step) {
    return system.solve(step, positions, forces, masses, constraints, velocities);
  }
};

}  // namespace griffith::testing
