#pragma once

#include <span>

#include "sim/fracture/split.h"
#include "sim/mesh/bisect.h"
#include "sim/mesh/topology.h"
#include "tests/random_values.h"

namespace griffith::testing {

/// A mesh of density 1 whose nodes have positions, velocities and masses that follow every split and bisection.
struct MovingMesh {
  TetMesh mesh;
  std::vector<Vec3> positions, velocities;
  std::vector<double> masses;

  /// Nodes up to `noise` [m] off their rest positions, with random velocities.
  MovingMesh(const TetSoup& soup, unsigned seed, double noise)
      : mesh(build_mesh(soup)), positions(mesh.rest_positions) {
    RandomValues random(seed);
    for (Vec3& position : positions) position += random.vector(noise);
    for (std::size_t i = 0; i < positions.size(); ++i) velocities.push_back(random.vector());
    for (int node = 0; node < mesh.node_count(); ++node) masses.push_back(lumped_mass(NodeId(node)));
  }
  double lumped_mass(NodeId node) const {
    double mass = 0;
    for (TetId tet : mesh.stars[node]) mass += rest_volume(mesh, tet) / 4;
    return mass;
  }
  void follow(std::span<const NodeCopy> copies) {
    for (const NodeCopy& copy : copies) {
      positions.push_back(Vec3(positions[copy.original]));
      velocities.push_back(Vec3(velocities[copy.original]));
    }
    update_masses();
  }
  void follow(const Subdivision& subdivision) {
    for (const EdgeNode& node : subdivision.nodes) {
      positions.push_back(node.interpolate(positions[node.a], positions[node.b]));
      velocities.push_back(node.interpolate(velocities[node.a], velocities[node.b]));
    }
    update_masses();
  }

 private:
  void update_masses() {
    masses.resize(mesh.node_count());
    for (int node = 0; node < mesh.node_count(); ++node) masses[node] = lumped_mass(NodeId(node));
  }
};

/// Volume, mass, first moment of mass, momentum, angular momentum and kinetic energy, in this order.
inline Eigen::VectorXd conserved(const MovingMesh& body) {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(12);
  for (int t = 0; t < body.mesh.tet_count(); ++t) sums[0] += rest_volume(body.mesh, TetId(t));
  for (std::size_t i = 0; i < body.masses.size(); ++i) {
    sums[1] += body.masses[i];
    sums.segment<3>(2) += body.masses[i] * body.positions[i];
    sums.segment<3>(5) += body.masses[i] * body.velocities[i];
    sums.segment<3>(8) += body.masses[i] * body.positions[i].cross(body.velocities[i]);
    sums[11] += 0.5 * body.masses[i] * body.velocities[i].squaredNorm();
  }
  return sums;
}

}  // namespace griffith::testing
