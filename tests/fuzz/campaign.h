#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <vector>

#include "tests/fuzz/sandbox.h"

namespace griffith::fuzz {

/// Which inputs are tried and for how long.
struct Campaign {
  std::uint64_t seed = 1;
  std::uint64_t first = 0;                                           ///< number of the first input
  std::uint64_t inputs = std::numeric_limits<std::uint64_t>::max();  ///< at most
  double seconds = std::numeric_limits<double>::infinity();          ///< no input begins after them
  int jobs = 1;                                                      ///< processes at once
  int threads = 1;                                                   ///< threads of the simulation, in each
  bool minimize = true;                                              ///< makes inputs that fail smaller
  int max_findings = 20;                                             ///< a job ends after so many
  std::filesystem::path findings = "fuzz_findings";                  ///< folder for inputs that fail
  Limits limits;
};

using Targets = std::vector<std::unique_ptr<Target>>;

/// The input of a number: the same for the same seed and targets.
struct NumberedInput {
  const Target* target = nullptr;
  std::size_t target_index = 0;
  Input input;
};
NumberedInput make_input(const Targets& targets, std::uint64_t seed, std::uint64_t number);

/// Tries inputs, saves those that fail, made smaller, and prints what became of all. The number of different failures.
int run_campaign(const Targets& targets, const Campaign& campaign);

}  // namespace griffith::fuzz
