#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "app/shared/flip_search.h"
#include "app/shared/processes.h"
#include "app/study/expression.h"
#include "app/study/proportion.h"
#include "app/study/run_request.h"
#include "app/study/sweep_plan.h"
#include "tests/input_error_of.h"

namespace griffith::app {
namespace {

using Values = std::vector<std::string>;

Values values_in(const std::string& text) { return read_parameter("a/b=" + text, "--vary").values; }

std::string complaint_about(const std::string& text) {
  return input_error_of([&] { read_parameter(text, "--vary"); });
}

TEST(Parameter, RangesReachBothEndsEvenly) {
  EXPECT_EQ(values_in("1:3:5"), (Values{"1", "1.5", "2", "2.5", "3"}));
  EXPECT_EQ(values_in("-1:1:3"), (Values{"-1", "0", "1"}));
  EXPECT_EQ(values_in("0.1:0.3:3"), (Values{"0.1", "0.2", "0.3"}));
  EXPECT_EQ(values_in("1:1000:4log"), (Values{"1", "10", "100", "1000"}));
}

TEST(Parameter, ListsHoldNumbersWordsAndJson) {
  EXPECT_EQ(values_in("2,4"), (Values{"2", "4"}));
  EXPECT_EQ(values_in("glass,true,\"a,b\",[1,2],{\"x\":[3,4]}"),
            (Values{"\"glass\"", "true", "\"a,b\"", "[1,2]", "{\"x\":[3,4]}"}));
}

TEST(Parameter, WithoutACountIsARangeToSample) {
  const Parameter parameter = read_parameter("#/a/b=1:100:log", "--vary");
  EXPECT_TRUE(parameter.values.empty());
  EXPECT_TRUE(parameter.range->logarithmic);
  EXPECT_EQ(parameter.pointers, Values{"/a/b"});
  EXPECT_EQ(parameter.name, "a/b");
  EXPECT_DOUBLE_EQ(parameter.range->at(0.5), 10);
}

TEST(Parameter, RefusalsSayWhatIsWrong) {
  EXPECT_NE(complaint_about("a/b").find("no values"), std::string::npos);
  EXPECT_NE(complaint_about("a/b=3:1:5").find("ascending"), std::string::npos);
  EXPECT_NE(complaint_about("a/b=0:1:5log").find("above 0"), std::string::npos);
  EXPECT_NE(complaint_about("a/b=1:2:1").find("count"), std::string::npos);
  EXPECT_NE(complaint_about("a/b=1:2:3lag").find("count"), std::string::npos);
  EXPECT_NE(complaint_about("a/b=1:x").find("not a range"), std::string::npos);
  EXPECT_NE(complaint_about("a/b=1,,2").find("empty"), std::string::npos);
  EXPECT_NE(complaint_about("=1,2").find("pointer"), std::string::npos);
}

TEST(SweepPlan, IsTheProductWithTheLastParameterFastest) {
  const SweepPlan plan = make_plan({read_parameter("a=1,2", ""), read_parameter("b=x,y,z", "")}, 0, 1);
  ASSERT_EQ(plan.runs.size(), 6u);
  EXPECT_EQ(plan.runs[0], (Values{"1", "\"x\""}));
  EXPECT_EQ(plan.runs[1], (Values{"1", "\"y\""}));
  EXPECT_EQ(plan.runs[3], (Values{"2", "\"x\""}));
  EXPECT_EQ(std::set<Values>(plan.runs.begin(), plan.runs.end()).size(), 6u);
}

TEST(SweepPlan, RefusesWhatItCannotMake) {
  EXPECT_NE(input_error_of([] { make_plan({read_parameter("a=1:2", "")}, 0, 1); }).find("--latin-hypercube"),
            std::string::npos);
  EXPECT_NE(input_error_of([] { make_plan({read_parameter("a=1,2", "")}, 5, 1); }).find("no range"), std::string::npos);
  EXPECT_NE(input_error_of([] {
              make_plan({read_parameter("a=1,2", ""), read_parameter("/a=3", "")}, 0, 1);
            }).find("repeated"),
            std::string::npos);
  EXPECT_NE(input_error_of([] {
              make_plan({read_parameter("a=1:2:1000", ""), read_parameter("b=1:2:1000", "")}, 0, 1);
            }).find("100,000"),
            std::string::npos);
  const auto order = [](const char* first, const char* second) {
    make_plan({read_parameter(first, ""), read_parameter(second, "")}, 0, 1);
  };
  EXPECT_NE(input_error_of([&] { order("a/material/density=1,2", "a/material=brick,oak"); }).find("overrides"),
            std::string::npos);
  EXPECT_EQ(input_error_of([&] { order("a/material=brick,oak", "a/material/density=1,2"); }), "no error");
  EXPECT_EQ(input_error_of([&] { order("a/b=1,2", "a/bc=1,2"); }), "no error");
}

TEST(SweepPlan, LatinHypercubeHasEachStratumOfEachAxisOnce) {
  constexpr int kSamples = 37;
  const auto points = latin_hypercube(kSamples, 3, 5);
  ASSERT_EQ(points.size(), 37u);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::set<int> strata;
    for (const auto& point : points) strata.insert(static_cast<int>(std::floor(point[axis] * kSamples)));
    EXPECT_EQ(strata.size(), 37u);
    EXPECT_EQ(*strata.begin(), 0);
    EXPECT_EQ(*strata.rbegin(), kSamples - 1);
  }
}

TEST(SweepPlan, TheSameSeedMakesTheSamePointsAndAnotherOthers) {
  EXPECT_EQ(latin_hypercube(20, 2, 7), latin_hypercube(20, 2, 7));
  EXPECT_NE(latin_hypercube(20, 2, 7), latin_hypercube(20, 2, 8));
}

TEST(SweepPlan, SamplesRangesTogetherAndCombinesThemWithLists) {
  const SweepPlan plan =
      make_plan({read_parameter("a=0:1", ""), read_parameter("b=x,y", ""), read_parameter("c=1:100:log", "")}, 10, 3);
  ASSERT_EQ(plan.runs.size(), 20u);
  std::set<int> decades;
  for (const Values& run : plan.runs) decades.insert(static_cast<int>(std::floor(5 * std::log10(std::stod(run[2])))));
  EXPECT_EQ(decades.size(), 10u);
  EXPECT_EQ(plan.runs[0][0], plan.runs[1][0]);
  EXPECT_NE(plan.runs[0][1], plan.runs[1][1]);
}

TEST(SweepPlan, SeedsGoToEveryBodyOfRandomStrength) {
  Scene scene;
  scene.bodies.resize(3);
  EXPECT_NE(input_error_of([&] { seed_parameter(scene, 2); }).find("random strength"), std::string::npos);
  scene.bodies[0].strength_scatter.emplace();
  scene.bodies[2].strength_scatter.emplace();
  const Parameter seeds = seed_parameter(scene, 3);
  EXPECT_EQ(seeds.pointers, (Values{"/bodies/0/strength_scatter/seed", "/bodies/2/strength_scatter/seed"}));
  EXPECT_EQ(seeds.values, (Values{"1", "2", "3"}));
}

/// Outcomes with `value` for `key` and zeros.
Outcomes with_outcome(const char* key, double value) {
  Outcomes outcomes(outcome_kinds().size());
  outcomes[outcome_index(key, "")] = value;
  return outcomes;
}

bool holds(const std::string& expression, const char* key, double value) {
  return read_expression(expression, "").holds(with_outcome(key, value));
}

TEST(Expression, ComparesAsItSays) {
  EXPECT_TRUE(holds("pieces > 1", "pieces", 2));
  EXPECT_FALSE(holds("pieces > 1", "pieces", 1));
  EXPECT_TRUE(holds("pieces>=1", "pieces", 1));
  EXPECT_FALSE(holds("pieces < 1", "pieces", 1));
  EXPECT_TRUE(holds("pieces <= 1", "pieces", 1));
  EXPECT_TRUE(holds("pieces == 3", "pieces", 3));
  EXPECT_TRUE(holds("pieces != 3", "pieces", 4));
  EXPECT_TRUE(holds("pieces in 15:25", "pieces", 15));
  EXPECT_TRUE(holds(" pieces  in 15 : 25 ", "pieces", 25));
  EXPECT_FALSE(holds("pieces in 15:25", "pieces", 26));
  EXPECT_FALSE(holds("pieces > 1, pieces < 3", "pieces", 3));
  EXPECT_TRUE(holds("crack_area > 1.5e-2", "crack_area", 0.02));
}

TEST(Expression, WhatNeverCameIsLaterThanAnyTime) {
  EXPECT_TRUE(holds("breaking_time > 1e300", "breaking_time", kNever));
  EXPECT_FALSE(holds("breaking_time < 1e300", "breaking_time", kNever));
}

TEST(Expression, RefusalsNameThePlace) {
  const auto refusal = [](const char* text) { return input_error_of([&] { read_expression(text, "--outcome"); }); };
  EXPECT_NE(refusal("piecs > 1").find("did you mean \"pieces\""), std::string::npos);
  EXPECT_NE(refusal("pieces >> 1").find("a number before \"> 1\""), std::string::npos);
  EXPECT_NE(refusal("pieces 1").find("before \"1\""), std::string::npos);
  EXPECT_NE(refusal("pieces > ").find("at its end"), std::string::npos);
  EXPECT_NE(refusal("pieces in 3").find("a colon"), std::string::npos);
  EXPECT_NE(refusal("pieces in 3:1").find("descending"), std::string::npos);
  EXPECT_NE(refusal("pieces > 1 and more").find("before \"and more\""), std::string::npos);
  EXPECT_NE(refusal("").find("the name of an outcome"), std::string::npos);
}

TEST(Expression, AConditionMayHaveSettings) {
  const Condition plain = read_condition("pieces in 1:5", "");
  EXPECT_TRUE(plain.settings.empty());
  const Condition condition = read_condition("projectiles/0/speed=3, name=x: pieces > 1, pieces in 15:25", "");
  EXPECT_EQ(condition.settings, (std::vector<SceneSetting>{{"/projectiles/0/speed", "3"}, {"/name", "\"x\""}}));
  EXPECT_EQ(condition.expression.comparisons.size(), 2u);
  EXPECT_TRUE(read_condition("pieces == 5", "").settings.empty());
  const Condition place = read_condition(R"(projectiles/0/position=[0, 1, 5], name="a:b": pieces > 1)", "");
  ASSERT_EQ(place.settings.size(), 2u);
  EXPECT_EQ(place.settings[0].value, "[0, 1, 5]");
  EXPECT_EQ(place.settings[1].value, "\"a:b\"");
}

/// By the closed form of the interval, solved by hand: (2 p n + z² ± z √(z² + 4 p n (1 − p))) / (2 (n + z²)).
TEST(Proportion, WilsonsIntervalAgainstClosedValues) {
  const auto expect = [](int successes, int trials, double low, double high) {
    const ConfidenceInterval interval = wilson_interval({successes, trials});
    EXPECT_NEAR(interval.low, low, 1e-4) << successes << "/" << trials;
    EXPECT_NEAR(interval.high, high, 1e-4) << successes << "/" << trials;
  };
  expect(0, 10, 0, 0.2775);
  expect(10, 10, 0.7225, 1);
  expect(5, 10, 0.2366, 0.7634);
  expect(81, 263, 0.2553, 0.3662);  // R. G. Newcombe, Statistics in Medicine 17, 1998, table I
  expect(0, 0, 0, 1);
}

/// Condition that holds at some values, with a count of calls.
struct Asked {
  std::function<bool(double)> holds;
  int count = 0;
  std::vector<State> operator()(const std::vector<double>& values) {
    count += static_cast<int>(values.size());
    std::vector<State> states;
    for (const double value : values) states.push_back({holds(value) ? 1 : 0});
    return states;
  }
};

TEST(FlipSearch, BracketsAThresholdAsNarrowlyAsAsked) {
  for (const int at_a_time : {1, 3}) {
    Asked asked{[](double value) { return value > M_PI; }};
    const FlipSearch search{.geometric = true, .tolerance = 1e-3, .values_at_a_time = at_a_time};
    const auto flips = flips_among(search_flips(search, {1, 100}, std::ref(asked)));
    ASSERT_EQ(flips.size(), 1u);
    EXPECT_LE(flips[0].below, M_PI);
    EXPECT_GT(flips[0].above, M_PI);
    EXPECT_LE(flips[0].above / flips[0].below, 1.001);
    EXPECT_LT(asked.count, at_a_time == 1 ? 20 : 30);
  }
}

TEST(FlipSearch, WorksAcrossZeroAndDownwards) {
  Asked asked{[](double value) { return value < 0.125; }};
  const auto flips = flips_among(search_flips({.tolerance = 0.01}, {-1, 1}, std::ref(asked)));
  ASSERT_EQ(flips.size(), 1u);
  EXPECT_LE(flips[0].above - flips[0].below, 0.02);
  EXPECT_LT(flips[0].below, 0.125);
  EXPECT_GE(flips[0].above, 0.125);
}

TEST(FlipSearch, OfWholeNumbersEndsBetweenNeighbors) {
  Asked asked{[](double value) { return value >= 6; }};
  const auto flips = flips_among(search_flips({.whole = true}, {1, 9}, std::ref(asked)));
  ASSERT_EQ(flips.size(), 1u);
  EXPECT_EQ(flips[0].below, 5);
  EXPECT_EQ(flips[0].above, 6);
}

TEST(FlipSearch, SeesThatATestIsNotMonotone) {
  Asked asked{[](double value) { return value > 2 && value < 7; }};
  const auto tried = search_flips({.tolerance = 0.001}, {0, 2.5, 5, 7.5, 10}, std::ref(asked));
  EXPECT_EQ(flips_among(tried).size(), 2u);
}

TEST(FlipSearch, FindsWhatLiesBetweenTwoChanges) {
  const auto side = [](const std::vector<double>& values) {
    std::vector<State> states;
    for (const double value : values) states.push_back({value < 6.2 ? -1 : value > 6.3 ? 1 : 0});
    return states;
  };
  const auto tried = search_flips({.tolerance = 0.001}, {0, 10}, side);
  EXPECT_EQ(flips_among(tried).size(), 2u);
}

TEST(FlipSearch, EndsWhereEverythingChangesAllTheTime) {
  Asked asked{[](double value) { return static_cast<long>(value * 1e6) % 2 == 0; }};
  EXPECT_LT(search_flips({.tolerance = 1e-6}, {0, 0.5000011, 1}, std::ref(asked)).size(), 220u);
}

TEST(FlipSearch, WidensUntilItFlipsAndNoFurther) {
  Asked asked{[](double value) { return value > 30; }};
  const auto all = [](double) { return true; };
  EXPECT_EQ(widened_until_flip(10, 10, all, std::ref(asked)), (std::vector<double>{2.5, 5, 10, 20, 40}));
}

TEST(FlipSearch, WidensToTheEndOfWhatIsAllowed) {
  Asked asked{[](double) { return true; }};
  const auto values = widened_until_flip(
      0.3, 5, [](double value) { return value <= 1; }, std::ref(asked));
  EXPECT_NEAR(values.back(), 1, 1e-3);
  EXPECT_LE(values.back(), 1);
}

TEST(RunRequest, CommandsAreQuotedForTheShell) {
  EXPECT_EQ(shell_command({"griffith", "a b.json", "--set", "name=it's", ""}),
            "griffith 'a b.json' --set 'name=it'\\''s' ''");
}

TEST(RunRequest, ASettingIsOneLineOfTheShellWhateverItsJson) {
  EXPECT_EQ(setting_value("{\n\"friction\":\r\n0.5}"), "{ \"friction\":  0.5}");
  EXPECT_EQ(setting_value("a\nb"), "\"a\\nb\"");
}

TEST(RunRequest, ASettingIsANumberAsPeopleWriteIt) {
  EXPECT_EQ(setting_value(".5"), "0.5");
  EXPECT_EQ(setting_value("-.5e3"), "-500.0");
  EXPECT_EQ(setting_value("+5."), "5.0");
  for (const char* word : {"inf", "nan", ".", "5.m", "+", "1..2"})
    EXPECT_EQ(setting_value(word), "\"" + std::string(word) + "\"");
}

TEST(RunRecord, ComesBackAsItWas) {
  Outcomes outcomes(outcome_kinds().size(), 1.0 / 3);
  outcomes[outcome_index("breaking_time", "")] = kNever;
  EXPECT_EQ(record_from_json(record_json({outcomes, {}}), "").outcomes, outcomes);
  outcomes[0] = -kNever;
  outcomes[1] = std::nan("");
  const Outcomes back = record_from_json(record_json({outcomes, {}}), "").outcomes;
  EXPECT_EQ(back[0], -kNever);
  EXPECT_TRUE(std::isnan(back[1])) << back[1];
  EXPECT_EQ(record_from_json(record_json({{}, "a \"bad\" end\xff"}), "").error.substr(0, 11), "a \"bad\" end");
  EXPECT_NE(input_error_of([] { record_from_json("{\"outcomes\": {\"pieces\": 1", "x.json"); }).find("x.json"),
            std::string::npos);
  EXPECT_NE(input_error_of([] { record_from_json("{\"outcomes\": {\"pieces\": 1}}", "x.json"); }).find("fragments"),
            std::string::npos);
}

}  // namespace
}  // namespace griffith::app
