#include "sim/solver/static_solve.h"

#include <gtest/gtest.h>

#include "tests/random_values.h"
#include "tests/solver/elastic_box.h"

namespace griffith {
namespace {

using testing::ElasticBox;
using testing::RandomValues;

StaticReport solve(ElasticBox& body, const StaticSettings& settings = {}) {
  const StaticProblem problem{.mesh = body.mesh,
                              .tets = body.tets,
                              .rest_elements = body.rest_elements,
                              .law = elastic_law(body.material),
                              .masses = body.masses,
                              .constraints = body.constraints,
                              .loads = body.forces,
                              .evaluate = [&](std::span<const Vec3> positions, std::span<ElementState> states) {
                                for (TetId tet : body.tets) states[tet] = body.state(tet, positions);
                              }};
  return solve_static(problem, settings, body.positions, body.states);
}

/// Calls action(node) for the nodes with coordinate `axis` at `value`.
template <class Action>
void at_plane(ElasticBox& body, int axis, double value, const Action& action) {
  for (int i = 0; i < body.mesh.node_count(); ++i)
    if (std::abs(body.mesh.rest_positions[i][axis] - value) < 1e-9) action(NodeId(i));
}

/// A total force of `traction` [Pa] times area on the faces whose outward normal is `normal`, lumped as linear shape
/// functions have it.
void add_traction(ElasticBox& body, const Vec3& normal, const Vec3& traction) {
  for (const SurfaceFace& face : surface_faces(body.mesh)) {
    const auto nodes = face_nodes(body.mesh, face.tet, face.face);
    const auto& x = body.mesh.rest_positions;
    const Vec3 area = 0.5 * (x[nodes[1]] - x[nodes[0]]).cross(x[nodes[2]] - x[nodes[0]]);
    if (area.normalized().dot(normal) < 0.999) continue;
    for (NodeId node : nodes) body.forces[node] += area.norm() / 3 * traction;
  }
}

void add_gravity(ElasticBox& body, const Vec3& gravity) {
  for (std::size_t i = 0; i < body.forces.size(); ++i) body.forces[i] += body.masses[i] * gravity;
}

Vec3 sum(const std::vector<Vec3>& vectors) {
  Vec3 total = Vec3::Zero();
  for (const Vec3& v : vectors) total += v;
  return total;
}

TEST(StaticSolve, ReactionsBalanceTheLoads) {
  ElasticBox body(Vec3(1, 2, 1), 0.25, 15e9);
  at_plane(body, 1, -1, [&](NodeId node) { body.constraints[node] = NodeConstraint::held(); });
  add_gravity(body, Vec3(1, -9.81, 2));
  const StaticReport report = solve(body);
  EXPECT_TRUE(report.converged);
  EXPECT_LE(report.newton_steps, 6);
  EXPECT_LT(report.relative_residual, 1e-8);
  EXPECT_EQ(report.free_motions, 0);
  EXPECT_LT((sum(report.reaction_forces) + sum(body.forces)).norm(), 1e-7 * sum(body.forces).norm());
}

TEST(StaticSolve, APulledBarHasTheExactStressAndStrain) {
  ElasticBox body(Vec3(4, 1, 1), 0.5, 1e7);
  for (int axis = 0; axis < 3; ++axis)
    at_plane(body, axis, axis == 0 ? -2 : -0.5,
             [&](NodeId node) { body.constraints[node].block(Vec3::Unit(axis), 0); });
  const double stress = 1e4;
  add_traction(body, Vec3::UnitX(), Vec3(stress, 0, 0));
  const StaticReport report = solve(body);
  EXPECT_TRUE(report.converged);
  EXPECT_LT(report.relative_residual, 1e-9);
  const double strain = stress / body.material.young_modulus;
  const Vec3 stretch(strain, -body.material.poisson_ratio * strain, -body.material.poisson_ratio * strain);
  for (int i = 0; i < body.mesh.node_count(); ++i) {
    const Vec3 from_corner = body.mesh.rest_positions[i] - Vec3(-2, -0.5, -0.5);
    EXPECT_LT((body.positions[i] - body.mesh.rest_positions[i] - stretch.cwiseProduct(from_corner)).norm(),
              1e-6 * strain);
  }
}

TEST(StaticSolve, ACantileverBendsAsItsMeshAllows) {
  // Linear tets give .89 of Timoshenko's deflection with four 5-tet cells through the thickness.
  ElasticBox body(Vec3(10, 1, 1), 0.25, 1e9);
  body.material.poisson_ratio = 0.3;
  at_plane(body, 0, -5, [&](NodeId node) { body.constraints[node] = NodeConstraint::held(); });
  const double load = 1000;
  add_traction(body, Vec3::UnitX(), Vec3(0, -load, 0));
  EXPECT_TRUE(solve(body).converged);
  double tip = 0;
  int count = 0;
  at_plane(body, 0, 5,
           [&](NodeId node) { tip += body.mesh.rest_positions[node].y() - body.positions[node].y(), ++count; });
  const double inertia = 1.0 / 12, shear_modulus = 1e9 / 2.6, shear_factor = 10 * 1.3 / (12 + 11 * 0.3);
  const double expected = load * 1000 / (3 * 1e9 * inertia) + load * 10 / (shear_factor * shear_modulus);
  EXPECT_NEAR(tip / count / expected, 0.89, 0.02);
}

TEST(StaticSolve, FindsEquilibriumOfALargeDeflection) {
  ElasticBox body(Vec3(4, 0.5, 0.5), 0.25, 2e7);
  at_plane(body, 0, -2, [&](NodeId node) { body.constraints[node] = NodeConstraint::held(); });
  add_gravity(body, Vec3(0, -9.81, 0));
  const std::vector<Vec3> loads = body.forces;
  const StaticReport report = solve(body);
  EXPECT_TRUE(report.converged);
  double drop = 0;
  at_plane(body, 0, 2, [&](NodeId node) { drop = std::max(drop, -body.positions[node].y()); });
  EXPECT_GT(drop, 0.5) << "otherwise this tests nothing nonlinear";
  body.update_states();
  body.add_elastic_forces();
  double worst = 0, load = 0;
  for (std::size_t i = 0; i < body.forces.size(); ++i)
    if (body.constraints[i].is_free()) {
      worst = std::max(worst, body.forces[i].norm());
      load = std::max(load, loads[i].norm());
    }
  EXPECT_LT(worst, 1e-6 * load);
}

TEST(StaticSolve, PrescribedDisplacementsAreMadeAndResisted) {
  ElasticBox body(Vec3(2, 1, 1), 0.5, 1e7);
  body.material.poisson_ratio = 0;
  at_plane(body, 0, -1, [&](NodeId node) { body.constraints[node] = NodeConstraint::held(); });
  at_plane(body, 0, 1, [&](NodeId node) { body.constraints[node] = NodeConstraint::held(Vec3(0.02, 0, 0)); });
  const StaticReport report = solve(body);
  EXPECT_TRUE(report.converged);
  double pull = 0;
  for (const Vec3& reaction : report.reaction_forces) pull += std::abs(reaction.x()) / 2;
  EXPECT_NEAR(pull, 1e7 * 0.01, 1e-3);
  at_plane(body, 0, 0, [&](NodeId node) { EXPECT_NEAR(body.positions[node].x(), 0.01, 1e-9); });
}

TEST(StaticSolve, FreeFallHasNoStressAndIsReported) {
  ElasticBox body(Vec3(2, 1, 1), 0.5, 1e9);
  add_gravity(body, Vec3(0, -9.81, 0));
  const StaticReport report = solve(body);
  EXPECT_EQ(report.free_motions, 6);
  EXPECT_NEAR(report.unbalanced_fraction, 1, 1e-12);
  for (int i = 0; i < body.mesh.node_count(); ++i)
    EXPECT_LT((body.positions[i] - body.mesh.rest_positions[i]).norm(), 1e-12);
}

TEST(StaticSolve, BalancedLoadsOnAFreeBodyNeedNoSupport) {
  ElasticBox body(Vec3(4, 1, 1), 0.5, 1e7);
  add_traction(body, Vec3::UnitX(), Vec3(1e4, 0, 0));
  add_traction(body, -Vec3::UnitX(), Vec3(-1e4, 0, 0));
  const StaticReport report = solve(body);
  EXPECT_TRUE(report.converged);
  EXPECT_LT(report.unbalanced_fraction, 1e-12);
  body.update_states();
  for (TetId tet : body.tets) EXPECT_NEAR(body.states[tet].stress.full()(0, 0), 1e4, 1e-3);
}

TEST(StaticSolve, AFrictionlessBaseLeavesThreeMotionsFree) {
  ElasticBox body(Vec3(1, 1, 1), 0.25, 1e8);
  const Vec3 normal = Vec3::UnitY();
  at_plane(body, 1, -0.5, [&](NodeId node) { body.constraints[node] = NodeConstraint::sliding(normal); });
  add_gravity(body, Vec3(0, -9.81, 0));
  const StaticReport report = solve(body);
  EXPECT_EQ(report.free_motions, 3);
  EXPECT_TRUE(report.converged);
  EXPECT_LT(report.unbalanced_fraction, 1e-9);
  EXPECT_LT((sum(report.reaction_forces) + sum(body.forces)).norm(), 1e-6 * sum(body.forces).norm());
}

TEST(StaticSolve, TheFactorizationAgreesWithConjugateGradients) {
  ElasticBox a(Vec3(2, 1, 1), 0.25, 1e7), b = a;
  for (ElasticBox* body : {&a, &b}) {
    at_plane(*body, 0, -1, [&](NodeId node) { body->constraints[node] = NodeConstraint::held(); });
    at_plane(*body, 1, -0.5, [&](NodeId node) { body->constraints[node].block(Vec3::UnitY(), 0); });
    add_gravity(*body, Vec3(1, 2, 3));
  }
  EXPECT_EQ(solve(a).factorizations, 0);
  const StaticReport report = solve(b, {.max_iterations = 1});
  EXPECT_TRUE(report.converged);
  EXPECT_GT(report.factorizations, 0);
  for (std::size_t i = 0; i < a.positions.size(); ++i) EXPECT_LT((a.positions[i] - b.positions[i]).norm(), 1e-10);
}

}  // namespace
}  // namespace griffith
