#pragma once

#include <optional>

#include "sim/mesh/tet_edges.h"
#include "tests/solver/elastic_box.h"

namespace griffith::testing {

/// A box of quadratic elements, by default a strip one element thick.
struct QuadraticStrip {
  ElasticBox body;
  TetEdges topology;
  std::vector<int> edge_rows;
  std::vector<double> edge_masses;
  std::optional<ElasticSystem> system;

  /// `held`: at its left end.
  explicit QuadraticStrip(bool held, const Vec3& size = Vec3(2, 0.05, 0.4),
                          const Vec3& element_size = Vec3(0.2, 0.05, 0.2))
      : body(make_box(size, element_size, BoxPattern::five_tet), 7e10) {
    add_edges(body.mesh, body.tets, topology);
    edge_rows.assign(topology.ends.size(), -1);
    edge_masses.assign(topology.ends.size(), body.masses[NodeId(0)]);
    for (const NodeId node : IdRange<NodeId>(0, body.mesh.node_count()))
      if (held && body.positions[node].x() < -size.x() / 2 + 1e-9) body.constraints[node] = NodeConstraint::held();
    system.emplace(body.mesh, topology, body.tets, body.constraints, body.constraints, body.rows, edge_rows);
  }
  void assemble(double dt = 1e-2) {
    system->assemble({.dt = dt}, body.law(), body.rest_elements, body.states, body.positions, body.masses, edge_masses);
  }
  /// Puts nodes elsewhere; edges stay straight.
  template <class Map>
  void move(const Map& map) {
    for (const NodeId node : IdRange<NodeId>(0, body.mesh.node_count()))
      body.positions[node] = map(Vec3(body.mesh.rest_positions[node]));
    body.update_states();
  }
  /// Motion of the free strip as a whole.
  WholeMotion whole() const {
    return free_motion(system->gather(body.positions),
                       Eigen::Map<const Eigen::VectorXd>(body.masses.data(), body.masses.size()));
  }
};

}  // namespace griffith::testing
