#include "app/editor/scripting.h"

#include <algorithm>

#include "app/editor/messages.h"
#include "app/editor/preferences_file.h"
#include "app/shared/scene_files.h"
#include "sim/core/replace_file.h"
#include "sim/scene/scene_difference.h"
#include "ui/model/entry_choice.h"

namespace griffith::app {

namespace fs = std::filesystem;

fs::path macro_folder() {
  const fs::path preferences = preferences_path();
  return preferences.empty() ? preferences : preferences.parent_path() / "macros";
}

void Scripting::use_macros(fs::path folder) {
  folder_ = std::move(folder);
  list();
}

void Scripting::list() {
  macros_ = files_in(folder_);
  std::erase_if(macros_, [](const fs::path& file) { return file.extension() != ".script"; });
}

MacroMoment Scripting::moment() const {
  const Scene& scene = document_.scene();
  MacroMoment moment{scene, state_.shot, {}, run_.frame().step, viewport_.camera()};
  moment.scene.view = state_.view;
  for (const ui::SceneEntry& entry : ui::selected_entries(state_, scene))
    moment.chosen.push_back(ui::full_name(scene, entry));
  return moment;
}

void Scripting::note() {
  if (recorder_ && !document_.history().editing()) recorder_->note(moment());
}

void Scripting::skip() {
  if (recorder_) recorder_->skip(moment());
}

void Scripting::add(const ui::Command& command) {
  if (recorder_) recorder_->add(command, moment());
}

void Scripting::toggle_recording() {
  state_.recording_macro = !state_.recording_macro;
  if (state_.recording_macro) {
    recorder_.emplace(moment());
    return log_message(state_, ui::LogLevel::info, "Recording a macro until you stop it.", ui::LogSpan::action);
  }
  recorded_ = recorder_->text(moment());
  std::error_code error;  // if the folder cannot be made, saving reports it
  fs::create_directories(folder_, error);
  recorder_.reset();
  ask_where_to_save({});
}

bool Scripting::has_macro() {
  if (recorded_.empty())
    log_message(state_, ui::LogLevel::warning, "No action is recorded: choose Record macro, then act.");
  return !recorded_.empty();
}

void Scripting::ask_where_to_save(fs::path proposed) {
  if (!has_macro()) return;
  for (int number = 1; proposed.empty(); ++number) {
    const fs::path file = folder_ / ("macro " + std::to_string(number) + ".script");
    if (std::ranges::find(macros_, file) == macros_.end()) proposed = file;
  }
  state_.save_as = ui::save_target(proposed, ui::SavedKind::macro);
  for (const fs::path& macro : macros_) state_.save_as->existing.push_back(macro.filename().string());
}

void Scripting::save(const ui::Command& command) {
  if (!has_macro() || !may_replace(state_, command, command.path)) return;
  replace_file(command.path, recorded_);
  list();
  log_message(state_, ui::LogLevel::info, "Saved the macro " + command.path.string());
}

void set_values(ui::EditHistory& history, ui::EditorState& state, std::span<const SceneSetting> settings,
                const std::string& where) {
  Scene shown = history.scene();
  shown.view = state.view;
  Scene changed = with_settings(shown, settings, where);
  state.view = std::exchange(changed.view, history.scene().view);
  if (changed == history.scene()) return;
  history.change("Set " + settings.front().pointer, [&](Scene& scene) { scene = changed; });
  history.finish();
}

void set_shot(ui::EditorState& state, std::span<const SceneSetting> settings, const std::string& where) {
  state.shot = with_settings(scene_of_shot(state.shot), settings, where).projectiles.front();
}

void choose(ui::EditorState& state, const Scene& scene, const std::vector<std::string>& names,
            const std::string& where) {
  std::vector<ui::SceneEntry> chosen;
  const std::vector<ui::SceneEntry> entries = ui::scene_entries(scene);
  for (const std::string& name : names) {
    const auto found =
        std::ranges::find_if(entries, [&](const ui::SceneEntry& entry) { return ui::full_name(scene, entry) == name; });
    if (found == entries.end())
      throw InputError(where, "the scene has no \"" + name + "\"", "use a name in the outliner");
    chosen.push_back(*found);
  }
  ui::select_entries(state, scene, std::move(chosen));
}

}  // namespace griffith::app
