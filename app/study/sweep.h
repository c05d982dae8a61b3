#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/study/run_request.h"
#include "app/study/sweep_plan.h"

namespace griffith::app {

/// Definition of a sweep, as given by the user.
struct SweepDefinition {
  std::filesystem::path scene;
  int frames = 0;
  std::vector<std::string> set;   ///< "POINTER=VALUE", for all runs
  std::vector<std::string> vary;  ///< as for read_parameter()
  int samples = 0;                ///< size of a Latin hypercube; 0: none
  std::uint64_t seed = 1;         ///< seed of the Latin hypercube
  int seeds = 0;                  ///< number of seeds of the random strength; 0: unchanged
};

/// A sweep: its runs and the places of their results.
struct Sweep {
  SweepDefinition definition;
  std::vector<SceneSetting> settings;  ///< for all runs
  SweepPlan plan;
  std::filesystem::path folder;
  std::filesystem::path program;
  std::optional<int> picture_frame = {};  ///< time steps before the picture of a run; none: no pictures

  std::size_t size() const { return plan.runs.size(); }
  RunRequest request(std::size_t run) const;
  std::filesystem::path record_file(std::size_t run) const;   ///< runs/0001.json
  std::filesystem::path picture_file(std::size_t run) const;  ///< pictures/step_20/0001.png; needs picture_frame
};

/// Makes a sweep and checks every run's scene. Throws InputError for input that cannot be read.
Sweep make_sweep(const SweepDefinition& definition, const std::filesystem::path& folder);

/// Returns a shell command for each run, one per line, which skips finished runs.
std::string job_list(const Sweep& sweep);

}  // namespace griffith::app
