#pragma once

#include <span>
#include <string_view>
#include <variant>

#include "sim/world/output/frame.h"

namespace griffith {

/// Total of a counter over many steps: their sum, or the largest of them.
enum class CounterTotal { sum, largest };

/// Meaning of a counter above 0.
enum class CounterConcern { none, warning, error };

/// Number of a step that statistics and the editor show.
struct StepCounter {
  std::string_view key;      ///< as in files: "cracks_postponed"
  std::string_view label;    ///< for a person: "Cracks postponed"
  std::string_view unit;     ///< "m", "-" for a ratio; empty for a count
  std::string_view meaning;  ///< what it counts, and a remedy; all texts end with a zero
  CounterTotal total;
  CounterConcern concern;
  std::variant<int StepReport::*, double StepReport::*> value;
};

/// Returns all counters, in the order of tables. A new one is a line here and in StepReport.
std::span<const StepCounter> step_counters();

/// Returns a counter's number in a step if it warns, else 0.
int warnings_of(const StepCounter& counter, const StepReport& step);
/// Returns the sum of all of these.
int warnings_of(const StepReport& step);

/// Takes a step into the report of many.
void add_step(const StepReport& step, StepReport& total);

}  // namespace griffith
