#include <algorithm>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/editor_commands.h"
#include "app/editor/messages.h"
#include "app/shared/scene_files.h"

namespace griffith::app {
using ui::CommandArgument;
using ui::CommandContext;
using ui::Menu;
namespace key = ui::key;

namespace {

std::string_view no_recoverable_edits(const CommandContext& context) {
  return unless(!context.state.recoverable_edits.empty(), "There are no edits to recover.");
}

std::string_view nothing_recorded(const CommandContext& context) {
  return unless(context.time.last_step > context.time.first_step, "No step has been simulated yet.");
}

std::string_view nothing_plotted(const CommandContext& context) {
  const auto is_taken = [](const std::string& key) { return !key.empty(); };
  return unless(std::ranges::any_of(context.state.preferences.plotted, is_taken), "No series is plotted.");
}

std::filesystem::path file_named(std::string name) {
  std::ranges::replace(name, '/', '-');
  return name.empty() ? "scene.json" : name + ".json";
}

void ask_where_to_save(Editor& e, std::filesystem::path proposed) {
  const SceneDocument& document = e.document();
  if (proposed.empty()) proposed = document.path().empty() ? file_named(document.scene().name) : document.path();
  e.state().save_as = ui::save_target(proposed);
  for (const std::filesystem::path& file : scenes_in(e.state().save_as->folder))
    e.state().save_as->existing.push_back(file.filename().string());
}

void save(Editor& e, const ui::Command& command) {
  SceneDocument& document = e.document();
  const std::filesystem::path file = command.path.empty() ? document.path() : command.path;
  if (file.empty()) return ask_where_to_save(e, {});
  if (std::filesystem::is_directory(file)) throw InputError(file.string(), "is a folder", "choose the name of a file");
  if (std::string problem = document.saving_problem(file); !command.replace && !problem.empty()) {
    e.state().replacement = ui::Replacement{command, std::move(problem)};
    return;
  }
  const std::optional<ui::Command> next = std::exchange(e.state().after_save, std::nullopt);
  document.save(file, e.state().view);
  e.scenes().list(file);
  e.recovery().remove_copy();
  e.scenes().remember(document.absolute_path());
  log_message(e.state(), ui::LogLevel::info, "Saved " + file.string());
  if (document.history().has_later_edits())
    log_message(e.state(), ui::LogLevel::warning,
                "Saved the materials of " + e.run().moment_text() +
                    ". The run has edits of later steps: go there and save to keep them.");
  if (next) e.execute(*next);
}

void quit(Editor& e) {
  e.recovery().remove_copy();
  e.requests().quit = true;
}

const EditorCommand kFileCommands[] = {
    {{.name = "file.new",
      .label = "New",
      .hint = "Create an empty scene with only the ground",
      .menu = Menu::file,
      .shortcut = {'N', true},
      .leaves = "Opening another scene"},
     [](Editor& e, const ui::Command&) { e.builder().open_empty(); }},
    {{.name = "file.open",
      .label = "Open…",
      .hint = "Open a scene; or drop its file on the window",
      .menu = Menu::file,
      .shortcut = {'O', true},
      .argument = CommandArgument::path,
      .with_path = "file.open_path"},
     [](Editor& e, const ui::Command&) { e.state().show_open = true; }},
    {{.name = "file.scenes",
      .label = "Scenes…",
      .hint = "Browse pictures of the sample scenes and of those in this scene's folder",
      .menu = Menu::file,
      .shortcut = {'O', true, true}},
     [](Editor& e, const ui::Command&) { e.state().browser.shown = true; }},
    {{.name = "file.save",
      .label = "Save",
      .hint = "Save the scene with its current view",
      .menu = Menu::file,
      .group = 1,
      .shortcut = {'S', true},
      .argument = CommandArgument::path,
      .for_pictures = false},
     [](Editor& e, const ui::Command& c) { save(e, c); }},
    {{.name = "file.save_as",
      .label = "Save as…",
      .hint = "Save the scene to another file and continue there",
      .menu = Menu::file,
      .group = 1,
      .shortcut = {'S', true, true},
      .argument = CommandArgument::path,
      .with_path = "file.save"},
     [](Editor& e, const ui::Command& c) { ask_where_to_save(e, c.path); }},
    {{.name = "file.export",
      .label = "Export run…",
      .hint =
          "Export the recorded steps of this branch for Blender, Unity, Unreal or a browser, or as a video of the view",
      .menu = Menu::file,
      .group = 2,
      .shortcut = {'E', true},
      .disabled_reason = nothing_recorded,
      .argument = CommandArgument::path,
      .with_path = "file.write_export"},
     [](Editor& e, const ui::Command& c) { e.files().ask_where_to_save(ui::SavedKind::exported, c.path); }},
    {{.name = "file.render",
      .label = "Render…",
      .hint =
          "Draw the view in any size as a still, a turntable of it, or a batch: pictures of all scenes in this folder",
      .menu = Menu::file,
      .group = 2,
      .shortcut = {'R', true},
      .argument = CommandArgument::path,
      .with_path = "file.write_pictures"},
     [](Editor& e, const ui::Command&) { e.state().render.shown = true; }},
    {{.name = "file.record",
      .label = "Save recording…",
      .hint = "Save the recorded steps of this branch with all their inputs, for griffith replay to repeat and compare",
      .menu = Menu::file,
      .group = 2,
      .argument = CommandArgument::path,
      .with_path = "file.write_recording"},
     [](Editor& e, const ui::Command& c) { e.files().ask_where_to_save(ui::SavedKind::recording, c.path); }},
    {{.name = "file.plots",
      .label = "Save series…",
      .hint = "Save the plotted series as CSV, one row for each recorded step of this branch, or the plots as PNG",
      .menu = Menu::file,
      .group = 2,
      .disabled_reason = nothing_plotted,
      .argument = CommandArgument::path,
      .with_path = "file.write_plots"},
     [](Editor& e, const ui::Command& c) { e.files().ask_where_to_save(ui::SavedKind::plots, c.path); }},
    {{.name = "file.screenshot",
      .label = "Screenshot",
      .hint = "Save the window as a PNG file in the working folder",
      .menu = Menu::file,
      .group = 2,
      .shortcut = {key::kF12},
      .in_dialogs = true,
      .for_pictures = false},
     [](Editor& e, const ui::Command&) { e.requests().screenshot = true; }},
    {{.name = "edit.preferences",
      .label = "Preferences…",
      .hint = "Interface scale, mouse and autosave, kept between sessions",
      .menu = Menu::edit,
      .group = 2,
      .shortcut = {',', true}},
     [](Editor& e, const ui::Command&) { e.state().show_preferences = true; }},
    {{.name = "file.quit",
      .label = "Quit",
      .hint = "Quit the program",
      .menu = Menu::file,
      .group = 3,
      .shortcut = {'Q', true},
      .leaves = "Quitting",
      .in_dialogs = true,
      .recorded = false,
      .for_pictures = false},
     [](Editor& e, const ui::Command&) { quit(e); }},
    {{.name = "file.open_path",
      .label = "Open scene",
      .hint = "Open the scene with the given path",
      .argument = CommandArgument::path,
      .leaves = "Opening another scene",
      .for_pictures = false},
     [](Editor& e, const ui::Command& c) { e.builder().open(c.path); }},
    {{.name = "file.write_recording",
      .label = "Write recording",
      .hint = "Write the recording to a file",
      .argument = CommandArgument::path,
      .for_pictures = false},
     [](Editor& e, const ui::Command& c) { e.files().save_recording(c); }},
    {{.name = "file.write_export",
      .label = "Write export",
      .hint = "Write the exported run to a file",
      .disabled_reason = nothing_recorded,
      .argument = CommandArgument::path,
      .for_pictures = false},
     [](Editor& e, const ui::Command& c) { e.files().begin_export(c); }},
    {{.name = "file.write_pictures",
      .label = "Write pictures",
      .hint = "Draw the pictures of the dialog Render",
      .argument = CommandArgument::path,
      .for_pictures = false},
     [](Editor& e, const ui::Command& c) {
       e.state().render.shown = true;  // again after an error
       e.files().begin_render(c);
       e.state().render.shown = false;
     }},
    {{.name = "help.write_report",
      .label = "Write bug report",
      .hint = "Write the bug report to a file",
      .argument = CommandArgument::path,
      .for_pictures = false},
     [](Editor& e, const ui::Command& c) { e.files().save_report(c); }},
    {{.name = "file.write_plots",
      .label = "Write plots",
      .hint = "Write the plotted series to a file, or a picture of the plots if it ends in .png",
      .disabled_reason = nothing_plotted,
      .argument = CommandArgument::path,
      .for_pictures = false},
     [](Editor& e, const ui::Command& c) { e.files().save_plots(c); }},
    {{.name = "file.recover",
      .label = "Recover",
      .hint = "Recover unsaved edits",
      .disabled_reason = no_recoverable_edits,
      .for_pictures = false},
     [](Editor& e, const ui::Command&) { e.builder().recover(); }},
    {{.name = "file.discard_copy",
      .label = "Discard copy",
      .hint = "Delete the copy of unsaved edits",
      .disabled_reason = no_recoverable_edits,
      .for_pictures = false},
     [](Editor& e, const ui::Command&) { e.recovery().discard_offered(); }},
    {{.name = "file.leave_copy",
      .label = "Ask later",
      .hint = "Ask again at the next start",
      .disabled_reason = no_recoverable_edits,
      .for_pictures = false},
     [](Editor& e, const ui::Command&) { e.recovery().leave_offered(); }},
};

}  // namespace

std::span<const EditorCommand> file_commands() { return kFileCommands; }

}  // namespace griffith::app
