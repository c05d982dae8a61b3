#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/cli/command_line.h"
#include "app/study/sweep_runs.h"
#include "sim/recording/recording.h"
#include "sim/scene/scene_setting.h"

namespace griffith::app {

/// A command of the program: its arguments, and what carries it out when they are parsed. That throws InputError for
/// bad input, other exceptions where the work failed.
struct Command {
  CLI::App* arguments = nullptr;
  std::function<ExitCode()> carry_out;
};

/// Steps of which nothing is shown of time that long.
inline constexpr int kMaxFrames = 10'000'000;

/// Adds the option --threads, which the command line itself heeds.
void add_threads(CLI::App& command);
/// Threads that --threads asks for, or as many as the machine has.
int thread_count(const CLI::App& command);

/// Adds the option --set, whose texts settings() reads.
void add_settings(CLI::App& command, std::vector<std::string>& texts);
/// The settings in "POINTER=VALUE" texts of --set. Throws InputError.
std::vector<SceneSetting> settings(const std::vector<std::string>& texts);

/// Adds --pack-outside, without which a recording takes no files from outside the scene's folder.
CLI::Option* add_pack_outside(CLI::App& command, bool& pack);
inline OutsideFiles outside_files(bool pack) { return pack ? OutsideFiles::pack : OutsideFiles::refuse; }

/// Adds --jobs, --time-limit and --memory-limit. `effort` outlives the command.
void add_effort(CLI::App& command, Effort& effort);

/// Whether a file is a recording or a bug report and no scene: it begins as Zstandard's files do. Throws InputError
/// when it cannot be read.
bool is_recording(const std::filesystem::path& path);

// Each is in a file of its own, with what its arguments mean.
Command add_render(CLI::App& program);
Command add_export(CLI::App& program);
Command add_simulate(CLI::App& program);
Command add_check(CLI::App& program);
Command add_mesh(CLI::App& program);
Command add_regress(CLI::App& program);
Command add_sweep(CLI::App& program);
Command add_find(CLI::App& program);
Command add_replay(CLI::App& program);
Command add_bundle(CLI::App& program);
Command add_script(CLI::App& program);
Command add_bench(CLI::App& program);
Command add_thumbnail(CLI::App& program);

/// All commands, in the order in which --help lists them.
inline constexpr std::array kCommands = {add_render,  add_simulate, add_check,    add_mesh,   add_export,
                                         add_regress, add_sweep,    add_find,     add_replay, add_bundle,
                                         add_script,  add_bench,    add_thumbnail};

}  // namespace griffith::app
