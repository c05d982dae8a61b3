#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace griffith {

/// What another program may use.
struct ProcessLimits {
  double seconds = 0;             ///< of real time, > 0
  std::int64_t memory_bytes = 0;  ///< of address space, > 0; no limit where it is the largest number there is
  double processor_seconds = 0;   ///< of all threads; 0: as many as of real time
};

/// How another program ended, and what it wrote.
struct ProcessOutcome {
  enum class End { exited, killed_by_signal, out_of_time, cancelled, not_found };
  End end = End::exited;
  int code = 0;                        ///< exit code, or the number of the signal
  std::string output;                  ///< stdout and stderr together; of much output the last megabyte
  std::int64_t peak_memory_bytes = 0;  ///< resident

  bool succeeded() const { return end == End::exited && code == 0; }
};

/// Runs a program, looked up in PATH, and waits for it. It has no input, is no part of the terminal's process group (so
/// Ctrl-C reaches this program alone), writes no core file and dies with this program. `on_line` gets each line of its
/// output, `cancelled` is asked some times a second and ends it; both may be empty. Throws std::runtime_error when no
/// process can be made.
ProcessOutcome run_process(const std::vector<std::string>& arguments, const ProcessLimits& limits,
                           const std::function<void(const std::string& line)>& on_line = {},
                           const std::function<bool()>& cancelled = {});

}  // namespace griffith
