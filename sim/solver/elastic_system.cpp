#include "sim/solver/elastic_system.h"

#include <algorithm>
#include <cmath>

#include "sim/parallel.h"
#include "sim/solver/rigid_motion.h"

namespace griffith {
namespace {

constexpr int kAggregateSize = 60;

std::vector<NodeId> nodes_of(const TetMesh& mesh, std::span<const TetId> tets) {
  std::vector<NodeId> nodes;
  nodes.reserve(4 * tets.size());
  for (TetId tet : tets) nodes.insert(nodes.end(), mesh.tets[tet].begin(), mesh.tets[tet].end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// What spinning does to the shape, seen by a body that turns along: h·m ω×(a×ω) for a node at arm a.
void add_centrifugal_impulses(const RigidMotion& motion, const NodeVectors& positions, const Eigen::VectorXd& masses,
                              double dt, NodeVectors& impulses) {
  const Vec3& spin = motion.angular_velocity;
  for (Eigen::Index row = 0; row < masses.size(); ++row) {
    const Vec3 arm = positions.col(row) - motion.center;
    impulses.col(row) += dt * masses[row] * spin.cross(arm.cross(spin));
  }
}

}  // namespace

ElasticSystem::ElasticSystem(const TetMesh& mesh, std::span<const TetId> tets, std::span<const std::uint8_t> held,
                             std::span<int> row_of_node) {
  for (NodeId node : nodes_of(mesh, tets)) {
    row_of_node[node] = held[node] ? -1 : static_cast<int>(nodes_.size());
    if (held[node]) {
      ++held_count_;
    } else {
      nodes_.push_back(node);
    }
  }
  build_pattern(mesh, row_of_node);
  preconditioner_ = std::make_unique<RigidModePreconditioner>(matrix_, kAggregateSize);
}

void ElasticSystem::build_pattern(const TetMesh& mesh, std::span<const int> row_of_node) {
  std::vector<int> columns;
  entry_starts_ = {0};
  for (NodeId node : nodes_) {
    columns.clear();
    for (TetId tet : mesh.stars[node])
      for (NodeId corner : mesh.tets[tet])
        if (row_of_node[corner] >= 0) columns.push_back(row_of_node[corner]);
    std::sort(columns.begin(), columns.end());
    columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
    matrix_.columns.insert(matrix_.columns.end(), columns.begin(), columns.end());
    matrix_.row_starts.push_back(static_cast<int>(matrix_.columns.size()));

    const int row = matrix_.rows() - 1;
    for (TetId tet : mesh.stars[node]) {
      RowEntry entry{tet, 0, {}};
      for (int i = 0; i < 4; ++i) {
        const NodeId corner = mesh.tets[tet][i];
        if (corner == node) entry.corner = i;
        entry.slots[i] = row_of_node[corner] < 0 ? -1 : matrix_.slot(row, row_of_node[corner]);
      }
      entries_.push_back(entry);
    }
    entry_starts_.push_back(static_cast<int>(entries_.size()));
  }
  matrix_.blocks.resize(matrix_.columns.size());
}

void ElasticSystem::assemble(const ImplicitStep& step, const ElasticModuli& moduli, std::span<const ElementRest> rests,
                             std::span<const ElementState> states, std::span<const Vec3> positions,
                             std::span<const double> masses) {
  const double mass_factor = 1 + step.dt * step.mass_damping;
  const double stiffness_factor = step.dt * (step.dt + step.stiffness_damping);
  parallel_for(matrix_.rows(), 256, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      for (int k = matrix_.row_starts[row]; k < matrix_.row_starts[row + 1]; ++k) matrix_.blocks[k].setZero();
      for (int e = entry_starts_[row]; e < entry_starts_[row + 1]; ++e) {
        const RowEntry& entry = entries_[e];
        const ElementRest& rest = rests[entry.tet];
        const Corners gradients = states[entry.tet].rotation * rest.shape_gradients;
        const double factor = stiffness_factor * rest.volume;
        for (int i = 0; i < 4; ++i)
          if (entry.slots[i] >= 0)
            matrix_.blocks[entry.slots[i]] +=
                factor * stiffness_block(moduli, gradients.col(entry.corner), gradients.col(i));
      }
      matrix_.blocks[matrix_.slot(row, row)].diagonal().array() += mass_factor * masses[nodes_[row]];
    }
  });
  preconditioner_->update(matrix_, gather(positions));
}

NodeVectors ElasticSystem::gather(std::span<const Vec3> values) const {
  NodeVectors gathered(3, nodes_.size());
  for (std::size_t row = 0; row < nodes_.size(); ++row) gathered.col(row) = values[nodes_[row]];
  return gathered;
}

SolveReport ElasticSystem::solve(const ImplicitStep& step, std::span<const Vec3> positions,
                                 std::span<const Vec3> forces, std::span<const double> masses,
                                 std::span<Vec3> velocities) const {
  const int count = static_cast<int>(nodes_.size());
  if (count == 0) return {};
  Eigen::VectorXd mass(count);
  for (int row = 0; row < count; ++row) mass[row] = masses[nodes_[row]];
  const NodeVectors old_velocities = gather(velocities);
  const NodeVectors b = old_velocities * mass.asDiagonal() + step.dt * gather(forces);

  NodeVectors x = old_velocities;
  const SolveReport report =
      is_free() ? solve_free(step, gather(positions), mass, b, x)
                : conjugate_gradient(matrix_, *preconditioner_, b, x, step.relative_residual, std::sqrt(dot(b, b)),
                                     step.max_iterations);
  for (int row = 0; row < count; ++row) velocities[nodes_[row]] = x.col(row);
  return report;
}

SolveReport ElasticSystem::solve_free(const ImplicitStep& step, const NodeVectors& positions,
                                      const Eigen::VectorXd& masses, const NodeVectors& b, NodeVectors& x) const {
  // The rigid motion follows from momentum balance alone, so only the deformation is solved for: no residual can slow
  // a fall, and convergence is relative to what is elastic.
  const auto rigid_field = [&](const NodeVectors& velocities) {
    const RigidMotion motion = rigid_motion(positions, velocities, masses);
    NodeVectors field(3, positions.cols());
    for (Eigen::Index row = 0; row < field.cols(); ++row) field.col(row) = motion.velocity_at(positions.col(row));
    return field;
  };
  const Eigen::VectorXd inverse_masses = (masses * (1 + step.dt * step.mass_damping)).cwiseInverse();
  const NodeVectors rigid = rigid_field(b * inverse_masses.asDiagonal());
  NodeVectors product;
  multiply(matrix_, rigid, product);
  NodeVectors elastic = b - product;
  add_centrifugal_impulses(rigid_motion(positions, rigid, masses), positions, masses, step.dt, elastic);

  constexpr double kRounding = 1e-9;  // of the whole right-hand side: below it there is only noise to solve for
  const double scale = std::max(std::sqrt(dot(elastic, elastic)), kRounding * std::sqrt(dot(b, b)));
  x -= rigid_field(x);
  const SolveReport report =
      conjugate_gradient(matrix_, *preconditioner_, elastic, x, step.relative_residual, scale, step.max_iterations);
  x += rigid - rigid_field(x);
  return report;
}

}  // namespace griffith
