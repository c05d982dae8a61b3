#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/validate/scorecard.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;

/// An experiment that reads these values, by variant and mesh.
Experiment experiment_of(const std::vector<std::vector<double>>& values, AcceptedRange accepted,
                         double largest_spread) {
  Experiment experiment;
  experiment.key = "test";
  experiment.title = "Title";
  experiment.cause = "The cause.";
  for (std::size_t mesh = 0; mesh < values[0].size(); ++mesh)
    experiment.meshes.push_back("mesh " + std::to_string(mesh));
  experiment.run = [=](int mesh) {
    std::vector<Reading> readings;
    for (std::size_t variant = 0; variant < values.size(); ++variant)
      readings.push_back(
          {"load", "variant " + std::to_string(variant), accepted, values[variant][mesh], largest_spread});
    return readings;
  };
  return experiment;
}

Judgment judged(const Experiment& experiment) {
  return judge(experiment, [](const std::string&) {});
}

TEST(Judgment, PassesValuesInRangeWithASmallSpread) {
  const Judgment judgment = judged(experiment_of({{0.95, 1.05}, {1, 0.97}}, around(1, 0.1), 0.15));
  EXPECT_TRUE(judgment.passes());
  EXPECT_EQ(judgment.worst, "");
  EXPECT_NEAR(spread_of(judgment.measurements, "load"), 0.05, 1e-12);
}

TEST(Judgment, NamesTheValueFarthestOutside) {
  const Judgment judgment = judged(experiment_of({{0.95, 1.2}, {0.5, 1}}, around(1, 0.1), 0));
  EXPECT_EQ(judgment.outside, 2);
  EXPECT_EQ(judgment.spread_out, 0) << "not judged";
  EXPECT_EQ(judgment.worst, "load is 0.5 (variant 1, mesh 0)");
}

TEST(Judgment, FailsASpreadOverMeshesAndVariantsThatIsTooLarge) {
  const Judgment judgment = judged(experiment_of({{1, 1}, {1, 2}}, {0, 10}, 0.15));
  EXPECT_EQ(judgment.outside, 0);
  EXPECT_EQ(judgment.spread_out, 1);
  EXPECT_EQ(judgment.worst, "load varies by ± 33.3 %");
}

TEST(Judgment, FailsAnExperimentWithoutResult) {
  const Judgment judgment = judged(experiment_of({{1, std::nan("")}}, {0, 10}, 0.15));
  EXPECT_EQ(judgment.outside, 1);
  EXPECT_EQ(judgment.worst, "load is unknown (variant 0, mesh 1)");
}

TEST(ScorecardEntry, HasTheCauseOnlyOfAFailure) {
  const Experiment failing = experiment_of({{0.95, 1.2}}, around(1, 0.1), 0),
                   passing = experiment_of({{1, 1}}, {0, 2}, 0);
  const ScorecardEntry bad = scorecard_entry(failing, judged(failing)),
                       good = scorecard_entry(passing, judged(passing));
  EXPECT_THAT(bad.row, HasSubstr("**fail** | 1 of 2 values are outside: load is 1.2 (variant 0, mesh 1) |"));
  EXPECT_THAT(bad.section, HasSubstr("The cause."));
  EXPECT_THAT(bad.section, HasSubstr("| load | variant 0 | 0.9 – 1.1 | 0.95 | **1.2** |  |"));
  EXPECT_THAT(good.row, HasSubstr("pass | all 2 values and their spreads are accepted |"));
  EXPECT_THAT(good.section, ::testing::Not(HasSubstr("The cause.")));
}

}  // namespace
}  // namespace griffith::app
