#include "sim/world/output/step_counters.h"

#include <gtest/gtest.h>

#include <set>

namespace griffith {
namespace {

double value_of(const StepCounter& counter, const StepReport& report) {
  return std::visit([&](auto value) { return static_cast<double>(report.*value); }, counter.value);
}

/// A report whose counters all differ.
StepReport numbered_from(int first) {
  StepReport report;
  for (const StepCounter& counter : step_counters())
    std::visit([&](auto value) { report.*value = first++; }, counter.value);
  return report;
}

TEST(StepCounters, ManyStepsAddUpOrGiveTheLargest) {
  const StepReport first = numbered_from(100), second = numbered_from(30);
  StepReport total;
  total.substeps = 0;
  for (const StepReport& step : {first, second}) add_step(step, total);
  for (const StepCounter& counter : step_counters()) {
    const double a = value_of(counter, first), b = value_of(counter, second);
    EXPECT_EQ(value_of(counter, total), counter.total == CounterTotal::sum ? a + b : a) << counter.key;
  }
}

TEST(StepCounters, EachIsToldApart) {
  std::set<std::string_view> keys, labels;
  for (const StepCounter& counter : step_counters()) {
    EXPECT_TRUE(keys.insert(counter.key).second && labels.insert(counter.label).second) << counter.key;
    EXPECT_EQ(counter.meaning.back(), '.') << counter.key;
    const bool counts = std::holds_alternative<int StepReport::*>(counter.value);
    EXPECT_EQ(counter.unit.empty(), counts) << counter.key;
  }
}

}  // namespace
}  // namespace griffith
