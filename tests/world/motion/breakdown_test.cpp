#include <gtest/gtest.h>

#include <limits>

#include "sim/mesh/topology.h"
#include "sim/world/bodies/bodies.h"
#include "sim/world/contact/contact_phase.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/regime/regime_change.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/state/world_state.h"
#include "sim/world/step.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith::testing {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A free block that falls and has been stretched.
std::unique_ptr<WorldState> stretched_block() {
  Scene scene;
  scene.ground.reset();
  BodyDescription block;
  block.shape = BoxShape{Vec3(1, 1, 1), Vec3::Constant(0.5), BoxPattern::five_tet};
  block.position = Vec3(1, 20, 3);
  block.rotation_degrees = Vec3(20, 30, 40);
  scene.bodies = {block};
  auto world = std::make_unique<WorldState>(build_world(scene));
  for (Vec3& position : world->nodes.positions) position = Vec3(1.0001, 1, 1).cwiseProduct(position);
  update_motion(*world, world->bodies[0]);
  update_elements(*world);
  place_proxies(*world);
  return world;
}

bool all_finite(const std::vector<Vec3>& values) {
  return std::ranges::all_of(values, [](const Vec3& value) { return value.allFinite(); });
}

void expect_sound(const WorldState& world) {
  EXPECT_TRUE(all_finite(world.nodes.positions) && all_finite(world.nodes.velocities) &&
              all_finite(world.nodes.reactions));
  EXPECT_TRUE(std::isfinite(world.output.totals.elastic_energy) && std::isfinite(world.output.totals.kinetic_energy));
  for (const ElementState& state : world.elements.states)
    EXPECT_TRUE(state.stress.full().allFinite() && state.frame.allFinite());
  for (const Body& body : world.bodies)
    EXPECT_TRUE(body.motion.center.allFinite() && body.motion.inertia.allFinite() &&
                body.orientation.coeffs().allFinite());
}

TEST(Breakdown, ABodyWithoutVelocitiesGoesOnInItsShapeFromWhereItWas) {
  auto world = stretched_block();
  const std::vector<Vec3> before = world->nodes.positions;
  world->nodes.velocities[3].x() = kNan;
  freeze_if_broken_down(*world, world->bodies[0]);
  EXPECT_EQ(world->report.non_finite_values, 1);
  EXPECT_TRUE(world->bodies[0].rigid);
  EXPECT_EQ(world->nodes.positions, before);
  EXPECT_TRUE(world->bodies[0].motion.velocity.isZero(0));
  const int steps = 3;
  for (int step = 0; step < steps; ++step) advance(*world);
  expect_sound(*world);
  const double h = world->model->scene.simulation.time_step;
  const Vec3 fallen = 0.5 * world->model->scene.gravity * steps * (steps + 1) * h * h;
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT((world->nodes.positions[i] - before[i] - fallen).norm(), 1e-9)
        << "it neither jumps nor changes its shape";
}

TEST(Breakdown, ABodyWithoutPlaceGoesBackToThatOfItsProxy) {
  const auto poison_node = [](WorldState& world) { world.nodes.positions[3].x() = kNan; };
  const auto poison_motion = [](WorldState& world) { world.bodies[0].motion.center.y() = kNan; };
  const auto poison_turn = [](WorldState& world) { world.bodies[0].orientation = Quat(kNan, 0, 0, 0); };
  const auto overflow = [](WorldState& world) {
    world.nodes.positions[3].x() = 1e300;
    update_motion(world, world.bodies[0]);
  };
  const auto lose_plastic_strain = [](WorldState& world) {
    world.elements.allow_strains();
    world.elements.plastic_strains[0].setConstant(kNan);
    world.nodes.positions[0].z() = kNan;
  };
  for (const std::function<void(WorldState&)>& poison : {std::function<void(WorldState&)>(poison_node),
                                                         {poison_motion},
                                                         {poison_turn},
                                                         {overflow},
                                                         {lose_plastic_strain}}) {
    auto world = stretched_block();
    const Pose place = world->contact_world.state(world->bodies[0].proxy).pose;
    poison(*world);
    freeze_if_broken_down(*world, world->bodies[0]);
    EXPECT_EQ(world->report.non_finite_values, 1);
    for (std::size_t i = 0; i < world->nodes.positions.size(); ++i) {
      const Vec3 kept = place.to_world(world->bodies[0].orientation.conjugate() *
                                       (world->nodes.positions[i] - world->bodies[0].motion.center));
      EXPECT_LT((world->nodes.positions[i] - kept).norm(), 1e-9);
      EXPECT_LT((world->nodes.positions[i] - world->nodes.positions[0]).norm(), 1.8) << "its diagonal";
    }
    advance(*world);
    expect_sound(*world);
    EXPECT_EQ(world->report.non_finite_values, 0) << "once and for all";
  }
}

TEST(Breakdown, AMaterialBeyondAllNumbersLosesItsBodyAlone) {
  for (const Integrator integrator : {Integrator::implicit, Integrator::explicit_})
    for (const bool supported : {true, false}) {
      Scene scene;
      scene.simulation.integrator = integrator;
      scene.bodies = {wall(Vec3(1, 1, 0.5), 0.5, brick(1)), wall(Vec3(1, 1, 0.5), 0.5, brick(1))};
      scene.bodies[1].position.x() += 2;
      if (!supported) scene.bodies[0].supports.clear();
      World world(scene);
      Material absurd = brick(1);
      absurd.young_modulus = 1e306;
      if (integrator == Integrator::implicit)
        world.set_material(0, absurd);
      else
        EXPECT_THROW(world.set_material(0, absurd), InputError) << "no number of substeps is enough";
      int frozen = 0;
      for (int step = 0; step < 5; ++step) {
        world.step();
        frozen += world.frame().report.non_finite_values;
      }
      const Frame frame = world.frame();
      for (const Vec3& position : frame.nodes.positions) EXPECT_TRUE(position.allFinite());
      for (const Vec3& velocity : frame.nodes.velocities) EXPECT_TRUE(velocity.allFinite());
      EXPECT_TRUE(std::isfinite(frame.totals.elastic_energy) && std::isfinite(frame.totals.kinetic_energy));
      EXPECT_FALSE(frame.bodies[1].rigid);
      EXPECT_EQ(frame.bodies[0].rigid, frozen > 0);
      EXPECT_TRUE(frozen == 0 || integrator == Integrator::implicit);
    }
}

}  // namespace
}  // namespace griffith::testing
