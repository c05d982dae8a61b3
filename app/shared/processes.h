#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/core/process.h"

namespace griffith::app {

/// A shell's command of these arguments, quoted where need be.
std::string shell_command(const std::vector<std::string>& words);

/// Why a process failed, in a line: what it wrote last, the signal, or the time that it was given.
std::string failure_text(const ProcessOutcome& outcome, const ProcessLimits& limits);

/// Calls work(i) once for each i below `count`, `jobs` at a time, beginning with low numbers, until one throws or
/// `cancelled` says so. Throws what the first of them threw.
void work_side_by_side(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                       const std::function<bool()>& cancelled);

/// The program that this process runs.
std::filesystem::path this_program();

}  // namespace griffith::app
