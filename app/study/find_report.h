#pragma once

#include <string>

#include "app/study/find.h"

namespace griffith::app {

/// Values next to each other among those tried at which all conditions hold.
struct HoldingInterval {
  double low = 0, high = 0;
};

/// From below.
std::vector<HoldingInterval> holding_intervals(const Trials& trials);

/// The answer for a person: a table of what was tried, where the conditions hold, the commands that show both sides.
std::string find_text(const Find& find, const Trials& trials);

/// The same as a JSON object: `parameter`, `conditions`, `monotone`, `holds` (intervals), `flips` (brackets) and
/// `tried`.
std::string find_json(const Find& find, const Trials& trials);

}  // namespace griffith::app
