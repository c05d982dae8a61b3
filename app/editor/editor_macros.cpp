#include <algorithm>

#include "app/editor/editor.h"
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

void Editor::use_macros(fs::path folder) {
  macro_folder_ = std::move(folder);
  list_macros();
}

void Editor::list_macros() {
  macros_ = files_in(macro_folder_);
  std::erase_if(macros_, [](const fs::path& file) { return file.extension() != ".script"; });
}

MacroMoment Editor::macro_moment() const {
  MacroMoment moment{history_.scene(), state_.shot, {}, frame().step, camera_};
  moment.scene.view = state_.view;
  for (const ui::SceneEntry& entry : ui::selected_entries(state_, history_.scene()))
    moment.chosen.push_back(ui::full_name(history_.scene(), entry));
  return moment;
}

void Editor::note_for_macro() {
  if (recorder_ && !history_.editing()) recorder_->note(macro_moment());
}

void Editor::toggle_macro_recording() {
  state_.recording_macro = !state_.recording_macro;
  if (state_.recording_macro) {
    recorder_.emplace(macro_moment());
    return log(ui::LogLevel::info, "Recording a macro until you stop it.", ui::LogSpan::action);
  }
  recorded_macro_ = recorder_->text(macro_moment());
  std::error_code error;  // if the folder cannot be made, saving reports it
  fs::create_directories(macro_folder_, error);
  recorder_.reset();
  ask_where_to_save_macro({});
}

void Editor::ask_where_to_save_macro(fs::path proposed) {
  for (int number = 1; proposed.empty(); ++number) {
    const fs::path file = macro_folder_ / ("macro " + std::to_string(number) + ".script");
    if (std::ranges::find(macros_, file) == macros_.end()) proposed = file;
  }
  state_.save_as = ui::save_target(proposed, ui::SavedKind::macro);
  for (const fs::path& macro : macros_) state_.save_as->existing.push_back(macro.filename().string());
}

void Editor::write_macro(const fs::path& path) {
  replace_file(path, recorded_macro_);
  list_macros();
  log(ui::LogLevel::info, "Saved the macro " + path.string());
}

std::optional<Script> Editor::take_script_request() { return std::exchange(requested_script_, std::nullopt); }

void Editor::set_values(std::span<const SceneSetting> settings, const std::string& where) {
  Scene shown = history_.scene();
  shown.view = state_.view;
  Scene changed = with_settings(shown, settings, where);
  state_.view = std::exchange(changed.view, history_.scene().view);
  if (changed == history_.scene()) return;
  history_.change("Set " + settings.front().pointer, [&](Scene& scene) { scene = changed; });
  history_.finish();
}

void Editor::set_shot(std::span<const SceneSetting> settings, const std::string& where) {
  state_.shot = with_settings(scene_of_shot(state_.shot), settings, where).projectiles.front();
}

void Editor::choose(const std::vector<std::string>& names, const std::string& where) {
  std::vector<ui::SceneEntry> chosen;
  const std::vector<ui::SceneEntry> entries = ui::scene_entries(history_.scene());
  for (const std::string& name : names) {
    const auto found = std::ranges::find_if(
        entries, [&](const ui::SceneEntry& entry) { return ui::full_name(history_.scene(), entry) == name; });
    if (found == entries.end())
      throw InputError(where, "the scene has no \"" + name + "\"", "use a name in the outliner");
    chosen.push_back(*found);
  }
  ui::select_entries(state_, history_.scene(), std::move(chosen));
}

void Editor::look_from(const Vec3& eye, const Vec3& target) {
  camera_.position = eye.cast<float>();
  camera_.target = target.cast<float>();
}

}  // namespace griffith::app
