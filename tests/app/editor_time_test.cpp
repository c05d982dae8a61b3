#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "app/editor/breakpoints.h"
#include "app/editor/holding.h"
#include "editor_fixture.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;
using ui::Breakpoints;

class TimeTest : public EditorTest {
 protected:
  void run(int steps) {
    for (int i = 0; i < steps; ++i) editor_.run().step();
    draw();
  }
  /// Fires at the middle of the view with a shot that breaks the wall.
  void fire() {
    editor_.state().shot.speed = 60;
    editor_.execute({.name = "simulation.fire"});
  }
  void run_until_stopped() {
    editor_.state().running = true;
    for (int i = 0; i < 200 && editor_.state().running; ++i) editor_.run().advance(0.02);
    draw();
  }
  std::int64_t step() const { return editor_.run().frame().step; }
  std::size_t cracks() const { return editor_.run().frame().crack_events.size(); }
};

TEST_F(TimeTest, StepsBackAndForthAndAgain) {
  run(6);
  const std::uint64_t hash = editor_.run().timeline().world().state_hash();
  click("command/time.back");
  click("command/time.back");
  EXPECT_EQ(step(), 4);
  click("command/simulation.step");
  click("command/simulation.step");
  EXPECT_EQ(step(), 6);
  EXPECT_EQ(editor_.run().timeline().world().state_hash(), hash);
  click("command/time.start");
  EXPECT_EQ(value("toolbar/step"), "step 0");
  click("command/time.end");
  EXPECT_EQ(editor_.run().timeline().world().state_hash(), hash);
}

TEST_F(TimeTest, AClickOnTheBarGoesThere) {
  run(20);
  const ui::WidgetTag* bar = ui::find_tag(editor_.tags(), "time/bar");
  ASSERT_TRUE(bar);
  click("time/bar");
  EXPECT_EQ(step(), 10);
  EXPECT_EQ(value("time/bar"), "10 of 20");
}

TEST_F(TimeTest, AShotInThePastBeginsABranchThatTheListGoesTo) {
  run(10);
  EXPECT_FALSE(ui::find_tag(editor_.tags(), "time/branch"));
  const std::size_t shots = editor_.run().frame().projectiles.size();
  click("command/time.back");
  fire();
  run(5);
  ASSERT_TRUE(ui::find_tag(editor_.tags(), "time/branch"));
  EXPECT_EQ(editor_.run().frame().projectiles.size(), shots + 1);
  click("time/branch");
  click("time/branch/0");
  EXPECT_EQ(step(), 10);
  EXPECT_EQ(editor_.run().frame().projectiles.size(), shots);
}

TEST_F(TimeTest, TheMaterialGoesBackToo) {
  run(4);
  click("material/yields");
  run(4);
  EXPECT_TRUE(editor_.run().frame().materials[0].yield_strength);
  click("command/time.start");
  EXPECT_FALSE(editor_.run().frame().materials[0].yield_strength);
  EXPECT_EQ(value("material/yields"), "off");
  draw();
  EXPECT_EQ(editor_.run().timeline().branches().size(), 1u) << "looking back does nothing to the world";
  run(6);
  EXPECT_EQ(value("material/yields"), "on") << "playing on, the panel follows too";
  run(1);
  click("command/time.start");
  click("command/time.end");
  EXPECT_TRUE(editor_.run().frame().materials[0].yield_strength);
  EXPECT_EQ(editor_.run().timeline().branches().size(), 1u);
}

/// A scene with edits of later steps is not saved yet, wherever the run stands.
TEST_F(TimeTest, EditsStayWhereTheyWereMadeAndAreNotForgotten) {
  const double strength = editor_.run().frame().materials[0].tensile_strength;
  choose_material("ice");
  const Material ice = editor_.run().frame().materials[0];
  ASSERT_NE(ice.tensile_strength, strength);
  run(2);
  click("command/time.start");
  EXPECT_EQ(editor_.document().scene().bodies[0].material, ice) << "that of its own step";
  const ui::EditHistory& history = editor_.document().history();
  EXPECT_TRUE(history.modified());
  editor_.document().history().mark_saved();
  EXPECT_FALSE(history.modified());

  click("command/time.end");
  choose_material("concrete");
  run(2);
  click("command/time.start");
  EXPECT_EQ(editor_.document().scene().bodies[0].material, ice);
  EXPECT_TRUE(history.has_later_edits());
  EXPECT_TRUE(history.modified()) << "it would be lost";
  click("command/time.end");
  editor_.document().history().mark_saved();
  click("command/time.start");
  EXPECT_FALSE(history.has_later_edits()) << "the file has it";
}

TEST_F(TimeTest, WhatWasEditedBeforeTheStepStaysWhenItIsStoppedBefore) {
  run(3);
  editor_.state().breakpoints.crack = Breakpoints::Where::anywhere;
  const double strength = editor_.run().frame().materials[0].tensile_strength;
  choose_material("ice");
  ASSERT_NE(editor_.run().frame().materials[0].tensile_strength, strength);
  const Material chosen = editor_.run().frame().materials[0];
  fire();
  run_until_stopped();
  EXPECT_EQ(editor_.run().frame().materials[0], chosen);
  EXPECT_EQ(editor_.run().timeline().branches().size(), 1u);
  draw(3);
  EXPECT_EQ(editor_.run().timeline().branches().size(), 1u) << "the scene and the world agree";
}

TEST_F(TimeTest, StopsBeforeACrackWithTheNodeStillWhole) {
  click("time/breakpoints");
  click("time/break/any");
  press_key(ui::key::kEscape);
  fire();
  run_until_stopped();
  ASSERT_FALSE(editor_.state().running);
  EXPECT_THAT(value("time/stopped"), HasSubstr("cracks in the next step"));
  EXPECT_EQ(cracks(), 0u);
  const std::int64_t stopped_at = step();
  const NodeId node = editor_.state().selection.node;
  ASSERT_TRUE(node.valid()) << "the node that is about to crack is explained";
  EXPECT_GT(std::stod(value("value/Utilization then")), 1);
  EXPECT_EQ(value("inspector/utilization_bar"), value("value/Utilization then"));
  EXPECT_THAT(value("inspector/verdict"), ::testing::Not(HasSubstr("Holds")));
  const ui::ComingCrack coming = editor_.state().stop->cracks.front();
  editor_.run().step();
  EXPECT_EQ(step(), stopped_at + 1) << "the next step passes the breakpoint";
  ASSERT_GT(cracks(), 0u);
  const CrackEvent& crack = editor_.run().frame().crack_events[0];
  EXPECT_EQ(crack.node, node);
  EXPECT_EQ(coming.normal, crack.normal);
  EXPECT_NEAR(coming.eigenvalues[0], crack.eigenvalue, 1e-6 * crack.eigenvalue) << "the tensor that was shown";
}

TEST_F(TimeTest, TheStopIsShownAgainWhenTheRunStandsThereAgain) {
  editor_.state().breakpoints.crack = Breakpoints::Where::anywhere;
  fire();
  run_until_stopped();
  ASSERT_GT(step(), 0);
  const std::string reason = value("time/stopped"), verdict = value("inspector/verdict");
  const std::int64_t stopped_at = step();
  click("command/time.back");
  EXPECT_FALSE(ui::find_tag(editor_.tags(), "time/stopped")) << "the crack is not in the next step";
  click("command/simulation.step");
  EXPECT_EQ(value("time/stopped"), reason);
  EXPECT_EQ(value("inspector/verdict"), verdict);
  EXPECT_THAT(value("status/message"), HasSubstr(reason));
  click("command/time.start");
  editor_.execute({.name = "time.step", .step = stopped_at});
  draw();
  EXPECT_EQ(value("time/stopped"), reason);
  click("command/simulation.step");
  EXPECT_EQ(step(), stopped_at + 1) << "it is passed as before";
  EXPECT_FALSE(ui::find_tag(editor_.tags(), "time/stopped"));
  click("command/time.back");
  EXPECT_EQ(value("time/stopped"), reason);
  choose_material("ice");
  EXPECT_FALSE(ui::find_tag(editor_.tags(), "time/stopped")) << "of another branch nothing is known";
}

TEST_F(TimeTest, TheStopThatComesBackHasTheShotsOfItsStep) {
  editor_.state().breakpoints.crack = Breakpoints::Where::anywhere;
  fire();
  run_until_stopped();
  const std::int64_t stopped_at = step();
  fire();
  run_until_stopped();
  ASSERT_EQ(step(), stopped_at);
  const std::uint64_t hash = editor_.run().timeline().world().state_hash();
  click("command/time.back");
  click("command/simulation.step");
  EXPECT_EQ(editor_.run().timeline().world().state_hash(), hash);
  editor_.execute({.name = "time.start"});
  editor_.execute({.name = "time.step", .step = stopped_at});
  EXPECT_EQ(editor_.run().timeline().world().state_hash(), hash);
}

TEST_F(TimeTest, TheNodeOfAStopIsFoundAgain) {
  editor_.state().breakpoints.crack = Breakpoints::Where::anywhere;
  fire();
  run_until_stopped();
  const std::string verdict = value("inspector/verdict");
  EXPECT_FALSE(ui::find_tag(editor_.tags(), "time/stopped_node")) << "it is selected";
  editor_.execute({.name = "view.pick", .cursor = Vec2(0.01, 0.01)});
  draw();
  EXPECT_FALSE(editor_.state().selection.valid());
  click("time/stopped_node");
  EXPECT_EQ(editor_.state().selection.node, editor_.state().stop->node);
  EXPECT_EQ(value("inspector/verdict"), verdict);
}

TEST_F(TimeTest, WhatWouldHaveHeldItHoldsIt) {
  editor_.state().breakpoints.crack = Breakpoints::Where::anywhere;
  fire();
  run_until_stopped();
  ASSERT_TRUE(editor_.state().stop && editor_.state().stop->node.valid());
  const NodeId node = editor_.state().selection.node;
  const CriticalFactor factor = critical_strength_factor(editor_.run().timeline().world(), 0, node);
  ASSERT_TRUE(factor.found);
  EXPECT_GT(factor.holds, 1);
  EXPECT_LE(factor.holds, 1.011 * factor.breaks);
  const auto cracks_at_node = [&](double strength) {
    World world = editor_.run().timeline().world();
    const Vec3 place = world.frame().nodes.rest_positions[node];
    Material material = world.frame().materials[0];
    material.tensile_strength *= strength;
    material.fracture_toughness *= strength;
    material.separation_toughness *= strength;
    world.set_material(0, material);
    world.step();
    return std::ranges::any_of(world.frame().crack_events,
                               [&](const CrackEvent& event) { return event.rest_position == place; });
  };
  EXPECT_FALSE(cracks_at_node(factor.holds));
  EXPECT_TRUE(cracks_at_node(factor.breaks));
}

TEST_F(TimeTest, SaysFromWhatStrengthSpeedAndThicknessOnANodeStands) {
  editor_.state().breakpoints.crack = Breakpoints::Where::anywhere;
  fire();
  run_until_stopped();
  const std::uint64_t hash = editor_.run().timeline().world().state_hash();
  click("time/holding");
  EXPECT_THAT(value("work/stage"), HasSubstr("Trying"));
  wait_for_work();
  EXPECT_THAT(value("report/title"), HasSubstr("What would have held node"));
  EXPECT_THAT(value("report/fact0"), HasSubstr("times the strength"));
  EXPECT_THAT(value("report/fact1"), HasSubstr("Speed: "));
  EXPECT_THAT(value("report/fact2"), HasSubstr("Thickness: "));
  EXPECT_EQ(editor_.run().timeline().world().state_hash(), hash) << "trying changes nothing";
  click("report/close");
  EXPECT_NE(editor_.disabled_reason("time.apply_strength"), "") << "the report is closed";
  click("time/holding");
  click("work/cancel");
  wait_for_work();
  EXPECT_THAT(value("report/warning0"), HasSubstr("Cancelled"));
}

TEST_F(TimeTest, TheStrengthThatHoldsIsAppliedAsABranchOnWhichTheNodeHolds) {
  editor_.state().breakpoints.crack = Breakpoints::Where::anywhere;
  fire();
  run_until_stopped();
  const std::int64_t stopped_at = step();
  const Vec3 place = editor_.state().selection.rest_position;
  const double strength = editor_.document().scene().bodies[0].material.tensile_strength;
  click("time/holding");
  wait_for_work();
  click("report/time.apply_strength");
  draw(2);
  EXPECT_FALSE(editor_.state().report);
  EXPECT_FALSE(editor_.state().stop) << "it was the reason to stop before the edit";
  EXPECT_EQ(step(), stopped_at);
  EXPECT_GT(editor_.document().scene().bodies[0].material.tensile_strength, strength);
  editor_.state().breakpoints = {};
  run(1);
  EXPECT_EQ(editor_.run().timeline().branches().size(), 2u);
  for (const CrackEvent& event : editor_.run().frame().crack_events) EXPECT_NE(event.rest_position, place);
  editor_.execute({.name = "edit.undo"});
  EXPECT_EQ(editor_.document().scene().bodies[0].material.tensile_strength, strength);
}

TEST_F(TimeTest, TheSpeedThatHoldsIsAppliedToTheShotFromTheStart) {
  editor_.state().breakpoints.crack = Breakpoints::Where::anywhere;
  fire();
  run_until_stopped();
  click("time/holding");
  wait_for_work();
  ASSERT_TRUE(ui::find_tag(editor_.tags(), "report/time.apply_speed")) << value("report/fact1");
  click("report/time.apply_speed");
  draw(2);
  wait_for_work();
  EXPECT_EQ(step(), 0);
  ASSERT_FALSE(editor_.document().scene().projectiles.empty());
  EXPECT_LT(editor_.document().scene().projectiles.back().speed, 60);
}

TEST_F(TimeTest, StopsBeforeThePiecesAndTheUtilizationAreThere) {
  editor_.state().breakpoints.on_pieces = true;
  editor_.state().breakpoints.pieces = 2;
  fire();
  run_until_stopped();
  EXPECT_THAT(value("time/stopped"), HasSubstr("pieces after the next step"));
  EXPECT_LT(editor_.run().frame().fragments, 2);
  editor_.run().step();
  EXPECT_GE(editor_.run().frame().fragments, 2);
  editor_.execute({.name = "time.start"});
  editor_.state().breakpoints = {};
  editor_.state().breakpoints.on_utilization = true;
  editor_.state().breakpoints.utilization = 0.2;
  run_until_stopped();
  EXPECT_THAT(value("time/stopped"), HasSubstr("utilization"));
  EXPECT_LE(editor_.run().frame().report.peak_utilization, 0.2);
}

TEST_F(TimeTest, SoManyStepsAreMadeAsAreAskedFor) {
  press_key('N', false, true);
  draw(4);
  EXPECT_EQ(value("steps/count"), "10");
  editor_.state().asked_steps = 7;
  draw();
  click("steps/make");
  EXPECT_TRUE(editor_.state().running);
  for (int i = 0; i < 100 && editor_.state().running; ++i) editor_.run().advance(1e-6);
  EXPECT_EQ(step(), 7) << "whatever time has passed";
  EXPECT_FALSE(editor_.state().running);
  editor_.execute({.name = "simulation.make_steps", .step = 1000});
  editor_.run().advance(1e-6);
  EXPECT_GT(step(), 7);
  press_key(ui::key::kSpace);
  EXPECT_FALSE(editor_.state().running) << "Space stops before";
  const std::int64_t stopped = step();
  editor_.run().advance(0.02);
  EXPECT_EQ(step(), stopped);
}

TEST_F(TimeTest, HoldingTheRightButtonAimsAndLettingGoFires) {
  const ui::WidgetTag* view = ui::find_tag(editor_.tags(), "viewport");
  ASSERT_TRUE(view);
  editor_.run().step();  // the scene's own shot is on its way
  const std::size_t shots = editor_.run().frame().projectiles.size();
  const auto hold = [&](bool down) {
    queue_.button(1, down);
    play();
    draw();
  };
  queue_.move(view->center());
  play();
  hold(true);
  EXPECT_THAT(value("aim/readout"), HasSubstr("hits after"));
  press_key(ui::key::kEscape);
  hold(false);
  editor_.run().step();
  EXPECT_EQ(editor_.run().frame().projectiles.size(), shots) << "Escape cancelled it";
  hold(true);
  hold(false);
  EXPECT_EQ(value("aim/readout"), "no widget aim/readout");
  editor_.run().step();
  EXPECT_EQ(editor_.run().frame().projectiles.size(), shots + 1);
}

}  // namespace
}  // namespace griffith::app
