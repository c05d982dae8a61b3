#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/sweep.h"

namespace griffith::app {

/// Returns a page about a sweep: scatter plot, heat map, contact sheet and table, each run with the command that opens
/// it in the editor. `note`: a remark for the reader; empty: none. Throws InputError if a picture cannot be read.
std::string sweep_page(const Sweep& sweep, const std::vector<std::optional<RunRecord>>& records,
                       const std::string& note);

}  // namespace griffith::app
