#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

#include "sim/contact/contact_world.h"
#include "sim/world/world.h"
#include "tests/contact/bounces.h"
#include "tests/world/contact/contact_case.h"
#include "tests/world/contact/contact_scenes.h"
#include "tests/world/measures.h"

namespace griffith {
namespace {

constexpr double kGravity = 9.81;

Material concrete() { return find_material_preset("concrete").value(); }

const std::vector<double> kTimeSteps = {1.0 / 30, 1.0 / 60, 1.0 / 250};

struct LaidSlab {
  Vec3 size, element_size;
  std::vector<double> time_steps = kTimeSteps;  ///< those that are tried unless all contact cases are
};

std::ostream& operator<<(std::ostream& stream, const LaidSlab& slab) {
  return stream << slab.size.transpose() << " m of " << slab.element_size.x() << " m";
}

class Slab : public ::testing::TestWithParam<LaidSlab> {};

Scene laid(const LaidSlab& slab, double time_step) {
  Scene scene;
  scene.simulation.time_step = time_step;
  BodyDescription body;
  body.shape = BoxShape{slab.size, slab.element_size, BoxPattern::five_tet};
  body.position = Vec3(0, slab.size.y() / 2, 0);
  body.material = concrete();
  scene.bodies = {body};
  return scene;
}

// Carried by four corners, the largest would bend to 17 MPa.
TEST_P(Slab, LaidOnTheGroundCarriesItsWeightAloneAndSleeps) {
  for (double time_step : testing::all_contact_cases() ? kTimeSteps : GetParam().time_steps) {
    World world(laid(GetParam(), time_step));
    const double weight = concrete().density * kGravity * GetParam().size.y();  // per area, at the foot [Pa]
    double deepest = 0, stress = 0;
    while (world.frame().time < 3 && world.frame().report.sleeping_bodies == 0) {
      world.step();
      for (const Vec3& position : world.frame().nodes.positions) deepest = std::max(deepest, -position.y());
      if (!world.frame().bodies[0].rigid) stress = std::max(stress, testing::largest_stress(world.frame()));
    }
    const auto where = [&] { return ::testing::Message() << "time step " << time_step; };
    EXPECT_EQ(world.frame().report.sleeping_bodies, 1) << where();
    EXPECT_EQ(world.frame().bodies.size(), 1u) << where();
    EXPECT_LT(deepest, 1e-4) << where();
    EXPECT_GT(stress, 0.5 * weight) << where();
    EXPECT_LT(stress, 2 * weight + 0.01 * concrete().tensile_strength) << where();
  }
}

/// Three slabs on two meshes. In steps of each length on the coarse one; on the fine one, whose steps take ten times as
/// long, in steps of another length for each slab.
INSTANTIATE_TEST_SUITE_P(Sizes, Slab,
                         ::testing::Values(LaidSlab{Vec3(12, 0.15, 12), Vec3(1.5, 0.15, 1.5)},
                                           LaidSlab{Vec3(12, 0.15, 12), Vec3(0.75, 0.15, 0.75), {1.0 / 60}},
                                           LaidSlab{Vec3(4, 0.1, 4), Vec3(0.5, 0.1, 0.5)},
                                           LaidSlab{Vec3(4, 0.1, 4), Vec3(0.25, 0.1, 0.25), {1.0 / 30}},
                                           LaidSlab{Vec3(2, 0.5, 2), Vec3::Constant(0.5)},
                                           LaidSlab{Vec3(2, 0.5, 2), Vec3::Constant(0.25), {1.0 / 250}}));

/// Two equal bars that meet end to end in weightless space, each at `speed` [m/s]. Without lateral strain they are bars
/// of the textbook: pressed by ρcv, they part after a wave has run to their ends and back, with each other's velocity.
struct Bars {
  static constexpr double kLength = 2, kWidth = 0.2, kGap = 2e-4, kSpeed = 1;
  Scene scene;
  double wave_speed, impact_stress;

  /// `shifted`: the first against the second, sideways [m].
  Bars(Integrator integrator, int cells, double shifted = 0) {
    Material material = concrete();
    material.poisson_ratio = 0;
    wave_speed = bar_wave_speed(material);
    impact_stress = material.density * wave_speed * kSpeed;
    scene.gravity.setZero();
    scene.ground.reset();
    scene.simulation.fracture = false;
    scene.simulation.integrator = integrator;
    scene.simulation.time_step = std::max(1e-5, 0.2 * kWidth / cells / wave_speed);
    scene.simulation.step_budget = 1e5;
    for (int side : {-1, 1}) {
      BodyDescription bar;
      bar.name = side < 0 ? "left" : "right";
      bar.shape = BoxShape{Vec3(kLength, kWidth, kWidth), Vec3::Constant(kWidth / cells), BoxPattern::five_tet};
      bar.elements = ElementOrder::linear;
      bar.position = Vec3(side * (kLength + kGap) / 2, side < 0 ? shifted : 0, 0);
      bar.velocity = Vec3(-side * kSpeed, 0, 0);
      bar.material = material;
      scene.bodies.push_back(bar);
    }
  }

  bool at_face(const Frame& frame, const std::array<NodeId, 4>& tet) const {
    return std::ranges::any_of(
        tet, [&](NodeId node) { return std::abs(std::abs(frame.nodes.rest_positions[node].x()) - kGap / 2) < 1e-9; });
  }
};

struct BarsCase {
  Integrator integrator;
  int cells;
};

std::ostream& operator<<(std::ostream& stream, const BarsCase& test) {
  return stream << (test.integrator == Integrator::hybrid ? "hybrid, " : "implicit, ") << test.cells << " cells across";
}

class BarImpact : public ::testing::TestWithParam<BarsCase> {};

TEST_P(BarImpact, PressesTheFacesEvenlyAndExchangesMomentum) {
  const Bars bars(GetParam().integrator, GetParam().cells);
  const double transit = Bars::kLength / bars.wave_speed;
  World world(bars.scene);
  const double momentum = world.frame().totals.mass / 2 * Bars::kSpeed;
  double tension = 0, pressure = 0, met = -1, parted = -1;
  while (world.frame().time < Bars::kGap / 2 / Bars::kSpeed + 4 * transit) {
    world.step();
    const Frame frame = world.frame();
    double mean = 0, worst = 0;
    int count = 0;
    for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet) {
      if (!bars.at_face(frame, frame.elements.tets[tet])) continue;
      mean += frame.elements.stresses[tet](0, 0);
      worst = std::max(worst, frame.elements.stresses[tet](0, 0));
      ++count;
    }
    mean /= count;
    const bool pressed = mean < -0.5 * bars.impact_stress;
    if (pressed && met < 0) met = frame.time;
    if (pressed) parted = frame.time;
    if (pressed) tension = std::max(tension, worst);
    pressure = std::max(pressure, -mean);
    ASSERT_LT(frame.totals.momentum.norm(), 1e-6 * momentum);
  }
  EXPECT_LT(tension, 0.1 * bars.impact_stress);
  EXPECT_NEAR(pressure, bars.impact_stress, 0.12 * bars.impact_stress);
  // Implicit Euler damps the waves; a bar of ten cells smears them.
  const bool resolved = GetParam().integrator == Integrator::hybrid;
  const double lost = resolved ? 0.1 : 0.25;
  EXPECT_NEAR(parted - met, 2 * transit, (resolved && GetParam().cells > 1 ? 0.05 : 0.13) * 2 * transit);
  EXPECT_NEAR(world.frame().bodies[0].velocity.x(), -Bars::kSpeed, lost * Bars::kSpeed);
  EXPECT_NEAR(world.frame().bodies[1].velocity.x(), Bars::kSpeed, lost * Bars::kSpeed);
}

/// Corners that meet corners lie behind the sides of the bar, too, by next to nothing: they are touched by its end.
TEST(EdgesOfBars, DoNotHaveToMeetExactly) {
  const auto kinetic_energy_after = [](double shifted) {
    const Bars bars(Integrator::hybrid, 1, shifted);
    World world(bars.scene);
    while (world.frame().time < Bars::kGap / 2 / Bars::kSpeed + 4 * Bars::kLength / bars.wave_speed) world.step();
    return world.frame().totals.kinetic_energy;
  };
  const double aligned = kinetic_energy_after(0);
  for (const double shifted : {1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2})
    EXPECT_NEAR(kinetic_energy_after(shifted), aligned, 0.02 * aligned) << shifted << " m";
}

INSTANTIATE_TEST_SUITE_P(Meshes, BarImpact,
                         ::testing::Values(BarsCase{Integrator::implicit, 1}, BarsCase{Integrator::implicit, 2},
                                           BarsCase{Integrator::implicit, 3}, BarsCase{Integrator::hybrid, 1},
                                           BarsCase{Integrator::hybrid, 2}, BarsCase{Integrator::hybrid, 3}));

/// A ball on level ground.
Scene ball(const Vec3& position, double speed, double restitution, double time_step) {
  Scene scene;
  scene.simulation.time_step = time_step;
  scene.ground->restitution = restitution;
  ProjectileBurst shot;
  shot.position = position;
  shot.direction = Vec3::UnitX();
  shot.speed = speed;
  shot.radius = 0.1;
  shot.mass = 5;
  shot.restitution = restitution;
  scene.projectiles = {shot};
  return scene;
}

TEST(Bounces, RiseNoHigherThanTheSquareOfTheirRestitution) {
  for (double restitution : {0.3, 0.6, 0.9, 1.0})
    for (double time_step : {1.0 / 30, 1.0 / 60, 1.0 / 120, 1.0 / 250, 1e-3}) {
      World world(ball(Vec3(0, 1.1, 0), 0, restitution, time_step));
      double drop = 1;
      testing::BounceTops tops;
      // What rises less than it falls in a step is at rest.
      while (world.frame().time < 4 && tops.count() < 5 &&
             restitution * restitution * drop > kGravity * time_step * time_step) {
        world.step();
        const ProjectileView& view = world.frame().projectiles[0];
        const std::optional<double> top = tops.passed(view.position.y() - view.radius, view.velocity.y() > 0);
        if (!top) continue;
        ASSERT_LE(*top, restitution * restitution * drop * (1 + 1e-6))
            << "restitution " << restitution << ", time step " << time_step << ", bounce " << tops.count();
        drop = *top;
      }
      EXPECT_GE(tops.count(), 1);
    }
}

// Sliding friction leaves 5/7 of the speed when it has made a ball roll; then 5/7 of the resistance brakes it.
TEST(RollingBall, ComesToRestWhereItsResistanceSaysAndSleeps) {
  const double resistance = SurfaceProperties{}.rolling_resistance;
  for (double speed : {0.5, 2.0})
    for (double time_step : {1.0 / 30, 1.0 / 120}) {
      World world(ball(Vec3(0, 0.1, 0), speed, 0.1, time_step));
      const double rolling = 5.0 / 7 * speed, braking = 5.0 / 7 * resistance * kGravity;
      double stopped = 0;
      while (world.frame().time < 2 * rolling / braking + 2) {
        world.step();
        if (world.frame().projectiles[0].velocity.norm() > 0.05 * speed) stopped = world.frame().time;
      }
      EXPECT_NEAR(stopped, rolling / braking, 0.15 * rolling / braking) << speed << " m/s, time step " << time_step;
      EXPECT_NEAR(world.frame().projectiles[0].position.x(), rolling * rolling / (2 * braking),
                  0.1 * rolling * rolling / (2 * braking))
          << speed << " m/s, time step " << time_step;
      EXPECT_EQ(world.frame().projectiles[0].velocity.norm(), 0) << speed << " m/s, time step " << time_step;
    }
}

// On a slab that its weight deforms, contacts are solved with the slab. A ball that no longer slides turns as far there
// as it moves, whatever spin its resistance takes.
TEST(RollingBall, TurnsAsFarAsItMovesOnASoftSlab) {
  for (double time_step : {1.0 / 30, 1.0 / 120}) {
    Scene scene = ball(Vec3(-1, 0.3, 0), 1, 0, time_step);
    BodyDescription& slab = scene.bodies.emplace_back();
    slab.shape = BoxShape{Vec3(3, 0.2, 0.6), Vec3::Constant(0.2), BoxPattern::five_tet};
    slab.position = Vec3(0, 0.1, 0);
    slab.material = testing::unbreakable(concrete());
    slab.material.young_modulus = 3e7;
    World world(scene);
    world.step();
    const auto view = [&] { return world.frame().projectiles[0]; };
    double moved = 0, turned = 0;
    for (Vec3 place = view().position; world.frame().time < 2; place = view().position) {
      const Quat before = view().rotation;
      world.step();
      if (world.frame().time < 0.5) continue;  // it slides
      moved += (view().position - place).norm();
      turned += view().radius * before.angularDistance(view().rotation);
    }
    EXPECT_GT(moved, 0.7);
    EXPECT_NEAR(turned, moved, 1e-3 * moved) << "time step " << time_step;
  }
}

}  // namespace
}  // namespace griffith
