#include "sim/contact/impulse_solver.h"

#include <gtest/gtest.h>

#include <random>

#include "sim/core/parallel.h"

namespace griffith::contact {
namespace {

constexpr SolverLimits kExact{.work = 1'000'000'000, .min_sweeps = 1, .max_sweeps = 5000, .tolerance = 1e-12};

Mat3 axes_along(const Vec3& normal) {
  Mat3 axes;
  axes << normal, normal.unitOrthogonal(), normal.cross(normal.unitOrthogonal());
  return axes;
}

SolverBody moving(double mass, const Vec3& velocity) {
  SolverBody solver_body;
  solver_body.inverse_mass = 1 / mass;
  solver_body.inverse_inertia = 10 / mass * Mat3::Identity();
  solver_body.velocity = velocity;
  return solver_body;
}

ContactConstraint touch(int a, int b, const Vec3& normal, double friction = 0) {
  ContactConstraint row;
  row.a.solver_body = a;
  row.b.solver_body = b;
  row.axes = axes_along(normal);
  row.friction = friction;
  return row;
}

/// A column of unit masses on an immovable one, all falling at 1 m/s: contact k carries what lies above it.
struct Column {
  explicit Column(int count) : solver_bodies(1) {
    for (int i = 1; i <= count; ++i) {
      solver_bodies.push_back(moving(1, -Vec3::UnitY()));
      rows.push_back(touch(i, i - 1, Vec3::UnitY()));
    }
  }
  std::vector<SolverBody> solver_bodies;
  std::vector<ContactConstraint> rows;
};

TEST(ImpulseSolver, AColumnRestsOnWhatEachContactCarries) {
  Column column(30);
  solve_impulses(column.rows, column.solver_bodies, kExact);
  for (int i = 0; i < 30; ++i) EXPECT_NEAR(column.rows[i].impulse[0], 30 - i, 1e-6);
  for (const SolverBody& solver_body : column.solver_bodies) EXPECT_LT(solver_body.velocity.norm(), 1e-7);
}

TEST(ImpulseSolver, ConjugateStepsFindTheColumnsImpulsesInFewSweeps) {
  Column column(30);  // plain sweeps are half-way by then
  solve_impulses(column.rows, column.solver_bodies, {.work = 1 << 20, .max_sweeps = 200, .tolerance = 0});
  for (int i = 0; i < 30; ++i) EXPECT_NEAR(column.rows[i].impulse[0], 30 - i, 1e-2);
}

TEST(ImpulseSolver, FrictionStopsASlideOrOpposesItWithItsLimit) {
  for (const double friction : {0.3, 0.5}) {
    std::vector<SolverBody> solver_bodies = {SolverBody{}, moving(2, Vec3(0.4, -1, 0))};
    solver_bodies[1].inverse_inertia.setZero();
    std::vector<ContactConstraint> rows = {touch(1, 0, Vec3::UnitY(), friction)};
    solve_impulses(rows, solver_bodies, kExact);
    EXPECT_NEAR(rows[0].impulse[0], 2, 1e-9);
    EXPECT_NEAR(solver_bodies[1].velocity.x(), std::max(0.0, 0.4 - friction), 1e-9) << friction;
  }
}

/// Random objects with random contacts between them and with an immovable one.
struct Heap {
  explicit Heap(int seed, double friction) : solver_bodies(1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto vector = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
    for (int i = 1; i <= 12; ++i) solver_bodies.push_back(moving(std::exp(2 * uniform(random)), vector()));
    for (int i = 0; i < 24; ++i) {
      const int a = 1 + i % 12, b = static_cast<int>(random() % 13);
      if (a == b) continue;
      rows.push_back(touch(a, b, vector().normalized(), friction));
      rows.back().a.arm = 0.2 * vector();
      rows.back().b.arm = 0.2 * vector();
    }
  }
  Vec3 velocity(const ContactConstraint& row) const {
    const auto at = [&](const ContactEnd& end) {
      const SolverBody& solver_body = solver_bodies[end.solver_body];
      return Vec3(solver_body.velocity + solver_body.angular_velocity.cross(end.arm));
    };
    return row.axes.transpose() * (at(row.a) - at(row.b));
  }
  double energy() const {
    double energy = 0;
    for (const SolverBody& solver_body : solver_bodies) {
      if (solver_body.inverse_mass == 0) continue;
      energy += 0.5 / solver_body.inverse_mass *
                (solver_body.velocity.squaredNorm() + solver_body.angular_velocity.squaredNorm() / 10);
    }
    return energy;
  }
  std::vector<SolverBody> solver_bodies;
  std::vector<ContactConstraint> rows;
};

TEST(ImpulseSolver, SolvesTheComplementarityProblem) {
  for (int seed = 0; seed < 20; ++seed) {
    Heap heap(seed, 0);
    solve_impulses(heap.rows, heap.solver_bodies, kExact);
    for (const ContactConstraint& row : heap.rows) {
      const double parting = heap.velocity(row)[0];
      EXPECT_GE(row.impulse[0], 0);
      EXPECT_GT(parting, -1e-6) << seed;
      EXPECT_LT(std::abs(parting * row.impulse[0]), 1e-6) << seed;
    }
  }
}

TEST(ImpulseSolver, KeepsToTheLimitsOfFrictionHoweverEarlyItEnds) {
  for (int seed = 0; seed < 20; ++seed)
    for (int sweeps : {1, 2, 3, 7, 200}) {
      Heap heap(seed, 0.6);
      solve_impulses(heap.rows, heap.solver_bodies, {.min_sweeps = 1, .max_sweeps = sweeps});
      for (const ContactConstraint& row : heap.rows)
        EXPECT_LE(row.impulse.tail<2>().norm(), row.friction * row.impulse[0] * (1 + 1e-12) + 1e-15);
    }
}

TEST(ImpulseSolver, AddsNoEnergy) {
  for (int seed = 0; seed < 20; ++seed) {
    Heap heap(seed, 0.6);
    const double before = heap.energy();
    solve_impulses(heap.rows, heap.solver_bodies);
    EXPECT_LE(heap.energy(), before) << seed;
  }
}

/// Adds the objects and contacts of `heap` next to the existing ones, on the same immovable one.
void append(const Heap& heap, Heap& all) {
  const int shift = static_cast<int>(all.solver_bodies.size()) - 1;
  all.solver_bodies.insert(all.solver_bodies.end(), heap.solver_bodies.begin() + 1, heap.solver_bodies.end());
  for (ContactConstraint row : heap.rows) {
    for (ContactEnd* end : {&row.a, &row.b})
      if (end->solver_body > 0) end->solver_body += shift;
    all.rows.push_back(row);
  }
}

TEST(ImpulseSolver, GroupsThatDoNotTouchDoNotKnowOfEachOtherForAnyNumberOfThreads) {
  constexpr int kHeaps = 40;
  std::vector<Vec3> alone;
  int relaxations = 0;
  for (int seed = 0; seed < kHeaps; ++seed) {
    Heap heap(seed, 0.6);
    relaxations += solve_impulses(heap.rows, heap.solver_bodies);
    for (const ContactConstraint& row : heap.rows) alone.push_back(row.impulse);
  }
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    Heap all(0, 0.6);
    for (int seed = 1; seed < kHeaps; ++seed) append(Heap(seed, 0.6), all);
    EXPECT_EQ(solve_impulses(all.rows, all.solver_bodies), relaxations);
    ASSERT_EQ(all.rows.size(), alone.size());
    for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_EQ(all.rows[i].impulse, alone[i]) << i;
  }
}

}  // namespace
}  // namespace griffith::contact
