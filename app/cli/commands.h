#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command_line.h"
#include "app/study/sweep_runs.h"
#include "sim/scene/scene_setting.h"

namespace griffith::app {

/// A command of the program: its arguments and its action after parsing. The action throws InputError for bad input,
/// and other exceptions if the work failed.
struct Command {
  CLI::App* arguments = nullptr;
  std::function<ExitCode()> carry_out;
};

/// Largest number of steps, which no run of useful length reaches.
inline constexpr int kMaxFrames = 10'000'000;

/// Adds the option --threads, which the command line applies.
void add_threads(CLI::App& command);
/// Returns the number of threads of --threads, or that of the machine.
int thread_count(const CLI::App& command);

/// Adds the option --egl-device.
void add_egl_device(CLI::App& command, std::optional<int>& device);

/// Adds the option --set; settings() parses its texts.
void add_settings(CLI::App& command, std::vector<std::string>& texts);
/// Parses the "POINTER=VALUE" texts of --set. Throws InputError.
std::vector<SceneSetting> settings(const std::vector<std::string>& texts);

/// Adds --pack-outside, without which a recording contains no files from outside the scene's folder.
CLI::Option* add_pack_outside(CLI::App& command, bool& pack);

/// Adds --jobs, --time-limit and --memory-limit. `limits` must outlive the command.
void add_job_limits(CLI::App& command, JobLimits& job_limits);

/// True if a file is a recording or a bug report rather than a scene: it begins with Zstandard's magic number. Throws
/// InputError if it cannot be read.
bool is_recording(const std::filesystem::path& path);

// Each is in a file of its own with its arguments.
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
Command add_validate(CLI::App& program);
Command add_gallery(CLI::App& program);

/// All commands in the order of --help.
inline constexpr std::array kCommands = {add_render,  add_simulate, add_check,     add_mesh,    add_export,
                                         add_regress, add_sweep,    add_find,      add_replay,  add_bundle,
                                         add_script,  add_bench,    add_thumbnail, add_gallery, add_validate};

}  // namespace griffith::app
