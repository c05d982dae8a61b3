#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "sim/world/world.h"
#include "tests/world/measures.h"
#include "tests/world/scenes.h"

namespace griffith::testing {
namespace {

/// A weightless block with these supports, moving at the start.
Scene supported_block(const std::vector<Support>& supports) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.fracture = false;
  scene.simulation.static_start = false;  // it has a velocity
  scene.simulation.relative_residual = 1e-9;
  BodyDescription block;
  block.shape = BoxShape{Vec3(1, 1, 1), Vec3::Constant(0.5), BoxPattern::five_tet};
  block.velocity = Vec3(0.01, 0.02, -0.03);
  block.supports = supports;
  scene.bodies = {block};
  return scene;
}

const Region kFoot = HalfSpaceRegion{Vec3(0, -0.5, 0), -Vec3::UnitY()};

Support support_of(SupportKind kind, const Region& region = kFoot) {
  Support support{region};
  support.kind = kind;
  return support;
}

TEST(Supports, AFixedNodeStandsStill) {
  World world(supported_block({support_of(SupportKind::fixed)}));
  for (int i = 0; i < 5; ++i) world.step();
  const Frame frame = world.frame();
  int held = 0;
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i) {
    if (!frame.nodes.has_support[i]) continue;
    EXPECT_TRUE(frame.nodes.positions[i] == frame.nodes.rest_positions[i] && frame.nodes.velocities[i].isZero(0));
    ++held;
  }
  EXPECT_EQ(held, 9);
}

TEST(Supports, ASlidingBlockKeepsItsPlaneAndItsMomentumAlongIt) {
  Support sliding = support_of(SupportKind::sliding);
  sliding.normal = Vec3(0, 2, 0);
  World world(supported_block({sliding}));
  for (int i = 0; i < 20; ++i) world.step();
  const Frame frame = world.frame();
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i) {
    if (!frame.nodes.has_support[i]) continue;
    EXPECT_NEAR(frame.nodes.positions[i].y(), -0.5, 1e-12);
  }
  const Vec3 drift = frame.bodies[0].center_of_mass - Vec3::Zero();
  EXPECT_NEAR(drift.x(), 0.01 * frame.time, 1e-5 * frame.time);
  EXPECT_NEAR(drift.z(), -0.03 * frame.time, 1e-5 * frame.time);
}

/// Follows a support that stops in the fourth step [s].
void expect_exact_way(const Scene& scene, double stop) {
  World world(scene);
  int microsteps = 0;
  for (int i = 0; i < 8; ++i) {
    world.step();
    const Frame frame = world.frame();
    microsteps += frame.report.microsteps;
    const Vec3 way = std::min(frame.time, stop) * scene.bodies[0].supports[0].velocity;
    for (std::size_t node = 0; node < frame.nodes.positions.size(); ++node) {
      if (!frame.nodes.has_support[node]) continue;
      EXPECT_LT((frame.nodes.positions[node] - frame.nodes.rest_positions[node] - way).norm(), 1e-13);
    }
  }
  EXPECT_EQ(microsteps > 0, scene.simulation.integrator == Integrator::hybrid) << "a start like an impact";
}

TEST(Supports, APrescribedOneGetsExactlyToWhereItStops) {
  Support prescribed = support_of(SupportKind::prescribed);
  prescribed.velocity = Vec3(0.1, -0.2, 0.3);
  prescribed.stop = 0.03;
  prescribed.can_tear = false;
  for (const Integrator integrator : {Integrator::hybrid, Integrator::implicit, Integrator::explicit_}) {
    Scene scene = supported_block({prescribed});
    scene.simulation.integrator = integrator;
    scene.simulation.fracture = false;
    expect_exact_way(scene, 0.03);
  }
}

/// Returns the settings of all kinds of time integration.
std::vector<SimulationSettings> all_integrators() {
  SimulationSettings implicit, explicitly;
  explicitly.integrator = Integrator::explicit_;
  return {implicit, explicitly};
}

TEST(Supports, ABodyHeldWhollyStandsAndItsSupportsCarryIt) {
  for (const SimulationSettings& settings : all_integrators())
    for (const Analysis analysis : {Analysis::dynamic, Analysis::static_}) {
      Scene scene = supported_block({support_of(SupportKind::fixed, HalfSpaceRegion{Vec3(0, 9, 0), -Vec3::UnitY()})});
      scene.simulation = settings;
      scene.analysis = analysis;
      scene.gravity = Vec3(0, -9.81, 0);
      scene.bodies[0].velocity.setZero();
      ProjectileBurst shot;
      shot.position = Vec3(0.1, 0.2, 3);
      World world(scene);
      const double weight = 9.81 * world.frame().totals.mass;
      world.step();
      EXPECT_LT((testing::sum_of_reactions(world.frame()) - Vec3(0, weight, 0)).norm(), 1e-9 * weight);
      world.fire(shot);
      for (int i = 0; i < 30; ++i) world.step();
      const Frame frame = world.frame();
      for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i)
        EXPECT_EQ(frame.nodes.positions[i], frame.nodes.rest_positions[i]);
    }
}

TEST(Supports, OneThatIsTornOffCarriesNothing) {
  for (const SimulationSettings& settings : all_integrators()) {
    Scene scene = supported_block({support_of(SupportKind::fixed, HalfSpaceRegion{Vec3(0, 0.5, 0), Vec3::UnitY()})});
    scene.simulation = settings;
    scene.simulation.static_start = false;
    scene.gravity = Vec3(0, -9.81, 0);
    scene.bodies[0].velocity.setZero();
    scene.bodies[0].material.tensile_strength = 1e3;  // its weight loads it with 19 kPa
    World world(scene);
    world.step();
    for (int i = 0; i < 60 && std::ranges::count(world.frame().nodes.has_support, 1) > 0; ++i) world.step();
    ASSERT_EQ(std::ranges::count(world.frame().nodes.has_support, 1), 0);
    world.step();
    for (const Vec3& reaction : world.frame().nodes.reactions) EXPECT_TRUE(reaction.isZero(0));
  }
}

/// Counts the pieces that supports hold, and of those the ones held by no face.
std::pair<int, int> held_pieces(const Frame& frame) {
  std::map<BodyId, int> most;  // corners of one element
  for (std::size_t i = 0; i < frame.elements.tets.size(); ++i) {
    const auto& corners = frame.elements.tets[i];
    const auto held =
        std::ranges::count_if(corners, [&](NodeId node) { return frame.nodes.has_support[node.index()]; });
    int& known = most[frame.elements.bodies[i]];
    known = std::max(known, static_cast<int>(held));
  }
  const auto is_held = [](const auto& entry) { return entry.second > 0; };
  const auto is_unbonded = [](const auto& entry) { return entry.second == 1 || entry.second == 2; };
  return {static_cast<int>(std::ranges::count_if(most, is_held)),
          static_cast<int>(std::ranges::count_if(most, is_unbonded))};
}

TEST(Supports, PiecesHeldByANodeOrAnEdgeAloneAreFreeUnlessTheyWereHeldSoFromTheStart) {
  World wall(shot_wall(Vec3(3, 3, 1), 0.5, brick(0.2)));
  for (int i = 0; i < 60; ++i) wall.step();
  EXPECT_GT(wall.frame().bodies.size(), 5u);
  EXPECT_GT(held_pieces(wall.frame()).first, 0);
  EXPECT_EQ(held_pieces(wall.frame()).second, 0);

  Scene pendulum = supported_block({support_of(SupportKind::fixed, SphereRegion{Vec3(0.5, 0.5, 0.5), 0.01})});
  pendulum.gravity = Vec3(0, -9.81, 0);
  pendulum.simulation.fracture = true;
  World hanging(pendulum);
  for (int i = 0; i < 20; ++i) hanging.step();
  EXPECT_EQ(held_pieces(hanging.frame()), std::pair(1, 1));
}

TEST(Supports, OverlappingOnesHoldTogether) {
  const Support across = support_of(SupportKind::sliding);
  Support along = support_of(SupportKind::sliding, HalfSpaceRegion{Vec3(-0.5, 0, 0), -Vec3::UnitX()});
  along.normal = Vec3::UnitX();
  World world(supported_block({across, along}));
  for (int i = 0; i < 20; ++i) world.step();
  const Frame frame = world.frame();
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i) {
    const Vec3 moved = frame.nodes.positions[i] - frame.nodes.rest_positions[i];
    const Vec3& rest = frame.nodes.rest_positions[i];
    EXPECT_LT(std::abs(moved.y()), rest.y() == -0.5 ? 1e-12 : 1);
    EXPECT_LT(std::abs(moved.x()), rest.x() == -0.5 ? 1e-12 : 1);
    EXPECT_NEAR(moved.z(), -0.03 * frame.time, 1e-4 * frame.time);
  }
}

TEST(Supports, OneThatHoldsNothingIsAFinding) {
  const Support nowhere = support_of(SupportKind::fixed, SphereRegion{Vec3(0, 9, 0), 1});
  const World world(supported_block({support_of(SupportKind::fixed), nowhere}));
  ASSERT_EQ(world.findings().size(), 1u);
  EXPECT_EQ(world.findings()[0].where(), "#/bodies/0/supports/1/region");
}

TEST(Supports, NodesStayInTheirPlaneWhateverStrikesTheBody) {
  Scene scene;
  scene.ground.reset();
  BodyDescription block;
  block.shape = BoxShape{Vec3(1, 1, 1), Vec3::Constant(0.25), BoxPattern::five_tet};
  block.rotation_degrees = Vec3(20, 30, 40);
  block.material.tensile_strength = 1e9;
  Support plane{HalfSpaceRegion{Vec3(0, -0.5, 0), -Vec3::UnitY()}};
  plane.kind = SupportKind::sliding;
  plane.normal = Vec3(0.3, 1, 0.2).normalized();
  block.supports = {plane};
  scene.bodies = {block};
  ProjectileBurst shot;
  shot.position = Vec3(0.1, 0.2, 2);
  scene.projectiles = {shot};
  World world(scene);
  const auto start = world.frame().nodes.positions;
  const std::vector<Vec3> first(start.begin(), start.end());
  bool struck = false;
  for (int step = 0; step < 60; ++step) {
    world.step();
    struck |= !world.frame().contacts.empty();
  }
  ASSERT_TRUE(struck);
  const Frame frame = world.frame();
  for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i) {
    const Mat3 blocked = Mat3::Identity() - frame.nodes.constraints[NodeId(static_cast<std::int64_t>(i))].allowed;
    EXPECT_LT((blocked * (frame.nodes.positions[i] - first[i])).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace griffith::testing
