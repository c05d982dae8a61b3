#include "app/cli/command_line.h"

#include <griffith/version.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/help_formatter.h"
#include "app/editor/window.h"
#include "app/output/output.h"
#include "app/shared/scene_files.h"
#include "sim/core/error.h"
#include "sim/core/parallel.h"
#include "sim/core/read_file.h"

namespace griffith::app {
namespace {

constexpr int kMaxThreads = 1024;
constexpr char kThreads[] = "--threads", kSet[] = "--set";

/// Adds the editor, which runs if no command is given.
void add_editor(CLI::App& program, EditorOptions& options, std::vector<std::string>& settings) {
  program.add_option("SCENE", options.scene, "Scene to open in the editor")->type_name("FILE");
  add_settings(program, settings);
  program.add_option("--script", options.script, "Play a script in the editor, see docs/scripts.md")->type_name("FILE");
  program.add_option("--exit-after", options.exit_after)->check(CLI::Range(1, kMaxFrames))->group("");
  program.add_option("--screenshot", options.screenshot)->group("");
  add_threads(program);
}

/// Joins names: "render, simulate and check".
std::string names_of(const std::vector<Command>& commands) {
  std::string names;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (i > 0) names += i + 1 < commands.size() ? ", " : " and ";
    names += commands[i].arguments->get_name();
  }
  return names;
}

/// Throws InputError for a missing scene, or for a misspelled command that would be taken for a scene.
void require_scene(const std::filesystem::path& scene, const std::vector<Command>& commands) {
  std::error_code error;
  if (scene.empty() || std::filesystem::exists(scene, error)) return;
  if (scene.has_extension() || scene.has_parent_path()) {
    const std::vector<std::filesystem::path> samples = scene_files("");
    std::string remedy = "check the path";
    if (!samples.empty()) remedy += "; sample scenes are in " + samples.front().parent_path().string();
    throw InputError(scene.string(), "there is no such scene file", remedy);
  }
  throw InputError(scene.string(), "is neither a command nor a scene file",
                   "the commands are " + names_of(commands) + "; --help describes them");
}

/// Prints the message of CLI11, which may contain file names. Returns its exit code.
int print_parse_result(const CLI::App& program, const CLI::Error& error) {
  std::ostringstream output, problems;
  const int code = program.exit(error, output, problems);
  print("%s", output.str().c_str());
  print_error("%s", problems.str().c_str());
  return code;
}

/// Returns the arguments with "help COMMAND" as "COMMAND --help", as the options say it.
std::vector<const char*> usual_arguments(int argc, const char* const* argv) {
  std::vector<const char*> usual(argv, argv + argc);
  if (argc < 2 || std::string_view(argv[1]) != "help") return usual;
  usual.erase(usual.begin() + 1);
  usual.push_back("--help");
  return usual;
}

/// Parses the arguments. Returns the exit code after --help, --version or bad usage; empty if the arguments are good.
std::optional<ExitCode> parse(CLI::App& program, int argc, const char* const* argv, const EditorOptions& editor,
                              const std::vector<Command>& commands) {
  try {
    program.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ExtrasError& error) {
    if (program.get_subcommands().empty()) require_scene(editor.scene, commands);
    print_parse_result(program, error);
    return kBadInput;
  } catch (const CLI::ParseError& error) {
    return print_parse_result(program, error) == 0 ? kDone : kBadInput;
  }
}

/// Returns the thread limit set by --threads of a command.
std::unique_ptr<ThreadLimit> thread_limit(const CLI::App& command) {
  const CLI::Option* option = command.get_option_no_throw(kThreads);
  return option && *option ? std::make_unique<ThreadLimit>(option->as<int>()) : nullptr;
}

/// Throws InputError for options of the editor before a command, which would have no effect.
void refuse_options_before(const Command& command, const CLI::App& program) {
  const std::string& name = command.arguments->get_name();
  for (const char* option : {kThreads, kSet})
    if (program.get_option(option)->count() > 0)
      throw InputError(option, "is placed before the command " + name, "place it after " + name);
}

/// Runs the command or the editor. Returns the exit code.
ExitCode run_arguments(int argc, const char* const* argv) {
  CLI::App program("Griffith, a workbench for brittle fracture: opens SCENE in the editor, or runs a command.",
                   "griffith");
  program.formatter(std::make_shared<HelpFormatter>());
  program.set_version_flag("--version", "griffith " GRIFFITH_VERSION);
  program.require_subcommand(0, 1);
  program.footer(
      "Examples:\n  griffith scenes/wall_small.json\n  griffith render --help\n\n"
      "Exit code: 0 success, 1 failure, 2 bad usage, bad input or an output that cannot be written.");
  EditorOptions editor;
  std::vector<std::string> set;
  add_editor(program, editor, set);
  std::vector<Command> commands;
  for (const auto& add : kCommands) commands.push_back(add(program));
  const std::vector<const char*> usual = usual_arguments(argc, argv);
  if (const auto code = parse(program, static_cast<int>(usual.size()), usual.data(), editor, commands)) return *code;
  for (const Command& command : commands) {
    if (!command.arguments->parsed()) continue;
    refuse_options_before(command, program);
    const auto limit = thread_limit(*command.arguments);
    return command.carry_out();
  }
  require_scene(editor.scene, commands);
  const auto limit = thread_limit(program);
  editor.settings = settings(set);
  if (!set.empty() && editor.scene.empty()) throw InputError(kSet, "has no scene to change", "name a scene file");
  run_editor(editor);
  return kDone;
}

}  // namespace

void add_threads(CLI::App& command) {
  command.add_option(kThreads, "Number of threads; results do not depend on it")
      ->check(CLI::Range(1, kMaxThreads))
      ->type_name("T");
}

void add_egl_device(CLI::App& command, std::optional<int>& device) {
  command.add_option("--egl-device", device, "EGL device index of the graphics device")
      ->check(CLI::Range(0, 64))
      ->type_name("N");
}

int thread_count(const CLI::App& command) {
  const CLI::Option* option = command.get_option_no_throw(kThreads);
  return option && *option ? option->as<int>() : default_thread_count();
}

void add_settings(CLI::App& command, std::vector<std::string>& texts) {
  command.add_option(kSet, texts, "Set a field of the scene, such as bodies/0/material/density=2000; may be repeated")
      ->allow_extra_args(false)
      ->type_name("POINTER=VALUE");
}

std::vector<SceneSetting> settings(const std::vector<std::string>& texts) {
  std::vector<SceneSetting> settings;
  for (const std::string& text : texts) settings.push_back(read_setting(text, "--set"));
  return settings;
}

CLI::Option* add_pack_outside(CLI::App& command, bool& pack) {
  return command.add_flag("--pack-outside", pack, "Also pack files from outside the scene's folder");
}

int run(int argc, const char* const* argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the shell's limit is an error like a full disk
  try {
    const ExitCode code = run_arguments(argc, argv);
    check_stdout();
    return code;
  } catch (const InputError& error) {
    explain(error);
    return kBadInput;
  } catch (const std::bad_alloc&) {
    print_error("griffith: out of memory\n  use larger elements or fewer bodies\n");
    return kFailed;
  } catch (const std::exception& error) {
    print_error("griffith: %s\n", error.what());
    return kFailed;
  }
}

bool is_recording(const std::filesystem::path& path) {
  require_regular_file(path);
  std::array<char, 4> beginning = {};
  std::ifstream(path, std::ios::binary).read(beginning.data(), beginning.size());
  return beginning == std::array<char, 4>{'\x28', '\xB5', '\x2F', '\xFD'};
}

}  // namespace griffith::app
