#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/study/sweep.h"

namespace griffith::app {

/// What runs may use.
struct Effort {
  int jobs = 1;  ///< at a time
  ProcessLimits limits;
};

/// Makes the runs that have no record, until `cancelled` says so. Throws InputError when a record cannot be written.
void make_missing_runs(const Sweep& sweep, const Effort& effort, const std::function<bool()>& cancelled);

/// Makes the pictures of the runs that succeeded and have none; gives up where the first ones cannot be drawn, such as
/// for want of graphics. `sweep` has a picture_frame. Returns why one is missing; empty: all are there.
std::string make_missing_pictures(const Sweep& sweep, const std::vector<std::optional<RunRecord>>& records,
                                  const Effort& effort, const std::function<bool()>& cancelled);

}  // namespace griffith::app
