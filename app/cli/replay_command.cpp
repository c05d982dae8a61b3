#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/cli/commands.h"
#include "app/output/open_world.h"
#include "app/output/output.h"
#include "app/output/replay_report.h"
#include "app/shared/progress.h"
#include "sim/core/error.h"
#include "sim/recording/replay.h"

namespace griffith::app {
namespace {

/// Options of `replay`.
struct ReplayOptions {
  std::filesystem::path recording;
  std::filesystem::path extract;  ///< folder for the recording's files instead of a replay; empty: replays
};

ExitCode extract(const ReplayOptions& options) {
  check_folder(options.extract);
  std::error_code error;
  if (std::filesystem::exists(options.extract, error) && !std::filesystem::is_empty(options.extract, error))
    throw InputError(options.extract.string(), "is not empty", "name a new folder");
  const Recording recording = read_recording(options.recording);
  write_files(files_of(recording), options.extract);
  print("%s: %lld steps; open %s in the editor\n", options.extract.c_str(), static_cast<long long>(recording.steps()),
        (options.extract / "scene.json").c_str());
  return kDone;
}

/// Makes steps until one differs or the end is reached.
ExitCode replay(const ReplayOptions& options) {
  const Recording recording = read_recording(options.recording);
  Replay replay(recording);
  print_warnings(options.recording, replay.world().findings());
  {
    Progress progress("Replaying", static_cast<int>(std::max<std::int64_t>(recording.steps(), 1)));
    while (!replay.at_end() && !replay.difference()) {
      replay.advance();
      progress.update(static_cast<int>(replay.world().frame().step));
    }
  }
  print("%s", replay_report(recording, replay).c_str());
  return replay.difference() ? kFailed : kDone;
}

}  // namespace

Command add_replay(CLI::App& program) {
  CLI::App* command = program.add_subcommand("replay", "Repeat a recorded run and compare every step");
  const auto options = std::make_shared<ReplayOptions>();
  command->add_option("RECORDING", options->recording, "Recording or bug report")->required()->type_name("FILE");
  command
      ->add_option("--extract", options->extract,
                   "Unpack the recording's files into a folder instead; its scene.json opens in the editor")
      ->type_name("DIR");
  add_threads(*command);
  command->footer(
      "Examples:\n"
      "  griffith simulate scenes/wall_small.json --frames 120 --record wall.tar.zst\n"
      "  griffith replay wall.tar.zst\n"
      "  griffith replay wall.tar.zst --extract wall\n\n"
      "Exit code: 0 all steps are equal, 1 a step differs (it is reported with its fields), 2 bad usage or bad input.");
  return {command, [options] { return options->extract.empty() ? replay(*options) : extract(*options); }};
}

}  // namespace griffith::app
