#pragma once

#include <vector>

#include "sim/fracture/split.h"
#include "sim/mesh/box_mesh.h"
#include "sim/solver/elastic_system.h"
#include "tests/elastic_mesh.h"

namespace griffith::testing {

/// One elastic box with everything the solver needs, and nothing of the world.
struct ElasticBox : ElasticMesh {
  std::vector<TetId> tets;
  std::vector<ElementState> states;
  std::vector<Vec3> forces;
  std::vector<double> masses;
  std::vector<NodeConstraint> constraints;
  std::vector<int> rows;

  ElasticBox(const Vec3& size, double element_size, double young_modulus)
      : ElasticBox(make_box(size, Vec3::Constant(element_size), BoxPattern::five_tet), young_modulus) {}
  ElasticBox(const TetSoup& soup, double young_modulus) : ElasticMesh(soup, Material()) {
    material.young_modulus = young_modulus;
    forces.assign(positions.size(), Vec3::Zero());
    constraints.resize(positions.size());
    rows.assign(positions.size(), -1);
    for (const TetId tet : IdRange<TetId>(0, mesh.tet_count())) tets.push_back(tet);
    for (const NodeId node : IdRange<NodeId>(0, mesh.node_count())) masses.push_back(lumped_mass(node));
    update_states();
  }

  ElementState state(TetId tet, std::span<const Vec3> nodes) const {
    return element_state(law(), deformation(tet, nodes));
  }
  void update_states() {
    states.clear();
    for (TetId tet : tets) states.push_back(state(tet, positions));
  }
  void add_elastic_forces() {
    for (TetId tet : tets) ElasticMesh::add_elastic_forces(tet, states[tet], forces);
  }
  double lumped_mass(NodeId node) const {
    double mass = 0;
    for (TetId tet : mesh.stars[node]) mass += material.density * rest_elements[tet].volume / 4;
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
  ElasticSystem system() { return ElasticSystem(mesh, tets, constraints, rows); }
  void assemble(ElasticSystem& system, const ImplicitStep& step) const {
    system.assemble(step, law(), rest_elements, states, positions, masses);
  }
  SolveReport solve(ElasticSystem& system, const ImplicitStep& step) {
    return system.solve(step, positions, forces, masses, constraints, velocities);
  }
};

}  // namespace griffith::testing
