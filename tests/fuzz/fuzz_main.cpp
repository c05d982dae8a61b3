#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "sim/core/temporary_folder.h"
#include "tests/fuzz/campaign.h"

namespace griffith::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr char kTargets[] =
    "scene, mesh, surface, cells, points, cache, recording, jobs, suite, sweep, script or command";

Targets make_targets(const std::string& wanted) {
  Targets all;
  for (const auto make : {make_scene_target, make_mesh_target, make_surface_target, make_cells_target,
                          make_points_target, make_cache_target, make_recording_target, make_jobs_target,
                          make_suite_target, make_sweep_target, make_script_target, make_command_target}) {
    auto target = make();
    if (wanted.empty() || wanted == target->name()) all.push_back(std::move(target));
  }
  return all;
}

/// True if the input no longer fails.
bool replay(const Target& target, const fs::path& path, const Limits& limits) {
  const TemporaryFolder folder;
  Sandbox sandbox(folder.path(), limits);
  const auto failure = sandbox.run_one(target, read_input(path));
  std::printf("%s: %s\n", path.c_str(),
              failure ? (std::string(name_of(failure->kind)) + ": " + failure->message).c_str() : "no harm");
  return !failure;
}

/// Replays <folder>/<target>/<case> for all targets and cases; the number of those that fail.
int replay_all(const Targets& targets, const fs::path& folder, const Limits& limits) {
  int failures = 0;
  for (const auto& target : targets) {
    std::vector<fs::path> cases;
    if (fs::exists(folder / target->name()))
      for (const auto& entry : fs::directory_iterator(folder / target->name())) cases.push_back(entry.path());
    std::ranges::sort(cases);
    for (const fs::path& path : cases) failures += !replay(*target, path, limits);
  }
  return failures;
}

int run(int argc, char** argv) {
  CLI::App app(
      "Tries damaged, odd and extreme scenes, meshes, surfaces and other files on their readers and on what "
      "uses what was read. Exit codes: 0 no harm, 1 findings, 2 bad usage.");
  Campaign campaign;
  std::string target;
  fs::path single, folder;
  app.add_option("--seed", campaign.seed, "Another number, other inputs");
  app.add_option("--first", campaign.first, "Number of the first input");
  app.add_option("--inputs", campaign.inputs, "Number of inputs");
  app.add_option("--seconds", campaign.seconds, "No input begins after them");
  app.add_option("--jobs", campaign.jobs, "Processes at once")->check(CLI::Range(1, 256));
  app.add_option("--threads", campaign.threads, "Threads of the simulation in each process")->check(CLI::Range(1, 256));
  app.add_option("--target", target, std::string(kTargets) + " alone");
  app.add_option("--findings", campaign.findings, "Folder for inputs that fail");
  app.add_option("--most-findings", campaign.max_findings, "A job ends after so many different ones");
  app.add_flag("!--as-they-are", campaign.minimize, "Saves inputs that fail without making them smaller");
  app.add_option("--hang", campaign.limits.seconds, "Processor seconds after which an input counts as hanging");
  app.add_option("--replay", single, "An input by itself; needs --target")->check(CLI::ExistingPath);
  app.add_option("--replay-all", folder, "A folder of inputs, <target>/<input>")->check(CLI::ExistingDirectory);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const Targets targets = make_targets(target);
  const bool one = targets.size() == 1;
  if (targets.empty() || (!single.empty() && !one)) {
    std::fprintf(stderr, "--target: %s\n", kTargets);
    return 2;
  }
  if (!single.empty()) return replay(*targets.front(), single, campaign.limits) ? 0 : 1;
  if (!folder.empty()) return replay_all(targets, folder, campaign.limits) > 0;
  return run_campaign(targets, campaign) > 0;
}

}  // namespace
}  // namespace griffith::fuzz

int main(int argc, char** argv) { return griffith::fuzz::run(argc, argv); }
