#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/core/process.h"

namespace griffith::app {

/// Returns a shell command of these arguments, quoted if necessary.
std::string shell_command(const std::vector<std::string>& words);

/// Describes in a line why a process failed: its last output, the signal, or the time limit.
std::string failure_text(const ProcessOutcome& outcome, const ProcessLimits& limits);

/// Calls work(i) once for each i below `count`, `jobs` at a time in ascending order, until one throws or `cancelled`
/// returns true. Rethrows the first exception.
void work_side_by_side(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                       const std::function<bool()>& cancelled);

/// Returns the path of the running program.
std::filesystem::path this_program();

}  // namespace griffith::app
