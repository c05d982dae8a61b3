#include <gtest/gtest.h>

#include <random>

#include "app/editor/run_pace.h"

namespace griffith::app {
namespace {

TEST(StepPacer, SimulatedTimeFollowsRealTimeWhateverThePictures) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> elapsed(0.005, 0.04);
  for (const double speed : {1.0, 0.25, 0.001}) {
    StepPacer pacer;
    double real = 0;
    int steps = 0;
    for (int i = 0; i < 20000; ++i) {
      const double dt = elapsed(random);
      real += dt;
      steps += pacer.steps_due(dt, speed, 1.0 / 120, 1e-4);
    }
    EXPECT_NEAR(steps / 120.0, real * speed, 1.0 / 120) << speed;
    EXPECT_FALSE(pacer.falling_behind());
  }
}

TEST(StepPacer, CostlyStepsAreDroppedAndTheWarningSaysSo) {
  StepPacer pacer;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(pacer.steps_due(0.1, 1, 1.0 / 120, 0.1), 1);
  EXPECT_TRUE(pacer.falling_behind());
  // Once steps are cheap again there is no backlog to catch up with, and the warning goes.
  for (int i = 0; i < 100; ++i) EXPECT_LE(pacer.steps_due(1.0 / 60, 1, 1.0 / 120, 1e-4), 3);
  EXPECT_FALSE(pacer.falling_behind());
}

TEST(StepPacer, AStepThatTakesManyFramesIsFollowedByOneAlone) {
  StepPacer pacer;
  int steps = 0;
  for (int step = 0; step < 50; ++step) {
    steps += pacer.steps_due(1.0 / 60, 1, 1.0 / 120, 0.1);
    for (int frame = 0; frame < 5; ++frame) pacer.wait(1.0 / 60, 1, 1.0 / 120);
  }
  EXPECT_EQ(steps, 50);
  EXPECT_TRUE(pacer.falling_behind());
  // Slow enough for what a step costs, nothing is lost: 50 steps in 300 frames.
  StepPacer slow;
  double left = 0;
  steps = 0;
  for (int frame = 0; frame < 3000; ++frame) {
    if (left > 0) {
      left -= 1.0 / 60;
      slow.wait(1.0 / 60, 0.05, 1.0 / 120);
    } else if (const int made = slow.steps_due(1.0 / 60, 0.05, 1.0 / 120, 0.1)) {
      steps += made;
      left = 0.1;
    }
  }
  EXPECT_NEAR(steps, 3000 / 60.0 * 0.05 * 120, 1);
  EXPECT_FALSE(slow.falling_behind());
}

TEST(StepPacer, AClockThatStandsOrRunsBackMakesNoSteps) {
  StepPacer pacer;
  EXPECT_EQ(pacer.steps_due(0, 1, 0.01, 0), 0);
  EXPECT_EQ(pacer.steps_due(-5, 1, 0.01, 0), 0);
  EXPECT_EQ(pacer.steps_due(0.01, 1, 0.01, 0), 1);
}

}  // namespace
}  // namespace griffith::app
