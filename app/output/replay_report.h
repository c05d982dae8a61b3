#pragma once

#include <string>

#include "sim/recording/replay.h"

namespace griffith::app {

/// What came of a replay, in lines: that all steps are equal, or the first that differs, in which fields, and what made
/// the two runs.
std::string replay_report(const Recording& recording, const Replay& replay);

}  // namespace griffith::app
