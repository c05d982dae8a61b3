#include <gtest/gtest.h>

#include <random>

#include "app/editor/run_pace.h"

namespace griffith::app {
namespace {

TEST(RateMeter, ReportsWhatAClockMeasuresWhateverTheFrames) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.5, 1.5);
  for (const double cost : {1e-3, 0.02, 0.3, 1.4, 20.0}) {  // of a step [s], on average
    for (const double frame : {0.004, 0.016, 0.5, 3.0}) {
      RateMeter meter;
      const double time_step = 1.0 / 120;
      double clock = 0, step_ends = cost;
      for (int portions = 0; portions < 60;) {
        const double elapsed = frame * unit(random);
        clock += elapsed;
        int made = 0;
        for (; step_ends <= clock; ++made) step_ends += cost;
        meter.add(elapsed, made * time_step);
        portions += made > 0;
        const bool settled = portions > 8 && frame < cost / 10;
        if (settled) {
          EXPECT_NEAR(meter.rate(), time_step / cost, 0.1 * time_step / cost) << cost << " " << frame;
        }
      }
    }
  }
}

TEST(RateMeter, StepsWithinAFrameAndPausesBetweenFramesCountAlike) {
  RateMeter meter;  // a frame of 0.9 s with three steps, then one of 0.1 s without
  for (int i = 0; i < 40; ++i) meter.add(i % 2 == 0 ? 0.9 : 0.1, i % 2 == 0 ? 0.03 : 0);
  EXPECT_NEAR(meter.rate(), 0.03, 0.003);
}

TEST(RateMeter, FollowsAChangeWithinSeconds) {
  RateMeter meter;
  for (int i = 0; i < 600; ++i) meter.add(1.0 / 60, 1.0 / 60);
  EXPECT_NEAR(meter.rate(), 1, 0.02);
  for (int i = 0; i < 150; ++i) meter.add(1.0 / 60, 0.1 / 60);
  EXPECT_NEAR(meter.rate(), 0.1, 0.01);
}

TEST(RateMeter, IsThatOfTheLastPortionWhereItTookLong) {
  RateMeter meter;  // 20 steps in a frame, then steps of nine seconds
  meter.add(1, 20);
  for (int step = 0; step < 3; ++step) {
    for (int i = 1; i < 90; ++i) meter.add(0.1, 0);
    meter.add(0.1, 1);
    EXPECT_NEAR(meter.rate(), 1.0 / 9, 0.001);
  }
}

TEST(RateMeter, WhatStopsGoesToNothing) {
  RateMeter meter;
  EXPECT_EQ(meter.rate(), 0);
  for (int i = 0; i < 100; ++i) meter.add(0.1, 0.01);
  EXPECT_NEAR(meter.rate(), 0.1, 0.01);
  double last = meter.rate();
  for (int i = 0; i < 1000; ++i) {
    meter.add(0.1, 0);
    EXPECT_LE(meter.rate(), last);
    last = meter.rate();
  }
  EXPECT_LT(last, 0.01);
  meter.reset();
  EXPECT_EQ(meter.rate(), 0);
}

TEST(RateMeter, AClockThatRunsBackCountsAsOneThatStands) {
  RateMeter meter;
  meter.add(-5, 1);
  EXPECT_EQ(meter.rate(), 0);
  meter.add(1, 1);
  EXPECT_DOUBLE_EQ(meter.rate(), 2);
}

}  // namespace
}  // namespace griffith::app
