#pragma once

namespace griffith::app {

/// Exit codes of the program.
enum ExitCode : int {
  kDone = 0,
  kFailed = 1,    ///< the work failed: no graphics, no memory
  kBadInput = 2,  ///< bad usage, bad file, bad value, an output that cannot be written
};

/// Runs the program. Throws nothing: messages go to stderr, results to files and stdout.
int run(int argc, const char* const* argv);

}  // namespace griffith::app
