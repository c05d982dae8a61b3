#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "app/cli/commands.h"
#include "app/editor/imgui_context_owner.h"
#include "app/editor/script_player.h"
#include "app/editor/starting_scene.h"
#include "app/output/output.h"
#include "app/shared/processes.h"
#include "app/shared/scene_files.h"
#include "renderer/egl_context.h"
#include "renderer/target.h"
#include "sim/core/error.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

constexpr int kFewestPixels = 16, kMostPixels = 16384;
constexpr double kFrameSeconds = 1.0 / 60;
constexpr int kFramesToLayOut = 3;

struct ScriptOptions {
  std::filesystem::path script, scene;
  std::vector<std::string> set;
  int width = 1500, height = 940;
};

/// The editor without a window; each frame takes the same time.
class ScriptStage {
 public:
  /// `graphics`: name of the renderer.
  ScriptStage(const ScriptOptions& options, const Scene& scene, std::string graphics)
      : script_(options.script),
        graphics_(std::move(graphics)),
        imgui_(1),
        target_(options.width, options.height),
        editor_(scene, options.scene) {
    editor_.scripting().use_macros(macro_folder());
    editor_.scenes().show_thumbnails({this_program(), thumbnail_cache()});
    for (int i = 0; i < kFramesToLayOut; ++i) draw();
  }

  void play(ScriptPlayer& player) {
    while (!player.done() || !input_.empty() || ui::is_busy(editor_.state())) {
      player.advance(editor_, input_);
      const auto request = editor_.files().take_picture_request();
      draw();
      if (request) editor_.files().save_window_picture(*request, target_.image(), editor_.tags(), graphics_);
      if (const auto file = player.take_picture_request()) save_picture(*file, target_.image());
      if (std::exchange(editor_.requests().screenshot, false)) save_picture(free_screenshot_path(), target_.image());
      leave_processors();
    }
    if (const auto& error = editor_.state().error) throw InputError(error->where, error->problem, error->remedy);
    require_answers();
  }

 private:
  /// Leaves the processors to work in the background as long as the window would.
  void leave_processors() const {
    if (!editor_.state().work.empty())
      std::this_thread::sleep_for(std::chrono::duration<double>(editor_.seconds_to_next_frame()));
  }
  /// Throws InputError if a request of the script still waits for an answer.
  void require_answers() const {
    const ui::EditorState& state = editor_.state();
    if (state.replacement) fail(state.replacement->command, state.replacement->problem, "click replace/replace");
    if (state.unsaved) fail(*state.unsaved, "There are unsaved edits.", "click unsaved/save, or unsaved/discard");
  }
  [[noreturn]] void fail(const ui::Command& command, const std::string& problem, const std::string& answer) const {
    throw InputError(script_.string(), std::string(command.name) + " is waiting: " + problem,
                     "let the script answer the question: " + answer);
  }

  void draw() {
    editor_.run().advance(kFrameSeconds);
    editor_.draw_picture(1);
    input_.play(ImGui::GetIO());
    imgui_.begin_frame(target_.width(), target_.height());
    editor_.draw_panels(imgui_.fonts());
    target_.bind();
    target_.clear({});
    imgui_.end_frame();
  }

  std::filesystem::path script_;
  std::string graphics_;
  ImGuiContextOwner imgui_;
  render::Target target_;
  Editor editor_;
  ui::InputQueue input_;
};

void play_script(const ScriptOptions& options) {
  ScriptPlayer player(read_script(options.script), false);
  const Scene scene = options.scene.empty() ? starting_scene() : read_scene(options.scene, settings(options.set));
  const render::EglContext context;
  ScriptStage stage(options, scene, context.renderer());
  stage.play(player);
}

}  // namespace

Command add_script(CLI::App& program) {
  CLI::App* command = program.add_subcommand("script", "Play a script in the editor without a window");
  const auto options = std::make_shared<ScriptOptions>();
  command->add_option("SCRIPT", options->script, "Script file, see docs/scripts.md")->required()->type_name("FILE");
  command->add_option("SCENE", options->scene, "Scene to open first")->type_name("FILE");
  add_settings(*command, options->set);
  command->add_option("--width", options->width, "Width of the window [pixels]")
      ->check(CLI::Range(kFewestPixels, kMostPixels));
  command->add_option("--height", options->height, "Height of the window [pixels]")
      ->check(CLI::Range(kFewestPixels, kMostPixels));
  add_threads(*command);
  command->footer(
      "Example:\n  griffith script bug.script scenes/wall_small.json\n\n"
      "Exit code 2 if a line cannot be played or an expectation fails.");
  return {command, [options] {
            play_script(*options);
            return kDone;
          }};
}

}  // namespace griffith::app
