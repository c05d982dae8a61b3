#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/editor/breakpoints.h"
#include "editor_fixture.h"
#include "sim/core/ids.h"
#include "sim/scene/scene_reader.h"
#include "ui/model/units.h"
#include "ui/model/verdict.h"

namespace griffith::app {
namespace {

using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using ui::Verdict;

std::string percent(double utilization) { return ui::format_quantity(100 * utilization, "", 3) + " %"; }

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Checks the sentences of the verdict on a node against the frame.
void expect_true(const Verdict& verdict, const NodeReport& report, const Frame& frame, bool comes) {
  const std::string& text = verdict.text;
  const NodeSeparation& separation = report.separation;
  const bool measured = std::isfinite(separation.resistance), cracked = !report.events.empty();
  const bool says_holds = text.starts_with("Holds") || has(text, "The rest holds");
  const bool says_overloaded = has(text, "verloaded");
  ASSERT_FALSE(text.empty());
  EXPECT_EQ(has(text, "Broke at"), cracked) << text;
  EXPECT_EQ(has(text, "Cracks in the next step"), comes) << text;
  EXPECT_EQ(verdict.kind == Verdict::Kind::about_to_crack, comes) << text;
  EXPECT_LE(says_holds + says_overloaded + comes, 1) << text;
  if (has(text, "whole")) {
    EXPECT_FALSE(cracked) << text;
  }
  if (says_holds) {
    EXPECT_TRUE(measured && separation.utilization <= 1) << text;
  }
  if (says_overloaded) {
    EXPECT_GT(separation.utilization, 1) << text;
    EXPECT_EQ(verdict.kind, Verdict::Kind::overloaded) << text;
  }
  if (has(text, "lasted")) {
    EXPECT_GT(separation.utilization, 1) << text;
    EXPECT_GT(frame.report.microsteps, 0) << text;
  }
  if (verdict.kind == Verdict::Kind::holds) {
    EXPECT_TRUE(!cracked && separation.utilization <= 0.8) << text;
  }
  if (cracked) {
    const CrackEvent& last = frame.crack_events[static_cast<std::size_t>(report.events.back())];
    EXPECT_THAT(text, HasSubstr("(step " + std::to_string(ui::step_of(last)) + ")"));
    EXPECT_THAT(text, HasSubstr(percent(last.load / last.resistance)));
    EXPECT_LE(ui::step_of(last), frame.step) << "no crack is in a step to come";
  }
  const BodyView& body = frame.bodies[report.body];
  EXPECT_EQ(has(text, "rigid body"), body.rigid && body.tets > 1) << text;
  EXPECT_EQ(has(text, "asleep"), body.asleep && !(body.rigid && body.tets == 1)) << text;
}

/// Every node before and after every step of a run, as if it had stopped before each of them and as if it had not.
void expect_true_sentences(Scene scene, int steps) {
  const bool fracture = scene.simulation.fracture;
  ui::Breakpoints any;
  any.crack = ui::Breakpoints::Where::anywhere;
  World world(scene);
  int cracks_foretold = 0;
  for (int i = 0; i < steps && !::testing::Test::HasFailure(); ++i) {
    const World before = world;
    world.step();
    const Frame frame = before.frame(), next = world.frame();
    const std::optional<ui::Stop> stop = met_breakpoint(any, frame, next, 0, {});
    EXPECT_EQ(stop.has_value(), next.crack_events.size() > frame.crack_events.size());
    for (const NodeId node : IdRange<NodeId>(0, static_cast<std::int64_t>(frame.nodes.positions.size()))) {
      const NodeReport report = node_report(frame, node);
      expect_true(ui::verdict_on(report, frame, fracture, std::nullopt), report, frame, false);
      const auto cracks = next.crack_events.subspan(frame.crack_events.size());
      const auto first = std::ranges::find(cracks, node, &CrackEvent::node);
      const Verdict verdict = ui::verdict_on(report, frame, fracture, stop);
      expect_true(verdict, report, frame, first != cracks.end());
      if (first == cracks.end()) continue;
      ++cracks_foretold;
      EXPECT_THAT(verdict.text, HasSubstr("(step " + std::to_string(next.step) + ")"));
      EXPECT_THAT(verdict.text, HasSubstr(percent(first->load / first->resistance)));
    }
  }
  EXPECT_GT(cracks_foretold, 0);
}

Scene shot_wall() {
  Scene scene = small_wall();
  scene.projectiles[0].speed = 60;
  return scene;
}

TEST(Sentences, AreTrueOfEveryNodeAtEveryStepOfAShotWall) { expect_true_sentences(shot_wall(), 40); }

TEST(Sentences, AreTrueWhereCracksArePostponedAndSuppressed) {
  Scene scene = shot_wall();
  scene.simulation.max_cracks_per_step = 2;
  scene.simulation.min_fragment_tets = 4;
  expect_true_sentences(scene, 30);
}

TEST(Sentences, AreTrueOfLoadsThatTearSupports) {
  Scene scene = small_wall();
  scene.projectiles.clear();
  Load pull;
  pull.region = HalfSpaceRegion{Vec3(0, 0.9, 0), Vec3::UnitY()};
  pull.force = Vec3(0, 4e6, 0);
  scene.bodies[0].loads = {pull};
  expect_true_sentences(scene, 12);
}

TEST(Sentences, AreTrueOfAScaledImpact) {
  Scene scene = shot_wall();
  scene.simulation.step_budget = 0.01;
  expect_true_sentences(scene, 30);
}

TEST(Sentences, SayThatTheStressStateDecides) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.fracture = false;
  BodyDescription block;
  block.shape = BoxShape{Vec3(0.1, 0.1, 0.1), Vec3::Constant(0.05), BoxPattern::five_tet};
  block.material = *find_material_preset("soda_lime_glass");
  block.material.tensile_strength = 40e6;
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())}) {
    block.supports.push_back(
        {.region = HalfSpaceRegion{-0.05 * axis, -axis}, .kind = SupportKind::sliding, .normal = axis});
    block.loads.push_back(
        {.region = HalfSpaceRegion{0.05 * axis, axis}, .kind = LoadKind::traction, .traction = 20e6 * axis});
  }
  scene.bodies = {block};
  for (const bool has_surface : {false, true}) {
    if (has_surface) scene.bodies[0].material.compressive_strength = 1000e6;
    World world(scene);
    world.step();
    const NodeReport report = node_report(world.frame(), most_loaded_node(world.frame()));
    const std::string text = ui::verdict_on(report, world.frame(), true).text,
                      origin = ui::origin_of_load(report, scene.bodies[0].material);
    EXPECT_EQ(has(text,
                  "The stress state decides, not its largest tension: now 20 MPa across the plane count as 29.6 "
                  "MPa, by the compressive strength of 1 GPa."),
              has_surface)
        << text;
    EXPECT_EQ(has(origin, "equivalent to the stress state, with 20 MPa across the plane: "), has_surface) << origin;
  }
}

/// A wall that nothing strikes.
class RestOnScreen : public EditorTest {
 protected:
  static Scene wall() {
    Scene scene = small_wall();
    scene.projectiles.clear();
    return scene;
  }
  RestOnScreen() : EditorTest(wall()) {}
};

TEST_F(RestOnScreen, RoundingNoiseIsShownAsNoEnergy) {
  for (int i = 0; i < 3; ++i) {
    editor_.run().step();
    draw();
    EXPECT_NE(value("value/Elastic"), "0 J") << "it carries its weight";
    EXPECT_EQ(value("value/Kinetic"), "0 J");
    EXPECT_EQ(value("value/Gravity"), "0 J");
    EXPECT_EQ(value("value/Material damping"), "0 J");
    EXPECT_EQ(value("value/Unaccounted"), "0 J");
  }
}

TEST_F(RestOnScreen, RoundingNoiseIsShownAsNoContribution) {
  editor_.run().step();
  const auto nodes = static_cast<int>(editor_.run().frame().nodes.positions.size());
  for (int node = 0; node < nodes; ++node) {
    select_node(editor_.state(), editor_.run().frame(), NodeId(node));
    draw(2);
    EXPECT_THAT(value("value/Total"), Not(HasSubstr("e-"))) << node;
    EXPECT_THAT(value("inspector/element/0"), Not(HasSubstr("e-"))) << node;
  }
}

Scene wall_shot_three_times() {
  Scene scene = shot_wall();
  scene.projectiles[0].count = 3;
  scene.projectiles[0].interval = 0.1;
  return scene;
}

/// All that the window says, at any time: no sentence may contradict another.
class SentencesOnScreen : public EditorTest {
 protected:
  SentencesOnScreen() : EditorTest(wall_shot_three_times()) {
    editor_.state().breakpoints.crack = ui::Breakpoints::Where::anywhere;
  }
  void run_until_stopped() {
    editor_.state().running = true;
    for (int i = 0; i < 200 && editor_.state().running; ++i) editor_.run().advance(0.02);
    draw(2);
  }
  void expect_agreement() {
    const std::string verdict = value("inspector/verdict"), status = value("status/message");
    const bool stops = ui::find_tag(editor_.tags(), "time/stopped") != nullptr;
    EXPECT_EQ(has(status, "in the next step"), stops && has(value("time/stopped"), "in the next step")) << status;
    const bool foretold = stops && value("time/stopped").starts_with("Node " + value("value/Node") + " cracks");
    if (foretold) {
      EXPECT_TRUE(verdict.starts_with("Cracks in the next step")) << verdict;
    }
    if (!stops) {
      EXPECT_THAT(verdict, Not(HasSubstr("in the next step, at")));
    }
    if (ui::find_tag(editor_.tags(), "value/Crack")) {
      EXPECT_THAT(verdict, HasSubstr("Broke at"));
    }
    if (has(verdict, "olds: the load")) {
      EXPECT_THAT(verdict, HasSubstr(percent(std::stod(value("value/Utilization")))));
    }
  }
  std::int64_t step() const { return editor_.run().frame().step; }
};

TEST_F(SentencesOnScreen, AgreeBeforeEachCrackAndAfterIt) {
  int stops = 0;
  for (run_until_stopped(); editor_.state().stop && stops < 5; run_until_stopped(), ++stops) {
    expect_agreement();
    EXPECT_THAT(value("inspector/verdict"), HasSubstr("Cracks in the next step"));
    const std::string node = value("value/Node");
    for (const ui::ComingCrack& crack : editor_.state().stop->cracks) {
      select_node(editor_.state(), editor_.run().frame(), crack.node);
      draw(2);
      EXPECT_THAT(value("inspector/verdict"), HasSubstr("Cracks in the next step"));
    }
    for (int i = 0; i < 100; i += 30) {
      select_node(editor_.state(), editor_.run().frame(), NodeId(i));
      draw(2);
      expect_agreement();
    }
    select_node(editor_.state(), editor_.run().frame(), NodeId(std::stoi(node)));
    editor_.run().step();
    draw(2);
    expect_agreement();
    EXPECT_THAT(value("inspector/verdict"), HasSubstr("Broke at"));
    EXPECT_THAT(editor_.tags(),
                Contains(Field(&ui::WidgetTag::value, StartsWith("step " + std::to_string(step()) + ", "))))
        << "one of the node's cracks";
    EXPECT_EQ(value("toolbar/step"), "step " + std::to_string(step()));
  }
  EXPECT_GE(stops, 2);
}

TEST_F(SentencesOnScreen, WhatWasSaidOfAStateIsNotSaidOfAnother) {
  run_until_stopped();
  const std::int64_t stopped = step();
  EXPECT_THAT(value("status/message"), HasSubstr("step " + std::to_string(stopped) + ". Node"));
  editor_.execute({.name = "time.back"});
  draw(2);
  expect_agreement();
  EXPECT_EQ(value("time/stopped"), "no widget time/stopped");
  editor_.execute({.name = "simulation.fire"});  // another branch begins
  editor_.state().breakpoints = {};
  for (int i = 0; i < 3; ++i) {
    editor_.run().step();
    draw(2);
    expect_agreement();
  }
  editor_.execute({.name = "time.branch", .step = stopped, .branch = 0});
  draw(2);
  expect_agreement();
}

TEST_F(SentencesOnScreen, AMessageOfTheStateGoesWithItAndOldOnesDoNotComeBack) {
  log_message(editor_.state(), ui::LogLevel::info, "Saved wall.json");
  editor_.execute({.name = "simulation.fire"});
  draw();
  EXPECT_THAT(value("status/message"), HasSubstr("Press Space to run"));
  editor_.run().step();
  draw();
  EXPECT_THAT(value("status/message"), ::testing::Not(HasSubstr("Press Space to run the simulation")));
  EXPECT_NE(value("status/message"), "Saved wall.json");
  EXPECT_EQ(editor_.state().log.back().text.substr(0, 6), "Fired.") << "the log keeps all";
}

}  // namespace
}  // namespace griffith::app
