#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace griffith {

/// Limits of another program's resources.
struct ProcessLimits {
  double seconds = 0;             ///< real time [s], > 0
  std::int64_t memory_bytes = 0;  ///< address space [bytes], > 0; the largest number means no limit
  double processor_seconds = 0;   ///< processor time of all threads [s]; 0: the limit of real time
};

/// End and output of another program.
struct ProcessOutcome {
  enum class End { exited, killed_by_signal, out_of_time, cancelled, not_found };
  End end = End::exited;
  int code = 0;                        ///< exit code, or number of the signal
  std::string output;                  ///< stdout and stderr together, at most the last megabyte
  std::int64_t peak_memory_bytes = 0;  ///< resident memory [bytes]

  bool succeeded() const { return end == End::exited && code == 0; }
};

/// Runs a program, looked up in PATH, and waits for it. The program has no input and its own process group, so that
/// Ctrl-C reaches only this program. It writes no core file and ends with this program. `on_line` gets each line of its
/// output. `cancelled` is called several times a second and ends it by returning true. Both may be empty. Throws
/// std::runtime_error if no process can be created.
ProcessOutcome run_process(const std::vector<std::string>& arguments, const ProcessLimits& limits,
                           const std::function<void(const std::string& line)>& on_line = {},
                           const std::function<bool()>& cancelled = {});

}  // namespace griffith
