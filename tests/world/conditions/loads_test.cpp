#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "sim/world/fracture/fracture_phase.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/state/world_state.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith::testing {
namespace {

const Region kEverything = HalfSpaceRegion{Vec3(0, -1e3, 0), Vec3::UnitY()};

Load load_of(LoadKind kind, const Region& region) {
  Load load;
  load.kind = kind;
  load.region = region;
  return load;
}

/// A world of one free body under loads; as it is built, nothing moves.
WorldState loaded(const Shape& shape, const std::vector<Load>& loads) {
  Scene scene;
  scene.ground.reset();
  scene.bodies.resize(1);
  scene.bodies[0].shape = shape;
  scene.bodies[0].position = Vec3(0.3, 2, -1);
  scene.bodies[0].rotation_degrees = Vec3(20, 40, -70);
  scene.bodies[0].loads = loads;
  WorldState world = build_world(scene);
  return world;
}

std::vector<Vec3> forces_at(const WorldState& world, double time) {
  ExternalForces forces = no_forces(world);
  add_load_forces(world, time, forces);
  return forces.nodes;
}

Vec3 resultant(const std::vector<Vec3>& forces) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& force : forces) sum += force;
  return sum;
}

/// About the world's origin.
Vec3 torque(const WorldState& world, const std::vector<Vec3>& forces) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < forces.size(); ++i) sum += world.nodes.positions[i].cross(forces[i]);
  return sum;
}

Pose pose_of(const WorldState& world) {
  const Vec3 radians = world.model->scene.bodies[0].rotation_degrees * std::numbers::pi / 180;
  return {world.model->scene.bodies[0].position,
          Quat(Eigen::AngleAxisd(radians.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(radians.y(), Vec3::UnitY()) *
               Eigen::AngleAxisd(radians.x(), Vec3::UnitX()))};
}

const BoxShape kBox{Vec3(1, 0.5, 2), Vec3(0.25, 0.25, 0.5), BoxPattern::five_tet};
const Region kRightSide = HalfSpaceRegion{Vec3(0.5, 0, 0), Vec3::UnitX()};

TEST(Loads, APointForceIsSharedEquallyAndAddsUpToItself) {
  Load load = load_of(LoadKind::point_force, kRightSide);
  load.force = Vec3(3, -7, 11);
  const WorldState world = loaded(kBox, {load});
  const std::vector<Vec3> forces = forces_at(world, 0);
  EXPECT_LT((resultant(forces) - load.force).norm(), 1e-13);
  int loaded_nodes = 0;
  for (const Vec3& force : forces) {
    if (force.isZero(0)) continue;
    EXPECT_LT((force - load.force / 15).norm(), 1e-13);
    ++loaded_nodes;
  }
  EXPECT_EQ(loaded_nodes, 3 * 5);
}

TEST(Loads, ATractionHasTheResultantAndTorqueOfItsSide) {
  Load load = load_of(LoadKind::traction, kRightSide);
  load.traction = Vec3(100, -20, 50);
  const WorldState world = loaded(kBox, {load});
  const std::vector<Vec3> forces = forces_at(world, 0);
  const Vec3 expected = 0.5 * 2 * load.traction;
  const Vec3 middle = pose_of(world).to_world(Vec3(0.5, 0, 0));
  EXPECT_LT((resultant(forces) - expected).norm(), 1e-12 * expected.norm());
  EXPECT_LT((torque(world, forces) - middle.cross(expected)).norm(), 1e-12 * expected.norm());
}

TEST(Loads, APressureOnAClosedSurfaceHasNoResultantAndNoTorque) {
  Load load = load_of(LoadKind::pressure, kEverything);
  load.pressure = 1e5;
  for (const Shape& shape : {Shape(kBox), Shape(SphereShape{}), Shape(PlateWithHoleShape{})}) {
    WorldState world = loaded(shape, {load});
    for (Vec3& position : world.nodes.positions) position += 0.1 * Vec3(position.y(), position.x() * position.z(), 1);
    const std::vector<Vec3> forces = forces_at(world, 0);
    double largest = 0;
    for (const Vec3& force : forces) largest = std::max(largest, force.norm());
    EXPECT_GT(largest, 0);
    EXPECT_LT(resultant(forces).norm(), 1e-11 * largest);
    EXPECT_LT(torque(world, forces).norm(), 1e-11 * largest);
  }
}

TEST(Loads, APressurePushesInwardsAndFollowsTheSurface) {
  Load load = load_of(LoadKind::pressure, kRightSide);
  load.pressure = 1000;
  WorldState world = loaded(kBox, {load});
  const Vec3 inward = pose_of(world).rotation * -Vec3::UnitX();
  EXPECT_LT((resultant(forces_at(world, 0)) - 1000 * inward).norm(), 1e-9);
  const Mat3 turn = Eigen::AngleAxisd(1.2, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  for (Vec3& position : world.nodes.positions) position = 1.5 * turn * position;
  EXPECT_LT((resultant(forces_at(world, 0)) - 2250 * turn * inward).norm(), 1e-9);
}

TEST(Loads, ABodyForceOnEverythingIsGravity) {
  Load load = load_of(LoadKind::body_force, kEverything);
  load.acceleration = Vec3(1, -9.81, 2);
  const WorldState world = loaded(kBox, {load});
  const std::vector<Vec3> forces = forces_at(world, 0);
  for (std::size_t i = 0; i < forces.size(); ++i)
    EXPECT_LT((forces[i] - world.nodes.masses[i] * load.acceleration).norm(), 1e-12 * world.nodes.masses[i] * 10);
}

TEST(Loads, ActFromTheirStartForTheirDurationAfterARamp) {
  Load load = load_of(LoadKind::point_force, kRightSide);
  load.start = 1;
  load.ramp = 0.5;
  load.duration = 2;
  EXPECT_EQ(load_factor(load, 0.999), 0);
  EXPECT_EQ(load_factor(load, 1), 0);
  EXPECT_DOUBLE_EQ(load_factor(load, 1.25), 0.5);
  EXPECT_EQ(load_factor(load, 1.5), 1);
  EXPECT_EQ(load_factor(load, 2.999), 1);
  EXPECT_EQ(load_factor(load, 3), 0);
  load.duration.reset();
  EXPECT_EQ(load_factor(load, 1e6), 1);
  EXPECT_EQ(load_factor(Load{}, 0), 1);
}

TEST(Loads, AFreeBodyGainsTheMomentumOfItsLoads) {
  Load force = load_of(LoadKind::point_force, kRightSide);
  force.force = Vec3(300, 0, 0);
  Load traction = load_of(LoadKind::traction, kRightSide);
  traction.traction = Vec3(0, 0, 40);
  Scene scene = loaded(kBox, {force, traction}).model->scene;
  scene.gravity.setZero();
  World world(scene);
  for (int i = 0; i < 12; ++i) world.step();
  const Vec3 expected = world.frame().time * Vec3(300, 0, 40);
  EXPECT_LT((world.frame().totals.momentum - expected).norm(), 1e-8 * expected.norm());
}

TEST(Loads, HaveTheMeanOfTheirCourseOverAnySpan) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 200; ++trial) {
    Load load;
    load.start = uniform(random);
    load.ramp = trial % 3 == 0 ? 0 : uniform(random);
    if (trial % 4 != 0) load.duration = 0.01 + uniform(random);
    const double from = uniform(random), to = from + 0.01 + uniform(random);
    constexpr int kSamples = 20000;
    double sum = 0;
    for (int i = 0; i < kSamples; ++i) sum += load_factor(load, from + (i + 0.5) / kSamples * (to - from));
    EXPECT_NEAR(load_factor(load, {from, to}), sum / kSamples, 2e-4) << trial;
  }
}

/// A load of each kind whose whole force along x has this size [N].
std::vector<Load> loads_along_x(double force, double mass) {
  std::vector<Load> loads(4);
  for (int i = 0; i < 4; ++i) loads[i] = load_of(static_cast<LoadKind>(i), kRightSide);
  loads[0].force = loads[1].traction = Vec3(force, 0, 0);  // on 1 m²
  loads[2].pressure = -force;
  loads[3].region = kEverything;
  loads[3].acceleration = Vec3(force / mass, 0, 0);
  return loads;
}

/// The momentum along x that it gives a free body in six steps [N·s].
double impulse_of(const Load& load, Integrator integrator) {
  Scene scene = loaded(kBox, {load}).model->scene;
  scene.gravity.setZero();
  scene.bodies[0].rotation_degrees.setZero();
  scene.simulation.integrator = integrator;
  scene.simulation.time_step = 1.0 / 120;
  scene.simulation.fracture = false;
  scene.bodies[0].material.stiffness_damping = 0;
  World world(scene);
  for (int i = 0; i < 6; ++i) world.step();
  const EnergyAccount energy = world.frame().energy;
  EXPECT_LT(std::abs(energy.unaccounted()), 1e-3 * energy.turned_over()) << "its work";
  return world.frame().totals.momentum.x();
}

TEST(Loads, GiveTheirImpulseHoweverShortInStepsOfAnyLength) {
  const double mass = World(loaded(kBox, {}).model->scene).frame().totals.mass;
  for (const Integrator integrator : {Integrator::hybrid, Integrator::implicit, Integrator::explicit_})
    for (const double force : {1e5, 3e6})  // the second is one that microsteps follow
      for (const auto& [start, duration, ramp] : {std::array{0.0, 1e-3, 0.0}, std::array{1.3e-3, 1e-3, 0.0},
                                                  std::array{0.0, 0.02, 0.0}, std::array{0.0101, 1.7e-5, 1e-5}})
        for (Load load : loads_along_x(force, mass)) {
          load.start = start, load.duration = duration, load.ramp = ramp;
          const double expected = force * (duration - 0.5 * ramp);
          EXPECT_NEAR(impulse_of(load, integrator), expected, 1e-3 * expected)
              << force << " N of kind " << static_cast<int>(load.kind) << " from " << start << " s for " << duration
              << " s, integrator " << static_cast<int>(integrator);
        }
}

TEST(Loads, KeepTheirSumWhenWhatTheyActOnBreaks) {
  std::vector<Load> loads(4);
  for (int i = 0; i < 4; ++i) loads[i] = load_of(static_cast<LoadKind>(i), kEverything);
  loads[0].force = Vec3(0, 1, 0);
  loads[1].traction = Vec3(2, 0, 0);
  loads[2].pressure = 3;
  loads[3].acceleration = Vec3(0, 0, 0.01);
  WorldState world = loaded(kBox, loads);
  const Vec3 before = resultant(forces_at(world, 0));
  const int nodes = world.mesh->node_count();
  for (const NodeId node : IdRange<NodeId>(0, nodes)) world.nodes.separations[node].utilization = 2;
  open_cracks(world, 0);
  ASSERT_GT(world.mesh->node_count(), nodes);
  EXPECT_LT((resultant(forces_at(world, 0)) - before).norm(), 1e-11 * before.norm());
}

TEST(Loads, ABodyThatHasGoneRigidBreaksUnderALoadThatSetsIn) {
  Load push = load_of(LoadKind::traction, kRightSide);
  Load pull = load_of(LoadKind::traction, HalfSpaceRegion{Vec3(-0.5, 0, 0), -Vec3::UnitX()});
  push.traction = Vec3(4e7, 0, 0);
  push.start = pull.start = 0.5;
  pull.traction = -push.traction;
  Scene scene = loaded(kBox, {push, pull}).model->scene;
  scene.gravity.setZero();
  World world(scene);
  while (world.frame().time < 0.5 - 1e-9) world.step();
  EXPECT_TRUE(world.frame().crack_events.empty());
  for (int i = 0; i < 6; ++i) world.step();
  EXPECT_FALSE(world.frame().crack_events.empty());
}

TEST(Loads, OneThatActsOnNothingIsAFinding) {
  const Region nowhere = SphereRegion{Vec3(0, 50, 0), 1};
  std::vector<Load> loads(4);
  for (int i = 0; i < 4; ++i) loads[i] = load_of(static_cast<LoadKind>(i), nowhere);
  const WorldState world = loaded(kBox, loads);
  ASSERT_EQ(world.model->findings.size(), 4u);
  EXPECT_EQ(world.model->findings[2].where(), "#/bodies/0/loads/2/region");
  for (const Vec3& force : forces_at(world, 0)) EXPECT_TRUE(force.isZero(0));
}

}  // namespace
}  // namespace griffith::testing
