#include "sim/solver/explicit_step.h"

#include <gtest/gtest.h>

#include "sim/core/dense_algebra.h"
#include "tests/random_values.h"
#include "tests/solver/elastic_box.h"

namespace griffith {
namespace {

using testing::ElasticBox;
using testing::RandomValues;

ElasticBox vibrating_box(double amplitude) {
  RandomValues random(1);
  ElasticBox body(Vec3(2, 1, 1), 0.5, 1e7);
  for (Vec3& velocity : body.velocities) velocity = random.vector(amplitude);
  return body;
}

double frequency(ElasticBox& body) {
  ElasticSystem system = body.system();
  system.assemble(MatrixFactors{0, 1}, body.law(), body.rest_elements, body.states, body.positions, body.masses);
  return highest_frequency(system.matrix(),
                           Eigen::Map<const Eigen::VectorXd>(body.masses.data(), body.mesh.node_count()));
}

void step(ElasticBox& body, double dt) {
  std::fill(body.forces.begin(), body.forces.end(), Vec3::Zero());
  body.add_elastic_forces();
  std::vector<NodeId> nodes;
  for (int i = 0; i < body.mesh.node_count(); ++i) nodes.push_back(NodeId(i));
  explicit_step(dt, 0, nodes, body.constraints, body.masses, body.forces, body.velocities);
  for (NodeId node : nodes) body.positions[node] += dt * body.velocities[node];
  body.update_states();
}

double energy(const ElasticBox& body) {
  double sum = 0;
  for (std::size_t i = 0; i < body.masses.size(); ++i) sum += 0.5 * body.masses[i] * body.velocities[i].squaredNorm();
  for (TetId tet : body.tets) sum += body.rest_elements[tet].volume * body.states[tet].energy_density;
  return sum;
}

TEST(ExplicitStep, TheHighestFrequencyIsTheDenseOne) {
  ElasticBox body(Vec3(2, 1, 1), 0.5, 1e7);
  ElasticSystem system = body.system();
  system.assemble(MatrixFactors{0, 1}, body.law(), body.rest_elements, body.states, body.positions, body.masses);
  const BlockSparseMatrix& a = system.matrix();
  Eigen::MatrixXd scaled = Eigen::MatrixXd::Zero(3 * a.rows(), 3 * a.rows());
  for (int row = 0; row < a.rows(); ++row)
    for (int k = a.row_starts[row]; k < a.row_starts[row + 1]; ++k)
      scaled.block<3, 3>(3 * row, 3 * a.columns[k]) =
          a.blocks[k] / std::sqrt(body.masses[row] * body.masses[a.columns[k]]);
  const double exact = std::sqrt(symmetric_modes(scaled).values.maxCoeff());
  EXPECT_NEAR(frequency(body), exact, 0.01 * exact);
}

TEST(ExplicitStep, IsStableAtTheStepReturnedAndNotFarAbove) {
  ElasticBox stable = vibrating_box(1e-3), unstable = stable;
  const double dt = stable_time_step(frequency(stable));
  const double start = energy(stable);
  for (int n = 0; n < 2000; ++n) step(stable, dt);
  EXPECT_LT(energy(stable), 5 * start);
  for (int n = 0; n < 60; ++n) step(unstable, 2.2 / 0.9 * dt);
  EXPECT_GT(energy(unstable), 100 * start);
}

TEST(ExplicitStep, EnergyDoesNotDriftAndMomentumIsExact) {
  ElasticBox body = vibrating_box(1e-2);
  const double dt = 0.2 * stable_time_step(frequency(body));
  Vec3 momentum = Vec3::Zero();
  for (std::size_t i = 0; i < body.masses.size(); ++i) momentum += body.masses[i] * body.velocities[i];
  const double start = energy(body);
  double worst = 0;
  for (int n = 0; n < 10'000; ++n) {
    step(body, dt);
    worst = std::max(worst, std::abs(energy(body) - start));
  }
  EXPECT_LT(worst, 0.15 * start) << "the energy swings with the step; it does not drift";
  for (std::size_t i = 0; i < body.masses.size(); ++i) momentum -= body.masses[i] * body.velocities[i];
  EXPECT_LT(momentum.norm(), 1e-8);
}

TEST(ExplicitStep, DampingShortensTheStableStep) {
  const double frequency = 1000;
  EXPECT_NEAR(stable_time_step(frequency), 0.9 * 2 / frequency, 1e-15);
  // One damped oscillator, with the damping force taken at the old velocity: v⁺ = v − h (ω² x + beta ω² v).
  const auto amplitude_after = [&](double damping, double dt) {
    double x = 1, v = 0;
    for (int n = 0; n < 2000; ++n) {
      v -= dt * frequency * frequency * (x + damping * v);
      x += dt * v;
    }
    return std::abs(x);
  };
  for (double damping : {1e-4, 1e-3, 1e-2}) {
    const double stable = stable_time_step(frequency, damping);
    EXPECT_LT(amplitude_after(damping, stable), 1.0);
    EXPECT_GT(amplitude_after(damping, 1.02 / 0.9 * stable), 1e3);
  }
}

}  // namespace
}  // namespace griffith
