#pragma once

#include <string>

#include "sim/recording/replay.h"

namespace griffith::app {

/// Describes the result of a replay: equality of all steps, or the first step and fields that differ and the programs
/// that made the two runs.
std::string replay_report(const Recording& recording, const Replay& replay);

}  // namespace griffith::app
