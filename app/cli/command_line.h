#pragma once

namespace griffith::app {

/// What the program answers to the shell.
enum ExitCode : int {
  kDone = 0,
  kFailed = 1,    ///< the work failed: no graphics, no memory
  kBadInput = 2,  ///< bad usage, bad file, bad value, an output that cannot be written
};

/// The whole program. Throws nothing: messages go to stderr, results to files and stdout.
int run(int argc, const char* const* argv);

}  // namespace griffith::app
