#include "app/editor/holding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/editor/holding_report.h"
#include "app/editor/thickness.h"
#include "program.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;

TEST(CriticalFactor, IsFoundToWithinAHundredth) {
  for (const double border : {1.003, 1.7, 2.0, 100.0, 1000.0}) {
    const CriticalFactor factor = critical_factor([&](double tried) { return tried >= border; });
    ASSERT_TRUE(factor.found) << border;
    EXPECT_GE(factor.holds, border);
    EXPECT_LT(factor.breaks, border);
    EXPECT_LE(factor.holds / factor.breaks, 1.01);
  }
  EXPECT_FALSE(critical_factor([](double) { return false; }).found);
}

/// One of each shape that has a thickness, turned and held at one side.
std::vector<BodyDescription> thick_bodies() {
  std::vector<BodyDescription> bodies;
  for (const Shape& shape : {Shape(BoxShape{Vec3(1, 0.2, 0.6), Vec3(0.25, 0.1, 0.2)}), Shape(CylinderShape{}),
                             Shape(CylinderShape{0.5, 0.3, Vec2(0.2, 0.1)}), Shape(DiscShape{}), Shape(SphereShape{}),
                             Shape(PlateWithHoleShape{Vec3(1, 1, 0.1), 0.2, Vec2(0.25, 0.1)}),
                             Shape(NotchedBeamShape{Vec3(2, 0.5, 0.4), 0.2, Vec3(0.25, 0.125, 0.2)})}) {
    BodyDescription body;
    body.shape = shape;
    body.position = Vec3(1, 3, -2);
    body.rotation_degrees = Vec3(20, -70, 100);
    body.supports = {{BoxRegion{Vec3(-2, -2, -2), Vec3(2, 2, 0.0)}}};
    body.loads = {{HalfSpaceRegion{Vec3(0, 0.02, 0.05), Vec3(1, 2, 3)}, LoadKind::point_force, Vec3(0, 1, 0)}};
    bodies.push_back(body);
  }
  return bodies;
}

Scene scene_of(const BodyDescription& body) {
  Scene scene;
  scene.ground.reset();
  scene.simulation.static_start = false;
  scene.bodies = {body};
  return scene;
}

TEST(Thickness, MovesEveryNodeToItsPlaceAndKeepsCellsAndSupports) {
  for (const BodyDescription& body : thick_bodies()) {
    for (const double factor : {0.4, 1.7, 6.0}) {
      const Vec3 gravity(1, -9, 2);
      const World world(scene_of(body)), thicker(scene_of(thickened(body, factor, gravity)));
      const Frame before = world.frame(), after = thicker.frame();
      ASSERT_EQ(before.elements.tets.size(), after.elements.tets.size()) << body.shape.index();
      for (std::size_t i = 0; i < before.nodes.rest_positions.size(); ++i) {
        const Vec3 place = thickened_place(body, factor, gravity, before.nodes.rest_positions[i]);
        EXPECT_LT((place - after.nodes.rest_positions[i]).norm(), 1e-12) << body.shape.index() << " node " << i;
        EXPECT_EQ(before.nodes.has_support[i], after.nodes.has_support[i]) << body.shape.index() << " node " << i;
      }
      if (factor > 1) continue;  // another extent may be the least then
      EXPECT_NEAR(thickness_of(thickened(body, factor, gravity).shape)->length,
                  factor * thickness_of(body.shape)->length, 1e-12);
    }
  }
}

TEST(Thickness, LeavesTheLowerSideOfALyingPlateAndTheMiddleOfAStandingOneInPlace) {
  BodyDescription plate;
  plate.shape = BoxShape{Vec3(1, 1, 0.02), Vec3(0.25, 0.25, 0.01)};
  plate.position = Vec3(0, 2, 0);
  EXPECT_EQ(thickened(plate, 3, Vec3(0, -9.81, 0)).position, plate.position) << "it stands";
  plate.rotation_degrees = Vec3(90, 0, 0);
  const BodyDescription lying = thickened(plate, 3, Vec3(0, -9.81, 0));
  EXPECT_NEAR(lying.position.y() - 0.03, plate.position.y() - 0.01, 1e-12);
  EXPECT_EQ(thickened(plate, 3, Vec3::Zero()).position, plate.position) << "nothing is below";
}

/// A console of 2×.2×.4 m, held at one end, that breaks there under a weight that grows from nothing.
Scene overloaded_console() {
  BodyDescription beam;
  beam.name = "console";
  beam.shape = BoxShape{Vec3(2, 0.2, 0.4), Vec3(0.2, 0.1, 0.2)};
  beam.elements = ElementOrder::quadratic;  // linear ones bend too little, the less the thinner they are
  beam.position = Vec3(0, 2, 0);
  beam.supports = {{BoxRegion{Vec3(-1, -1, -1), Vec3(-1, 1, 1)}}};
  beam.supports[0].can_tear = false;
  beam.material.tensile_strength = 1e6;
  Load weight;
  weight.kind = LoadKind::body_force;
  weight.region = BoxRegion{Vec3::Constant(-2), Vec3::Constant(2)};
  weight.acceleration = Vec3(0, -110, 0);
  weight.ramp = 2;
  beam.loads = {weight};
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.bodies = {beam};
  return scene;
}

/// The timeline stands before the step in which the first node cracks, which is returned.
NodeId advance_to_crack(Timeline& timeline) {
  for (int i = 0; i < 300; ++i) {
    std::optional<World> before;
    timeline.advance(&before);
    const Frame frame = timeline.world().frame();
    if (frame.crack_events.empty()) continue;
    const NodeId node = frame.crack_events[0].node;
    timeline.take_back(std::move(*before));
    return node;
  }
  return {};
}

TEST(Holding, ThicknessHoldsABeamAsItsBendingStressFalls) {
  Timeline timeline{World(overloaded_console())};
  const NodeId node = advance_to_crack(timeline);
  ASSERT_TRUE(node.valid());
  const RunToCrack run = run_to_crack(timeline, node);
  EXPECT_FALSE(node_holds(run)) << "unchanged";
  const std::optional<CriticalFactor> thickness = critical_thickness_factor(run);
  ASSERT_TRUE(thickness && thickness->found);
  EXPECT_FALSE(node_holds(thickened(run, thickness->breaks)));
  EXPECT_TRUE(node_holds(thickened(run, thickness->holds)));
  // It breaks at step n of a growing load and is to stand .1 s longer: σ = 3 ρ a L²/h is kept by h in proportion to a.
  const double time_step = run.scene.simulation.time_step;
  const double steps = static_cast<double>(run.steps + 1);
  const double growth = (steps + 0.1 / time_step) / steps;
  EXPECT_NEAR(thickness->holds, growth, 0.1 * growth);
  EXPECT_FALSE(critical_speed_factor(run)) << "nothing flies";
}

TEST(Holding, SlowerShotsLeaveANodeWhole) {
  Timeline timeline{World(small_wall())};
  const NodeId node = advance_to_crack(timeline);
  ASSERT_TRUE(node.valid());
  const RunToCrack run = run_to_crack(timeline, node);
  const std::optional<CriticalFactor> speed = critical_speed_factor(run);
  ASSERT_TRUE(speed && speed->found);
  EXPECT_GT(speed->holds, 1);
  EXPECT_FALSE(node_holds(slowed(run, speed->breaks)));
  EXPECT_TRUE(node_holds(slowed(run, speed->holds)));
  EXPECT_DOUBLE_EQ(slowed(run, 2).scene.projectiles[0].speed, run.scene.projectiles[0].speed / 2);
}

TEST(Holding, ABodyDoesNotGrowIntoAnother) {
  Scene scene = overloaded_console();
  BodyDescription lid;
  lid.name = "lid";
  lid.shape = BoxShape{Vec3(0.5, 0.5, 0.5), Vec3::Constant(0.25)};
  lid.position = Vec3(0.5, 2.36, 0);
  lid.supports = {{BoxRegion{Vec3::Constant(-1), Vec3::Constant(1)}}};
  scene.bodies.push_back(lid);
  Timeline timeline{World(scene)};
  const NodeId node = advance_to_crack(timeline);
  ASSERT_TRUE(node.valid());
  try {
    critical_thickness_factor(run_to_crack(timeline, node));
    FAIL() << "it grows by more than a centimeter";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("console"));
  }
}

TEST(Holding, TheReportSaysWhatWasFoundAndWhatWasNot) {
  RunToCrack run;
  run.scene = small_wall();
  run.node = NodeId(7);
  HoldingAnswer answer;
  answer.strength = {1.24, 1.25, true, true, 6};
  answer.speed = CriticalFactor{1.9, 2, true, true, 8};
  ui::WorkReport report = holding_report(answer, run);
  EXPECT_THAT(report.title, HasSubstr("node 7"));
  EXPECT_THAT(report.facts[0], HasSubstr("1.25 times the strength"));
  EXPECT_THAT(report.facts[1], HasSubstr("20 m/s instead of 40 m/s"));
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_THAT(report.facts[0], ::testing::Not(HasSubstr("It cracked at"))) << "nothing to explain";
  answer.speed.reset();
  answer.cancelled = true;
  report = holding_report(answer, run);
  EXPECT_EQ(report.facts.size(), 3u) << "untried values are not reported";
  EXPECT_THAT(report.warnings[0], HasSubstr("Cancelled"));
}

TEST(Holding, TheReportExplainsAStrengthThatIsNotTheUtilizationAtTheCrack) {
  RunToCrack run;
  run.scene = small_wall();
  HoldingAnswer answer;
  answer.strength = {1.25, 1.26, true, true, 6};
  const auto fact = [&] { return holding_report(answer, run).facts[0]; };
  answer.broken = {.utilization = 1.265, .before = 0, .all = 3};
  EXPECT_THAT(fact(), ::testing::Not(HasSubstr("It cracked at"))) << "the same, to within what was tried";
  answer.broken = {.utilization = 5.57, .before = 12, .all = 40};
  answer.held = {.utilization = {}, .before = 0, .all = 7};
  EXPECT_THAT(fact(), HasSubstr("It cracked at 557 % of its resistance after 12 other cracks"));
  EXPECT_THAT(fact(), HasSubstr("the step has 7"));
  answer.broken.before = 0;
  EXPECT_THAT(fact(), HasSubstr("above 126 %"));
  answer.broken.utilization = 1.1;
  EXPECT_THAT(fact(), HasSubstr("while its load was rising"));
}

TEST(Holding, TheCracksOfAStepAreThoseThatItThenHas) {
  Timeline timeline{World(small_wall())};
  const NodeId first = advance_to_crack(timeline);
  ASSERT_TRUE(first.valid());
  World world = timeline.world();
  world.step();
  const auto events = world.frame().crack_events;
  const std::size_t known = timeline.world().frame().nodes.positions.size();
  int tried = 0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const auto same = [&](const CrackEvent& event) { return event.rest_position == events[i].rest_position; };
    if (static_cast<std::size_t>(events[i].node.index()) >= known) continue;  // made by the step
    if (std::ranges::find_if(events, same) - events.begin() != static_cast<std::ptrdiff_t>(i)) continue;
    const StepCracks cracks = cracks_of_step(timeline.world(), 0, events[i].node, 1);
    ASSERT_TRUE(cracks.utilization);
    EXPECT_EQ(*cracks.utilization, events[i].load / events[i].resistance);
    EXPECT_EQ(cracks.before, static_cast<int>(i));
    EXPECT_EQ(cracks.all, static_cast<int>(events.size()));
    ++tried;
  }
  EXPECT_GT(tried, 0);
  EXPECT_FALSE(cracks_of_step(timeline.world(), 0, first, 1000).utilization);
}

}  // namespace
}  // namespace griffith::app
