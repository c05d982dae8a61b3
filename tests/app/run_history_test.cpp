#include "app/editor/run_history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/editor/curve_table.h"
#include "program.h"
#include "sim/world/output/step_counters.h"

namespace griffith::app {
namespace {

using ::testing::ElementsAre;

const ui::PlotChoice kChosen = {"energy.kinetic",  "pieces",           "contacts",
                                "energy.contacts", "peak_utilization", "energy.projectiles"};

/// Returns the values that curves should have at a frame.
std::vector<double> values_of(const Frame& frame) {
  return {frame.energy.kinetic,
          static_cast<double>(frame.bodies.size()),
          static_cast<double>(frame.report.contacts),
          frame.energy.contacts,
          frame.report.peak_utilization,
          frame.energy.projectiles};
}

std::vector<double> row_of(const ui::RunCurves& curves, std::size_t row) {
  std::vector<double> values;
  for (const ui::RunCurve& curve : curves.curves) values.push_back(curve.values[row]);
  return values;
}

/// A run that is recorded as the editor does it.
class RunHistoryTest : public ::testing::Test {
 protected:
  explicit RunHistoryTest(std::size_t max_values = 1'000'000) : timeline_(World(small_wall())), history_(max_values) {
    history_.restart(timeline_.world().frame());
    history_.record(timeline_);
  }

  /// Returns the values of the world at each of `count` steps.
  std::vector<std::vector<double>> make_steps(int count) {
    std::vector<std::vector<double>> told;
    for (int i = 0; i < count; ++i) {
      timeline_.advance();
      history_.record(timeline_);
      told.push_back(values_of(timeline_.world().frame()));
    }
    return told;
  }

  void go_to(int branch, std::int64_t step) {
    timeline_.go_to(branch, step);
    history_.record(timeline_);
  }

  Timeline timeline_;
  RunHistory history_;
};

TEST_F(RunHistoryTest, ReportsWhatTheWorldReports) {
  ProjectileBurst shot;
  shot.speed = 60;
  timeline_.fire(shot);
  const auto told = make_steps(12);
  const ui::RunCurves curves = history_.curves(timeline_, kChosen);
  ASSERT_EQ(curves.steps.size(), 13u);
  ASSERT_EQ(curves.curves.size(), kChosen.size());
  for (std::size_t i = 0; i < told.size(); ++i) EXPECT_EQ(row_of(curves, i + 1), told[i]) << "step " << i + 1;
  EXPECT_EQ(curves.times.back(), timeline_.world().frame().time);
  EXPECT_GT(curves.curves[5].values.back(), 0);
}

TEST_F(RunHistoryTest, HasASeriesForEachEnergyAndCounterUnderAKeyOfItsOwn) {
  std::vector<std::string> keys;
  for (const ui::RunSeries& series : history_.series()) keys.push_back(series.key);
  for (const EnergyEntry& entry : energy_entries())
    EXPECT_THAT(keys, ::testing::Contains("energy." + std::string(entry.key)));
  for (const StepCounter& counter : step_counters()) EXPECT_THAT(keys, ::testing::Contains(std::string(counter.key)));
  std::ranges::sort(keys);
  EXPECT_EQ(std::ranges::adjacent_find(keys), keys.end());
}

TEST_F(RunHistoryTest, BranchesKeepTheirOwnCurvesWhereverOneGoes) {
  const auto first = make_steps(8);
  go_to(0, 3);
  ProjectileBurst shot;
  shot.speed = 90;
  timeline_.fire(shot);
  ASSERT_EQ(timeline_.branch(), 1);
  const auto second = make_steps(7);
  go_to(1, 1);  // a branch that begins in what the last one has of its parent
  timeline_.fire(shot);
  ASSERT_EQ(timeline_.branch(), 2);
  const auto third = make_steps(2);
  const auto expect_rows = [&](int branch, std::vector<std::vector<double>> expected) {
    for (const std::int64_t step : {0, 2, 3}) {  // of the past that is shown nothing depends on
      go_to(branch, step);
      const ui::RunCurves curves = history_.curves(timeline_, kChosen);
      ASSERT_EQ(curves.steps.size(), expected.size() + 1) << branch;
      for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(curves.steps[i + 1], static_cast<std::int64_t>(i + 1));
        EXPECT_EQ(row_of(curves, i + 1), expected[i]) << "branch " << branch << " step " << i + 1;
      }
    }
  };
  expect_rows(0, first);
  std::vector<std::vector<double>> way(first.begin(), first.begin() + 3);
  way.insert(way.end(), second.begin(), second.end());
  expect_rows(1, way);
  way.assign(first.begin(), first.begin() + 1);
  way.insert(way.end(), third.begin(), third.end());
  expect_rows(2, way);
  EXPECT_NE(first[7], second[4]) << "the shot made a difference";
}

TEST_F(RunHistoryTest, StepsThatComeAgainAreNotRecordedTwice) {
  make_steps(5);
  go_to(0, 2);
  make_steps(3);
  EXPECT_THAT(history_.curves(timeline_, kChosen).steps, ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST_F(RunHistoryTest, KeysThatASceneLacksPlotNothing) {
  const ui::RunCurves curves = history_.curves(timeline_, {"probe.gone", "", "cracks"});
  ASSERT_EQ(curves.curves.size(), 1u);
  EXPECT_EQ(curves.curves[0].slot, 2u);
}

/// Room for some four steps.
class ShortRunHistory : public RunHistoryTest {
 protected:
  ShortRunHistory() : RunHistoryTest(200) {}
};

TEST_F(ShortRunHistory, DropsTheEarliestSteps) {
  make_steps(3);
  go_to(0, 1);
  timeline_.fire({});
  make_steps(20);
  const ui::RunCurves curves = history_.curves(timeline_, kChosen);
  EXPECT_LE(curves.steps.size() * history_.series().size(), 200u);
  ASSERT_GT(curves.steps.size(), 1u);
  EXPECT_EQ(curves.steps.back(), 21);
  go_to(1, 10);
  EXPECT_EQ(history_.curves(timeline_, kChosen).steps, curves.steps) << "what was dropped does not come again";
}

TEST(CurveTable, HasAHeadingAndARowAStepWithEveryBit) {
  ui::RunCurves curves;
  curves.steps = {0, 1};
  curves.times = {0, 1.0 / 60};
  curves.curves = {{{"energy.kinetic", "", "", "J"}, 0, {0.1, 1.0 / 3}},
                   {{"probe.top, left", "", "", ""}, 1, {NAN, 2}}};
  EXPECT_EQ(curve_table(curves),
            "step,time [s],energy.kinetic [J],\"probe.top, left\"\n0,0,0.1,\n"
            "1,0.016666666666666666,0.3333333333333333,2\n");
}

TEST(RunHistory, ProbesAreSeriesWithTheirUnits) {
  Scene scene = small_wall();
  Probe probe;
  probe.name = "top [left]";
  probe.body = scene.bodies[0].name;
  probe.quantities = {"velocity"};
  scene.probes = {probe};
  Timeline timeline{World(scene)};
  RunHistory history;
  history.restart(timeline.world().frame());
  timeline.advance();
  history.record(timeline);
  const ui::RunCurves curves = history.curves(timeline, {"probe.top [left].velocity.y"});
  ASSERT_EQ(curves.curves.size(), 1u);
  EXPECT_EQ(curves.curves[0].series.unit, "m/s");
  EXPECT_EQ(curves.curves[0].values.back(), probe_values(timeline.world().frame().probes, timeline.world().frame())[1]);
}

}  // namespace
}  // namespace griffith::app
