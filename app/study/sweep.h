#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/study/run_request.h"
#include "app/study/sweep_plan.h"

namespace griffith::app {

/// What a sweep is, as its user says it.
struct SweepDefinition {
  std::filesystem::path scene;
  int frames = 0;
  std::vector<std::string> set;   ///< "POINTER=VALUE", for all runs
  std::vector<std::string> vary;  ///< as read_parameter() takes them
  int samples = 0;                ///< of a Latin hypercube; 0: none
  std::uint64_t seed = 1;         ///< of the Latin hypercube
  int seeds = 0;                  ///< of the scene's random strength; 0: left as they are
};

/// A sweep: its runs and where their results are.
struct Sweep {
  SweepDefinition definition;
  std::vector<SceneSetting> settings;  ///< of all runs
  SweepPlan plan;
  std::filesystem::path folder;
  std::filesystem::path program;
  std::optional<int> picture_frame = {};  ///< time steps before the picture of a run; none: no pictures

  std::size_t size() const { return plan.runs.size(); }
  RunRequest request(std::size_t run) const;
  std::filesystem::path record_file(std::size_t run) const;   ///< runs/0001.json
  std::filesystem::path picture_file(std::size_t run) const;  ///< pictures/step_20/0001.png; there are pictures
};

/// Checks every run's scene. Throws InputError for what cannot be read.
Sweep make_sweep(const SweepDefinition& definition, const std::filesystem::path& folder);

/// A shell's command a line, which makes a run unless it has been made.
std::string job_list(const Sweep& sweep);

}  // namespace griffith::app
