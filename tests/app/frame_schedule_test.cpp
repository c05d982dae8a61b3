#include "app/editor/frame_schedule.h"

#include <gtest/gtest.h>

#include "editor_fixture.h"

namespace griffith::app {
namespace {

TEST(FrameSchedule, DrawsSomeFramesAfterWhatHappenedAndThenNone) {
  FrameSchedule schedule;
  const auto frames = [&schedule] {
    int drawn = 0;
    for (; drawn < 100 && schedule.seconds_to_wait(kDrawNever) == kDrawAtOnce; ++drawn) schedule.drew();
    return drawn;
  };
  EXPECT_GE(frames(), 4) << "a new window finds its layout";
  EXPECT_EQ(frames(), 0);
  schedule.wake();
  EXPECT_GE(frames(), 4);
  EXPECT_EQ(schedule.seconds_to_wait(0.2), 0.2);
  EXPECT_EQ(schedule.seconds_to_wait(kDrawAtOnce), kDrawAtOnce);
}

TEST(FrameSchedule, DrawsSomeFramesAfterTheEndOfWhatWentOnByItself) {
  constexpr double kWork = 0.1, kBlink = 0.5;
  for (const double next : {kDrawNever, kBlink}) {
    FrameSchedule schedule;
    while (schedule.seconds_to_wait(kWork) == kDrawAtOnce) schedule.drew();
    int drawn = 0;
    for (; schedule.seconds_to_wait(next) == kDrawAtOnce; ++drawn) schedule.drew();
    EXPECT_GE(drawn, 4) << "a report in a dialog";
    EXPECT_EQ(schedule.seconds_to_wait(next), next) << "once";
  }
}

TEST_F(EditorTest, APausedWindowHasNothingToDraw) {
  draw(10);
  EXPECT_EQ(editor_.seconds_to_next_frame(), kDrawNever);
  for (const char* tag : {"command/simulation.step", "command/view.frame_all"}) {
    click(tag);
    draw(10);
    EXPECT_EQ(editor_.seconds_to_next_frame(), kDrawNever) << tag;
  }
  click("command/simulation.run");
  EXPECT_EQ(editor_.seconds_to_next_frame(), kDrawAtOnce);
  click("command/simulation.run");
  draw(3);
  EXPECT_EQ(editor_.seconds_to_next_frame(), kDrawNever);
}

TEST_F(EditorTest, WhatGoesOnByItselfIsDrawn) {
  editor_.execute({.name = "simulation.make_steps", .step = 3});
  EXPECT_EQ(editor_.seconds_to_next_frame(), kDrawAtOnce) << "steps that were asked for";
  while (editor_.state().running) editor_.run().advance(0.02);
  draw(3);
  EXPECT_EQ(editor_.seconds_to_next_frame(), kDrawNever);
  press_key('P', true);  // the palette, whose cursor blinks
  draw(3);
  EXPECT_GT(editor_.seconds_to_next_frame(), kDrawAtOnce);
  EXPECT_LE(editor_.seconds_to_next_frame(), 0.5);
  press_key(ui::key::kEscape);
  draw(3);
  EXPECT_EQ(editor_.seconds_to_next_frame(), kDrawNever);
  editor_.state().work = "Building bodies";
  EXPECT_LE(editor_.seconds_to_next_frame(), 0.1);
}

}  // namespace
}  // namespace griffith::app
