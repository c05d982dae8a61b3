#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/study/sweep.h"

namespace griffith::app {

/// Resources of runs.
struct JobLimits {
  int jobs = 1;  ///< simultaneous runs
  ProcessLimits limits;
};

/// Makes the runs without a record, until `cancelled` returns true. Throws InputError if a record cannot be written.
void make_missing_runs(const Sweep& sweep, const JobLimits& job_limits, const std::function<bool()>& cancelled);

/// Makes the missing pictures of successful runs; stops if the first ones cannot be drawn, such as for lack of
/// graphics. `sweep` has a picture_frame. Returns the reason why one is missing; empty if all exist.
std::string make_missing_pictures(const Sweep& sweep, const std::vector<std::optional<RunRecord>>& records,
                                  const JobLimits& job_limits, const std::function<bool()>& cancelled);

}  // namespace griffith::app
