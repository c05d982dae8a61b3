#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "sim/core/parallel.h"
#include "sim/core/rotation.h"
#include "sim/elasticity/quadratic_element.h"
#include "sim/solver/conjugate_gradient.h"
#include "sim/solver/contact_problem.h"
#include "sim/solver/contact_response.h"
#include "sim/solver/dense_cholesky.h"
#include "sim/solver/touched_inverse.h"
#include "tests/random_values.h"
#include "tests/solver/quadratic_strip.h"

namespace griffith {
namespace {

using testing::QuadraticStrip;
using testing::RandomValues;

constexpr double kLongStep = 1e-2;

NodeVectors random_columns(RandomValues& random, int count) {
  NodeVectors v(3, count);
  for (int i = 0; i < count; ++i) v.col(i) = random.vector();
  return v;
}

/// Iterations of conjugate gradients for random impulses on a strip.
int iterations_on(const QuadraticStrip& strip, double tolerance = 1e-8) {
  RandomValues random(3);
  const ElasticSystem& system = *strip.system;
  const NodeVectors b = random_columns(random, system.rows());
  NodeVectors x = NodeVectors::Zero(3, system.rows());
  const SolveReport report =
      conjugate_gradient(system.matrix(), {system.preconditioner(), system.factors()}, b, x, tolerance, b.norm(), 2000);
  EXPECT_TRUE(report.converged);
  return report.iterations;
}

TEST(DenseCholesky, FactorsPanelsAndLeavesTheSchurComplement) {
  RandomValues random(1);
  for (const int columns : {1, 3, 4, 23, 24, 25, 60, 101}) {
    const int rows = columns + columns / 2;
    Eigen::MatrixXd half(rows, rows);
    for (double& entry : half.reshaped()) entry = random.uniform(-1, 1);
    const Eigen::MatrixXd a = half * half.transpose() + Eigen::MatrixXd::Identity(rows, rows);
    Eigen::MatrixXd panel = a.leftCols(columns);
    ASSERT_TRUE(factor_panel({panel.data(), rows, columns, rows}));
    const Eigen::MatrixXd lower = Eigen::MatrixXd(a.llt().matrixL());
    for (int j = 0; j < columns; ++j)
      EXPECT_LT((panel.col(j) - lower.col(j)).tail(rows - j).norm(), 1e-10 * a.norm()) << columns << ' ' << j;

    const int rest = rows - columns;
    Eigen::MatrixXd remainder = a.bottomRightCorner(rest, rest);
    subtract_square({remainder.data(), rest, rest, rest}, {panel.data() + columns, rest, columns, rows});
    const Eigen::MatrixXd below = lower.bottomRightCorner(rest, rest), expected = below * below.transpose();
    for (int j = 0; j < rest; ++j)
      EXPECT_LT((remainder.col(j) - expected.col(j)).tail(rest - j).norm(), 1e-10 * a.norm());
  }
}

TEST(DenseCholesky, RefusesWhatIsNotPositive) {
  Eigen::MatrixXd indefinite = Eigen::MatrixXd::Identity(30, 30);
  indefinite(27, 27) = -1;
  EXPECT_FALSE(factor_panel({indefinite.data(), 30, 30, 30}));
}

TEST(EliminationPlan, NumbersEachRowOnceAndCoversTheFactor) {
  QuadraticStrip strip(false);
  const EliminationPlan plan = plan_elimination(strip.system->matrix());
  std::vector<int> places = plan.places;
  std::ranges::sort(places);
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(places[i], static_cast<int>(i));
  int next = 0;
  for (std::size_t f = 0; f < plan.fronts.size(); ++f) {
    const Front& front = plan.fronts[f];
    EXPECT_EQ(front.first, next);
    next += front.columns;
    EXPECT_EQ(front.parent < 0, front.below.empty());
    if (front.parent < 0) continue;
    EXPECT_GT(front.parent, static_cast<int>(f));
    const Front& parent = plan.fronts[front.parent];
    for (const int place : front.below)
      EXPECT_TRUE(place < parent.first + parent.columns || std::ranges::binary_search(parent.below, place));
  }
  EXPECT_EQ(next, strip.system->rows());
}

TEST(FactorPreconditioner, IsTheInverseOfTheMatrixThatItWasMadeOf) {
  for (const bool held : {false, true}) {
    QuadraticStrip strip(held);
    strip.assemble();
    ASSERT_TRUE(strip.system->factors() && strip.system->factors()->exists());
    RandomValues random(2);
    const NodeVectors expected = random_columns(random, strip.system->rows());
    NodeVectors product, found;
    multiply(strip.system->matrix(), expected, product);
    const double energy = strip.system->factors()->apply(product, found);
    EXPECT_LT((found - expected).norm(), 1e-5 * expected.norm());
    EXPECT_NEAR(energy, dot(expected, product), 1e-9 * energy);
    EXPECT_LE(iterations_on(strip), 3);
  }
}

TEST(FactorPreconditioner, TurnsWithTheBody) {
  QuadraticStrip strip(false);
  strip.assemble();
  const Mat3 turn = rotation_by(Vec3(0.4, 1.1, -0.7)).toRotationMatrix();
  strip.move([&](const Vec3& place) { return Vec3(turn * place + Vec3(3, 4, 5)); });
  strip.assemble();
  EXPECT_EQ(strip.system->factors()->factorization_count(), 1);
  EXPECT_LE(iterations_on(strip), 4);
}

TEST(FactorPreconditioner, IsMadeAnewWhereElementsTurnedOrTheStepChanged) {
  QuadraticStrip strip(false);
  strip.assemble();
  strip.move([](const Vec3& place) { return Vec3(place + 1e-3 * Vec3(0, place.x() * place.x(), 0)); });
  strip.assemble();
  EXPECT_EQ(strip.system->factors()->factorization_count(), 1) << "a little bent";
  EXPECT_LE(iterations_on(strip), 40);
  strip.move([](const Vec3& place) { return Vec3(place + 0.2 * Vec3(0, place.x() * place.x(), 0)); });
  strip.assemble();
  EXPECT_EQ(strip.system->factors()->factorization_count(), 2) << "much bent";
  EXPECT_LE(iterations_on(strip), 3);
  strip.assemble(kLongStep / 3);
  EXPECT_EQ(strip.system->factors()->factorization_count(), 3) << "another step";
  EXPECT_LE(iterations_on(strip), 3);
}

TEST(FactorPreconditioner, IterationsDoNotGrowWithTheAspect) {
  for (const double thickness : {0.2, 0.05, 0.0125}) {
    QuadraticStrip strip(true, Vec3(2, thickness, 0.4), Vec3(0.2, thickness, 0.2));
    strip.assemble(0.1);
    EXPECT_LE(iterations_on(strip), 4) << thickness;
  }
}

TEST(FactorPreconditioner, GivesTheSameBitsOnAnyNumberOfThreads) {
  std::vector<NodeVectors> found;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    QuadraticStrip strip(false, Vec3(2, 0.2, 1), Vec3(0.1, 0.1, 0.1));
    strip.assemble();
    RandomValues random(4);
    strip.system->factors()->apply(random_columns(random, strip.system->rows()), found.emplace_back());
  }
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(found[0], found[2]);
}

/// Contacts of unit axes at rows.
std::vector<FrictionContact> contacts_at(std::span<const int> rows) {
  std::vector<FrictionContact> contacts(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ContactSide& side = contacts[i].a;
    side.body = 0;
    side.deformable = true;
    side.point = {{rows[i], -1, -1}, {Mat3::Identity(), Mat3::Zero(), Mat3::Zero()}};
  }
  return contacts;
}

/// Impulses on touched rows move them as far as the whole matrix says.
TEST(TouchedInverse, CondensesTheMatrixExactly) {
  for (const bool held : {false, true}) {
    QuadraticStrip strip(held, Vec3(0.4, 0.05, 0.4));
    strip.assemble();
    const DeformableInertia body{.matrix = &strip.system->matrix(),
                                 .preconditioner = &strip.system->preconditioner(),
                                 .whole = held ? WholeMotion{} : strip.whole(),
                                 .factors = strip.system->factors()};
    const std::vector<int> touched = {0, 3, strip.system->rows() - 1};
    const TouchedInverse inverse(body, touched);
    ASSERT_EQ(inverse.size(), 3 * 3 + (held ? 0 : 6));
    ContactJacobian to_rows;
    for (const FrictionContact& contact : contacts_at(touched)) {
      inverse.add_side(contact.a, Mat3::Identity(), 0, to_rows);
      to_rows.finish_contact();
    }
    RandomValues random(6);
    const Eigen::Matrix3Xd impulses = random_columns(random, 3);
    Eigen::VectorXd on_unknowns = Eigen::VectorXd::Zero(inverse.size());
    to_rows.add_transposed(impulses, on_unknowns);
    Eigen::VectorXd change = on_unknowns;
    change.head(inverse.rows()) = inverse.stiffness().llt().solve(on_unknowns.head(inverse.rows()));
    EXPECT_LT((inverse.multiply(change) - on_unknowns).norm(), 1e-6 * on_unknowns.norm());
    const Eigen::Matrix3Xd moved = to_rows.multiply(change);

    NodeVectors on_rows = NodeVectors::Zero(3, body.rows());
    for (int i = 0; i < 3; ++i) on_rows.col(touched[i]) = impulses.col(i);
    const NodeVectors exact = respond_alone(body, on_rows, 1e-10, 100);
    for (int i = 0; i < 3; ++i)
      EXPECT_LT((moved.col(i) - exact.col(touched[i])).norm(), 1e-3 * exact.col(touched[i]).norm()) << held;
  }
}

/// A condensed body answers contacts as it does with all of its rows, however old its factors are.
TEST(TouchedInverse, ContactsAreThoseOfAllRows) {
  for (const double bend : {0.0, 5e-3, 2e-2}) {
    QuadraticStrip strip(false, Vec3(1, 0.05, 0.4));
    strip.assemble();
    strip.move([&](const Vec3& place) { return Vec3(place + bend * Vec3(0, place.x() * place.x(), 0)); });
    strip.assemble();
    EXPECT_EQ(strip.system->factors()->factorization_count(), 1);
    const DeformableInertia condensed{.matrix = &strip.system->matrix(),
                                      .preconditioner = &strip.system->preconditioner(),
                                      .whole = strip.whole(),
                                      .factors = strip.system->factors()};
    DeformableInertia all_rows = condensed;
    all_rows.factors = nullptr;
    const ContactTolerance tolerance{.relative = 1e-6, .negligible_speed = 1e-12, .max_iterations = 20000};
    std::vector<Eigen::Matrix3Xd> impulses;
    std::vector<NodeVectors> changes;
    for (const DeformableInertia& body : {condensed, all_rows}) {
      std::vector<FrictionContact> contacts = contacts_at(std::vector<int>{0, 5, 9, 20});
      for (FrictionContact& contact : contacts) {
        contact.axes << Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX();
        contact.friction = 0.4;
        contact.free_velocity = Vec3(-1, 0.3, 0.1);
      }
      EXPECT_EQ(solve_contact_problem({&body, 1}, {}, contacts, tolerance, changes).unconverged, 0) << bend;
      impulses.emplace_back(3, 4);
      for (int i = 0; i < 4; ++i) impulses.back().col(i) = contacts[i].impulse;
    }
    EXPECT_LT((impulses[0] - impulses[1]).norm(), 1e-3 * impulses[1].norm()) << bend;
  }
}

}  // namespace
}  // namespace griffith
