#include <gtest/gtest.h>

#include <set>

#include "sim/world/fracture/fracture_phase.h"
#include "sim/world/fracture/separation_phase.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/state/world_state.h"
#include "sim/world/step.h"
#include "tests/world/loading.h"
#include "tests/world/scenes.h"

namespace griffith::testing {
namespace {

Scene floating(const BodyDescription& body) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.bodies = {body};
  return scene;
}

BodyDescription block(const Vec3& size = Vec3(1, 1, 1)) {
  BodyDescription body;
  body.shape = BoxShape{size, Vec3::Constant(0.25), BoxPattern::five_tet};
  return body;
}

std::unique_ptr<WorldState> build(const Scene& scene) {
  auto world = std::make_unique<WorldState>(build_world(scene));
  return world;
}

/// As if the node carried `utilization` times its resistance across a plane.
void overload(WorldState& world, NodeId node, const Vec3& normal, double utilization = 2) {
  NodeSeparation& separation = world.nodes.separations[node];
  separation.direction = normal;
  separation.utilization = utilization;
}

NodeId node_near(const WorldState& world, const Vec3& place) {
  NodeId nearest(0);
  for (const NodeId node : IdRange<NodeId>(0, world.mesh->node_count()))
    if ((world.mesh->rest_positions[node] - place).norm() < (world.mesh->rest_positions[nearest] - place).norm())
      nearest = node;
  return nearest;
}

/// Cuts the block through along the plane y = 0 without any stress.
void cut_in_two(WorldState& world) {
  std::vector<NodeId> plane;
  for (const NodeId node : IdRange<NodeId>(0, world.mesh->node_count()))
    if (std::abs(world.mesh->rest_positions[node].y()) < 1e-9) plane.push_back(node);
  for (NodeId node : plane) {
    overload(world, node, Vec3::UnitY());
    open_cracks(world, 0);
    for (NodeSeparation& separation : world.nodes.separations) separation = {};
  }
}

TEST(QuietCut, ABodyCutInTwoAtRestStaysAtRest) {
  Scene scene = floating(block());
  World driver(scene);  // a twin for the number of steps below: stepping a ballistic body must do nothing either
  auto world = build(scene);
  cut_in_two(*world);
  ASSERT_EQ(world->bodies.size(), 2u);
  for (int step = 0; step < 100; ++step) {
    advance(*world);
    driver.step();
  }
  EXPECT_LT(world->output.totals.kinetic_energy, 1e-20) << "no push apart, whatever the collision margin";
  EXPECT_LT(driver.frame().totals.kinetic_energy, 1e-20);
  EXPECT_EQ(world->bodies.size(), 2u);
}

TEST(CrackEvents, TellTheElementsTheirForcesAndTheBodies) {
  auto world = build(floating(block()));
  const Mat3 stretch = Vec3(1, 1 + 1e-4, 1).asDiagonal();
  for (Vec3& position : world->nodes.positions) position = stretch * position;
  update_elements(*world);
  evaluate_separation(*world, false);
  cut_in_two(*world);
  ASSERT_EQ(world->bodies.size(), 2u);
  for (const CrackEvent& event : world->crack_events) {
    EXPECT_EQ(event.body, BodyId(0));
    std::set<bool> sides;
    Vec3 above = Vec3::Zero();
    for (const CrackElement& element : event.elements) {
      sides.insert(element.above);
      if (element.above) above += element.force.tensile + element.force.compressive;
    }
    EXPECT_EQ(sides.size(), 2u) << "elements on both sides";
    EXPECT_GT(above.y(), 0) << "the elements above pull the node upwards";
  }
  const CrackEvent& last = world->crack_events.back();
  EXPECT_EQ(last.children, (std::vector<BodyId>{BodyId(0), BodyId(1)}));
  EXPECT_TRUE(world->crack_events.front().children.empty()) << "the first cut parts nothing";
}

TEST(CrackBudget, WorstNodesFirstAndTheRestInTheNextStep) {
  Scene scene = floating(block(Vec3(4, 1, 1)));
  scene.simulation.max_cracks_per_step = 2;
  auto world = build(scene);
  // Far apart, so that none relieves another.
  const std::vector<double> places = {-1.5, -0.5, 0.5, 1.5};
  const std::vector<double> utilizations = {1.5, 3, 2, 4};
  std::vector<NodeId> nodes;
  for (std::size_t i = 0; i < places.size(); ++i) {
    nodes.push_back(node_near(*world, Vec3(places[i], 0, 0)));
    overload(*world, nodes[i], Vec3::UnitX(), utilizations[i]);
  }
  open_cracks(*world, 0);
  ASSERT_EQ(world->crack_events.size(), 2u);
  EXPECT_EQ(world->crack_events[0].node, nodes[3]);
  EXPECT_EQ(world->crack_events[1].node, nodes[1]);
  EXPECT_EQ(world->report.cracks_postponed, 2);

  world->report = {};
  for (NodeSeparation& separation : world->nodes.separations) separation = {};  // the load has gone since
  open_cracks(*world, 0);
  ASSERT_EQ(world->crack_events.size(), 4u) << "what was overloaded cracks all the same";
  EXPECT_EQ(world->crack_events[2].node, nodes[2]);
  EXPECT_EQ(world->crack_events[3].node, nodes[0]);
  EXPECT_EQ(world->report.cracks_postponed, 0);
}

TEST(NewCracks, StartOutOfReachOfEachOthersWaves) {
  auto world = build(floating(block(Vec3(4, 1, 1))));
  const NodeId left = node_near(*world, Vec3(-1.5, 0, 0)), right = node_near(*world, Vec3(1.5, 0, 0));
  const double transit = 3 / bar_wave_speed(world->materials[0]);
  for (double substep : {1.1 * transit, 0.9 * transit}) {
    auto fresh = build(floating(block(Vec3(4, 1, 1))));
    overload(*fresh, left, Vec3::UnitX(), 3);
    overload(*fresh, right, Vec3::UnitX(), 2);
    open_cracks(*fresh, substep);
    EXPECT_EQ(fresh->crack_events.size(), substep > transit ? 1u : 2u);
  }
}

constexpr double kLayer = 0.0625;  // height of the elements [m]

/// A block that hangs from a ceiling, so heavy that at the ceiling its weight is its tensile strength.
Scene hanging_block(bool can_tear) {
  BodyDescription body = block();
  body.shape = BoxShape{Vec3::Ones(), Vec3(0.25, kLayer, 0.25), BoxPattern::five_tet};
  body.material.poisson_ratio = 0;
  Support ceiling;
  ceiling.region = HalfSpaceRegion{Vec3(0, 0.5, 0), Vec3::UnitY()};
  ceiling.can_tear = can_tear;
  body.supports = {ceiling};
  Scene scene = floating(body);
  scene.analysis = Analysis::static_;
  Load weight;
  weight.kind = LoadKind::body_force;
  weight.region = HalfSpaceRegion{Vec3(0, -1, 0), Vec3::UnitY()};
  weight.acceleration = Vec3(0, -body.material.tensile_strength / body.material.density, 0);
  scene.bodies[0].loads = {weight};
  return scene;
}

TEST(Supports, ABodyTearsOffItsSupportAtItsStrength) {
  const auto torn = [](const Frame& frame) { return frame.report.supports_torn > 0; };
  const double fraction = breaking_fraction(hanging_block(true), {0.9, 1.1, 0.01}, torn);
  EXPECT_NEAR(fraction, 1 + kLayer / 2, 0.03) << "the middle of the uppermost elements lies half of them lower";
  const double kept = breaking_fraction(hanging_block(false), {0.9, 1.1, 0.01}, torn);
  EXPECT_GT(kept, 1.1) << "unless the support cannot tear";
}

TEST(Supports, WhatTearsOffIsFree) {
  Scene scene = hanging_block(true);
  scene.bodies[0].loads[0].acceleration *= 1.2;
  World world(scene);
  for (int step = 0; step < 3; ++step) world.step();
  const Frame frame = world.frame();
  int supported = 0;
  for (const BodyView& body : frame.bodies) supported += body.supported && body.mass > 0.5 * frame.totals.mass;
  EXPECT_EQ(supported, 0) << "the bulk of the block hangs no more";
}

TEST(RunningCracks, AdvanceAtASpeedThatDoesNotDependOnTheTimeStep) {
  // A notched plate, pulled far beyond what it bears: the crack runs upwards from the notch.
  std::vector<double> speeds;
  for (double time_step : {1.0 / 240, 1.0 / 480, 1.0 / 2000}) {
    BodyDescription plate;
    plate.material = *find_material_preset("concrete");
    plate.shape = NotchedBeamShape{Vec3(2, 2, 0.25), 0.5, Vec3::Constant(0.25), BoxPattern::five_tet};
    for (double side : {-1.0, 1.0}) {
      Support grip;
      grip.kind = SupportKind::prescribed;
      grip.region = HalfSpaceRegion{Vec3(side, 0, 0), Vec3(side, 0, 0)};
      grip.velocity = Vec3(side * 0.02, 0, 0);
      grip.can_tear = false;
      plate.supports.push_back(grip);
    }
    Scene scene = floating(plate);
    scene.simulation.time_step = time_step;
    scene.simulation.impact_substeps = 256;
    scene.simulation.step_budget = 100;
    World world(scene);
    double started = -1, arrived = -1;
    while (arrived < 0 && world.frame().time < 0.2) {
      world.step();
      for (const CrackEvent& event : world.frame().crack_events) {
        if (started < 0) started = event.time;
        if (event.rest_position.y() > 0.7 && std::abs(event.rest_position.x()) < 0.6) arrived = event.time;
      }
    }
    ASSERT_GT(arrived, 0) << "dt = " << time_step;
    const double speed = 1.25 / (arrived - started) / bar_wave_speed(plate.material);
    EXPECT_GT(speed, 0.1) << "dt = " << time_step;
    EXPECT_LT(speed, 0.65) << "no faster than surface waves; dt = " << time_step;
    speeds.push_back(speed);
  }
  const auto [slowest, fastest] = std::minmax_element(speeds.begin(), speeds.end());
  // In a long step the load has grown further before its cracks run.
  EXPECT_LT(*fastest / *slowest, 2);
}

}  // namespace
}  // namespace griffith::testing
