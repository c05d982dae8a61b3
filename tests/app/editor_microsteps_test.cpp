// Playback of recorded microsteps in the editor.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor_fixture.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class MicrostepsTest : public EditorTest {
 protected:
  /// Fires at the middle of the view and runs to the end of the first step in which something cracks.
  void run_to_crack() {
    editor_.state().shot.speed = 60;
    editor_.execute({.name = "simulation.fire"});
    while (editor_.run().frame().crack_events.empty()) editor_.run().step();
    draw();
  }
  void show_microsteps() {
    click("time/microsteps");
    wait_for_work();
  }
  int moment() const { return editor_.state().microsteps->moment(); }
  int last_moment() const {
    const std::string text = value("microsteps/bar");
    return std::stoi(text.substr(text.rfind(' ') + 1));
  }
  std::uint64_t hash() const { return editor_.run().timeline().world().state_hash(); }
};

TEST_F(MicrostepsTest, ShowTheStepAndReturnToItsEnd) {
  run_to_crack();
  const std::uint64_t end = hash();
  const std::int64_t step = editor_.run().timeline().step();
  const std::size_t cracks = editor_.run().frame().crack_events.size();
  show_microsteps();
  ASSERT_TRUE(editor_.state().microsteps);
  EXPECT_EQ(value("microsteps/time"), "+0.00 µs");
  EXPECT_EQ(value("toolbar/step"), "step " + std::to_string(step));
  EXPECT_THAT(value("microsteps/shown"), HasSubstr("in step " + std::to_string(step)));
  EXPECT_THAT(value("microsteps/recording"), HasSubstr(" of 512 MB"));
  EXPECT_LT(editor_.run().frame().crack_events.size(), cracks) << "the first microstep is before the last crack";
  EXPECT_EQ(hash(), end) << "the run stands at the end of the step";
  click("microsteps/close");
  EXPECT_FALSE(editor_.state().microsteps);
  EXPECT_EQ(editor_.run().frame().crack_events.size(), cracks);
  EXPECT_EQ(editor_.run().world().state_hash(), end);
  EXPECT_EQ(editor_.run().timeline().branches().size(), 1u);
}

TEST_F(MicrostepsTest, AreSteppedByTheKeysOfSteps) {
  run_to_crack();
  show_microsteps();
  const std::uint64_t first = editor_.run().world().state_hash();
  press_key('N');
  press_key('N');
  EXPECT_EQ(moment(), 2);
  EXPECT_NE(editor_.run().world().state_hash(), first);
  press_key(ui::key::kLeft);
  EXPECT_EQ(moment(), 1);
  click("command/time.end");
  EXPECT_EQ(moment(), last_moment());
  press_key('N');
  EXPECT_EQ(moment(), last_moment()) << "there is no further one";
  click("command/time.start");
  EXPECT_EQ(moment(), 0);
  EXPECT_EQ(editor_.run().world().state_hash(), first);
  press_key(ui::key::kLeft);
  EXPECT_EQ(moment(), 0);
}

TEST_F(MicrostepsTest, ArePlayedInTheTimeThatIsAsked) {
  run_to_crack();
  show_microsteps();
  editor_.state().microstep_seconds = 2;
  click("microsteps/play");
  ASSERT_TRUE(editor_.state().microsteps->playing);
  double time = editor_.run().frame().time;
  for (int i = 0; i < 20; ++i) {
    editor_.run().advance(0.05);
    EXPECT_GE(editor_.run().frame().time, time);
    time = editor_.run().frame().time;
  }
  EXPECT_NEAR(editor_.state().microsteps->place, 0.5 * last_moment(), 1e-6) << "half of the time";
  press_key(ui::key::kSpace);
  EXPECT_FALSE(editor_.state().microsteps->playing);
  press_key(ui::key::kSpace);
  for (int i = 0; i < 30; ++i) editor_.run().advance(0.05);
  EXPECT_EQ(moment(), last_moment());
  EXPECT_FALSE(editor_.state().microsteps->playing) << "it ends at the last one";
  press_key(ui::key::kSpace);
  EXPECT_EQ(moment(), 0) << "and begins again";
  EXPECT_FALSE(editor_.state().running);
}

TEST_F(MicrostepsTest, AClickOnTheBarGoesThere) {
  run_to_crack();
  show_microsteps();
  click("microsteps/bar");
  EXPECT_NEAR(moment(), 0.5 * last_moment(), 1);
}

TEST_F(MicrostepsTest, FinerOnesSurroundTheShownOne) {
  editor_.state().preferences.microstep_memory = 1;
  run_to_crack();
  show_microsteps();
  EXPECT_THAT(value("microsteps/recording"), HasSubstr(" of 1 MB"));
  EXPECT_FALSE(ui::find_tag(editor_.tags(), "microsteps/whole"));
  editor_.state().preferences.microstep_memory = 512;
  press_key('N');
  const std::string shown = value("microsteps/shown");
  const std::uint64_t state = editor_.run().world().state_hash();
  click("microsteps/finer");
  wait_for_work();
  EXPECT_EQ(value("microsteps/shown"), shown);
  EXPECT_EQ(editor_.run().world().state_hash(), state);
  EXPECT_TRUE(ui::find_tag(editor_.tags(), "microsteps/whole"));
  click("microsteps/whole");
  wait_for_work();
  EXPECT_FALSE(ui::find_tag(editor_.tags(), "microsteps/whole"));
}

TEST_F(MicrostepsTest, BelongToTheNextStepWhereTheRunStoppedBeforeACrack) {
  editor_.state().breakpoints.crack = ui::Breakpoints::Where::anywhere;
  editor_.state().shot.speed = 60;
  editor_.execute({.name = "simulation.fire"});
  editor_.state().running = true;
  for (int i = 0; i < 200 && editor_.state().running; ++i) editor_.run().advance(0.02);
  draw();
  ASSERT_TRUE(editor_.state().stop);
  const std::int64_t step = editor_.run().timeline().step();
  const std::uint64_t before = hash();
  show_microsteps();
  ASSERT_TRUE(editor_.state().microsteps);
  EXPECT_EQ(value("toolbar/step"), "step " + std::to_string(step + 1));
  EXPECT_FALSE(ui::find_tag(editor_.tags(), "time/stopped"));
  EXPECT_THAT(value("inspector/verdict"), HasSubstr("Cracks later in this step"));
  click("command/time.end");
  EXPECT_FALSE(editor_.run().frame().crack_events.empty());
  EXPECT_THAT(value("inspector/verdict"), Not(HasSubstr("Cracks "))) << "it has cracked by now";
  EXPECT_THAT(value("inspector/verdict"), HasSubstr("Broke at"));
  press_key('U');
  EXPECT_EQ(hash(), before);
  EXPECT_TRUE(editor_.state().stop) << "it still stands before the crack";
  EXPECT_THAT(value("inspector/verdict"), HasSubstr("Cracks in the next step"));
}

TEST_F(MicrostepsTest, AreLeftByWhatChangesTheRun) {
  run_to_crack();
  const std::int64_t step = editor_.run().timeline().step();
  for (const char* command : {"simulation.fire", "simulation.push_at"}) {
    show_microsteps();
    ASSERT_TRUE(editor_.state().microsteps) << command;
    editor_.execute({.name = command});
    EXPECT_FALSE(editor_.state().microsteps) << command;
    EXPECT_EQ(editor_.run().frame().step, step) << command;
  }
  show_microsteps();
  click("time/bar");
  EXPECT_FALSE(editor_.state().microsteps);
}

TEST_F(MicrostepsTest, AreRefusedWhereThereAreNone) {
  EXPECT_EQ(value("time/microsteps"), "none");
  click("time/microsteps");
  EXPECT_FALSE(editor_.state().microsteps);
  EXPECT_THAT(editor_.state().log.back().text, HasSubstr("no microsteps"));
}

TEST_F(MicrostepsTest, ACancelledRecordingReturnsToTheStep) {
  run_to_crack();
  const std::uint64_t end = hash();
  editor_.execute({.name = "time.microsteps"});
  editor_.state().cancel_work = true;
  wait_for_work();
  draw(3);
  EXPECT_FALSE(editor_.state().microsteps);
  EXPECT_EQ(hash(), end);
}

TEST_F(MicrostepsTest, TheSelectionSurvives) {
  run_to_crack();
  const Frame frame = editor_.run().frame();
  select_node(editor_.state(), frame, frame.crack_events[0].node);
  show_microsteps();
  EXPECT_TRUE(editor_.state().selection.valid());
  EXPECT_THAT(value("inspector/verdict"), ::testing::Not(StartsWith("no widget")));
  click("microsteps/close");
  EXPECT_TRUE(editor_.state().selection.valid());
}

}  // namespace
}  // namespace griffith::app
