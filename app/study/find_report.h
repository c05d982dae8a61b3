#pragma once

#include <string>

#include "app/study/find.h"

namespace griffith::app {

/// Adjacent tried values at which all conditions hold.
struct HoldingInterval {
  double low = 0, high = 0;
};

/// Returns the intervals in ascending order.
std::vector<HoldingInterval> holding_intervals(const Trials& trials);

/// Returns the result for people: a table of trials, the intervals in which the conditions hold, the commands that show
/// both sides.
std::string find_text(const Find& find, const Trials& trials);

/// Returns the result as a JSON object: `parameter`, `conditions`, `monotone`, `holds` (intervals), `flips` (brackets)
/// and `tried`.
std::string find_json(const Find& find, const Trials& trials);

}  // namespace griffith::app
