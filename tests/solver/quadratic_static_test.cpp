#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <map>

#include "sim/solver/static_solve.h"
#include "tests/solver/elastic_box.h"

namespace griffith {
namespace {

using testing::ElasticBox;

/// Gradients of the shape functions of a ten-node tetrahedron (corners, then kTetEdges) at barycentric coordinates.
Eigen::Matrix<double, 3, 10> shape_gradients(const RestElement& rest, const std::array<double, 4>& l) {
  Eigen::Matrix<double, 3, 10> gradients;
  for (int i = 0; i < 4; ++i) gradients.col(i) = (4 * l[i] - 1) * rest.shape_gradients.col(i);
  for (int edge = 0; edge < 6; ++edge) {
    const auto [i, j] = kTetEdges[edge];
    gradients.col(4 + edge) = 4 * (l[i] * rest.shape_gradients.col(j) + l[j] * rest.shape_gradients.col(i));
  }
  return gradients;
}

/// Stiffness of such a tetrahedron in small strain, by the four points that integrate it exactly.
Eigen::Matrix<double, 30, 30> ten_node_stiffness(const ElasticLaw& law, const RestElement& rest) {
  constexpr double kNear = 0.5854101966249685, kFar = 0.1381966011250105;
  Eigen::Matrix<double, 30, 30> stiffness = Eigen::Matrix<double, 30, 30>::Zero();
  for (int point = 0; point < 4; ++point) {
    std::array<double, 4> l = {kFar, kFar, kFar, kFar};
    l[point] = kNear;
    const Eigen::Matrix<double, 3, 10> g = shape_gradients(rest, l);
    for (int i = 0; i < 10; ++i)
      for (int j = 0; j < 10; ++j)
        stiffness.block<3, 3>(3 * i, 3 * j) +=
            rest.volume / 4 *
            (law.lambda * g.col(i) * g.col(j).transpose() + law.mu * g.col(j) * g.col(i).transpose() +
             law.mu * g.col(i).dot(g.col(j)) * Mat3::Identity());
  }
  return stiffness;
}

/// A block held at its left end, with forces on its corners alone.
struct HeldBlock {
  ElasticBox body;
  TetEdges topology;
  std::vector<QuadraticState> states;
  std::vector<Vec3> offsets;

  HeldBlock() : body(make_box(Vec3(2, 1, 1), Vec3(0.5, 1, 1), BoxPattern::five_tet), 1e9) {
    add_edges(body.mesh, body.tets, topology);
    states.resize(body.tets.size());
    offsets.resize(topology.ends.size(), Vec3::Zero());
    for (const NodeId node : IdRange<NodeId>(0, body.mesh.node_count())) {
      const Vec3& place = body.mesh.rest_positions[node];
      if (place.x() < -1 + 1e-9) body.constraints[node] = NodeConstraint::held();
      body.forces[node] = 0.1 * Vec3(place.y(), -1 - place.x(), place.z() * place.x());
    }
  }

  StaticReport solve() {
    const auto evaluate = [&](std::span<const Vec3> positions, std::span<ElementState> means) {
      for (const TetId tet : body.tets) {
        EdgeVectors of_edges;
        for (int i = 0; i < 6; ++i) of_edges.col(i) = offsets[topology.of_tet[tet][i]];
        const QuadraticStates found =
            quadratic_states(body.law(), body.rest_elements[tet], body.corners(tet, positions), of_edges);
        means[tet] = found.mean;
        states[tet] = found.state;
      }
    };
    const StaticProblem problem{.mesh = body.mesh,
                                .tets = body.tets,
                                .rest_elements = body.rest_elements,
                                .law = body.law(),
                                .masses = body.masses,
                                .constraints = body.constraints,
                                .loads = body.forces,
                                .evaluate = evaluate,
                                .edges = StaticEdges{topology, offsets, states}};
    return solve_static(problem, {}, body.positions, body.states);
  }

  /// Displacements of all nodes, and of the middles of all edges, by ten-node elements and a dense factorisation.
  Eigen::Matrix3Xd ten_node_displacements() const {
    const int nodes = body.mesh.node_count(), count = nodes + topology.edge_count();
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(3 * count, 3 * count);
    Eigen::VectorXd loads = Eigen::VectorXd::Zero(3 * count);
    for (const TetId tet : body.tets) {
      const Eigen::Matrix<double, 30, 30> of_tet = ten_node_stiffness(body.law(), body.rest_elements[tet]);
      std::array<int, 10> rows;
      for (int i = 0; i < 4; ++i) rows[i] = body.mesh.tets[tet][i].index();
      for (int i = 0; i < 6; ++i) rows[4 + i] = nodes + topology.of_tet[tet][i].index();
      for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j)
          stiffness.block<3, 3>(3 * rows[i], 3 * rows[j]) += of_tet.block<3, 3>(3 * i, 3 * j);
    }
    const auto hold = [&](int row) {
      loads.segment<3>(3 * row).setZero();
      stiffness.middleRows<3>(3 * row).setZero();
      stiffness.middleCols<3>(3 * row).setZero();
      stiffness.block<3, 3>(3 * row, 3 * row) = 1e9 * Mat3::Identity();
    };
    const auto is_held = [&](NodeId node) { return body.constraints[node].is_held(); };
    for (int i = 0; i < nodes; ++i) loads.segment<3>(3 * i) = body.forces[i];
    for (int i = 0; i < nodes; ++i)
      if (is_held(NodeId(i))) hold(i);
    for (int i = 0; i < topology.edge_count(); ++i)
      if (is_held(topology.ends[i][0]) && is_held(topology.ends[i][1])) hold(nodes + i);
    const Eigen::VectorXd solution = stiffness.llt().solve(loads);
    return solution.reshaped(3, count);
  }
};

TEST(QuadraticStaticSolve, IsThatOfTenNodeTetrahedra) {
  HeldBlock block;
  const StaticReport report = block.solve();
  EXPECT_TRUE(report.converged);
  const Eigen::Matrix3Xd exact = block.ten_node_displacements();
  const int nodes = block.body.mesh.node_count();
  double largest = 0;
  for (int i = 0; i < nodes; ++i) largest = std::max(largest, exact.col(i).norm());
  EXPECT_GT(largest, 1e-10);
  for (int i = 0; i < nodes; ++i)
    EXPECT_LT((block.body.positions[i] - block.body.mesh.rest_positions[i] - exact.col(i)).norm(), 1e-6 * largest);
  for (int i = 0; i < block.topology.edge_count(); ++i) {
    const auto& [a, b] = block.topology.ends[i];
    const Vec3 offset = exact.col(nodes + i) - 0.5 * (exact.col(a.index()) + exact.col(b.index()));
    EXPECT_LT((block.offsets[i] - offset).norm(), 1e-6 * largest);
  }
}

TEST(QuadraticStaticSolve, ReactionsBalanceTheLoads) {
  HeldBlock block;
  const StaticReport report = block.solve();
  Vec3 sum = Vec3::Zero();
  double size = 0;
  for (const Vec3& reaction : report.reaction_forces) sum += reaction;
  for (const NodeId node : IdRange<NodeId>(0, block.body.mesh.node_count()))
    sum += block.body.forces[node], size += block.body.forces[node].norm();
  EXPECT_LT(sum.norm(), 1e-6 * size);
}

TEST(EdgeConstraint, BlocksWhatBothEndsBlock) {
  const NodeConstraint held = NodeConstraint::held(), sliding = NodeConstraint::sliding(Vec3(0, 0, 2)), free;
  EXPECT_TRUE(constraint_between(held, held).is_held());
  EXPECT_TRUE(constraint_between(held, free).is_free());
  EXPECT_EQ(constraint_between(held, sliding).blocked, 1);
  EXPECT_LT((constraint_between(held, sliding).allowed - sliding.allowed).norm(), 1e-12);
  EXPECT_TRUE(constraint_between(NodeConstraint::sliding(Vec3::UnitX()), sliding).is_free());
}

}  // namespace
}  // namespace griffith
