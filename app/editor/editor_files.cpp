#include <algorithm>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/starting_scene.h"
#include "app/shared/scene_files.h"
#include "sim/core/replace_file.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"

namespace griffith::app {

namespace fs = std::filesystem;

namespace {

fs::path file_named(std::string name) {
  std::ranges::replace(name, '/', '-');
  return name.empty() ? "scene.json" : name + ".json";
}

}  // namespace

void Editor::open(const fs::path& path) {
  try {
    opened_time_ = time_of_file(path);
    loader_.start(LoadReason::open, read_scene(path), path, max_tets());
    loader_.wait(kBusyIndicatorDelay);
    receive_world();
  } catch (const InputError& error) {
    show_error(error);
  }
}

fs::path Editor::own_file() const { return path_.empty() ? path_ : fs::absolute(path_).lexically_normal(); }

void Editor::ask_where_to_save(fs::path proposed) {
  if (proposed.empty()) proposed = path_.empty() ? file_named(history_.scene().name) : path_;
  state_.save_as = ui::save_target(proposed);
  for (const fs::path& file : scenes_in(state_.save_as->folder))
    state_.save_as->existing.push_back(file.filename().string());
}

std::string Editor::what_saving_would_lose(const fs::path& file) const {
  if (!is_taken(file)) return {};
  std::error_code error;
  if (path_.empty() || !fs::equivalent(file, path_, error)) return file.string() + " already exists.";
  if (time_of_file(file) == file_time_) return {};
  if (file_time_ == fs::file_time_type::min())
    return file.string() + " may be newer than the edits that were recovered.";
  return file.string() + " was changed by another program since it was opened.";
}

void Editor::save(const ui::Command& command) {
  const fs::path file = command.path.empty() ? path_ : command.path;
  if (file.empty()) return ask_where_to_save();
  if (std::string problem = what_saving_would_lose(file); !command.replace && !problem.empty()) {
    state_.replacement = ui::Replacement{command, std::move(problem)};
    return;
  }
  const std::optional<ui::Command> next = std::exchange(state_.after_save, std::nullopt);
  history_.change("Set view", [this](Scene& scene) { scene.view = state_.view; });
  history_.finish();
  write_scene(history_.scene(), file);
  history_.mark_saved();
  path_ = file;
  file_time_ = time_of_file(path_);
  scene_files_ = scene_files(path_);
  outdated_.clear();
  list_problems();
  if (autosave_) autosave_->remove();
  remember_file();
  log(ui::LogLevel::info, "Saved " + path_.string());
  if (next) execute(*next);
}

void Editor::quit() {
  if (autosave_) autosave_->remove();
  wants_to_quit_ = true;
}

void Editor::enable_autosave(const fs::path& states) {
  remove_stale_files(states);
  recent_ = RecentFiles(states);
  remember_file();
  autosave_.emplace(states);
  offer_recovery(true);
}

void Editor::autosave(double now) {
  if (!autosave_) return;
  if (!history_.modified()) return autosave_->remove();
  const bool due = now - copied_at_ >= state_.preferences.autosave_interval && history_.revision() != copied_revision_;
  if (!due || history_.editing()) return;
  copied_at_ = now;
  try {
    Scene scene = history_.scene();
    scene.view = state_.view;
    autosave_->write(scene, own_file());
    copied_revision_ = history_.revision();
  } catch (const InputError& error) {
    log(ui::LogLevel::warning, error.what());
  }
}

void Editor::offer_recovery(bool of_any) {
  if (!autosave_) return;
  const bool found = of_any ? autosave_->find_any(own_file()) : autosave_->find(own_file());
  state_.recoverable_edits = found ? autosave_->found_text() : "";
}

void Editor::remember_file() {
  try {
    if (!path_.empty()) recent_.add(own_file());
  } catch (const InputError& error) {
    log(ui::LogLevel::warning, error.what());
  }
}

void Editor::follow_browser() {
  if (!state_.browser.shown) return gallery_.reset();
  if (!gallery_) gallery_ = std::make_unique<SceneGallery>(scene_files_, thumbnail_source_);
  gallery_->follow();
}

void Editor::discard_copy() {
  if (autosave_) autosave_->remove_found();
  offer_recovery(true);
}

void Editor::leave_copy() {
  state_.recoverable_edits.clear();
  if (autosave_) autosave_->leave_found();
}

void Editor::recover() {
  state_.recoverable_edits.clear();
  if (!autosave_ || !autosave_->has_found()) return;
  UnsavedEdits edits = autosave_->found_edits();
  loader_.start(LoadReason::recover, std::move(edits.scene), std::move(edits.file), max_tets());
  loader_.wait(kBusyIndicatorDelay);
  receive_world();
}

void Editor::show_recovered(Scene scene, const fs::path& file) {
  Scene saved = starting_scene();
  try {
    if (!file.empty()) saved = read_scene(file);
  } catch (const InputError& error) {
    log(ui::LogLevel::warning, error.what());
  }
  autosave_->adopt_found();
  file_time_ = fs::file_time_type::min();
  show_scene(std::move(saved), file, &scene);
  log(ui::LogLevel::info, "Recovered unsaved edits. Ctrl+S saves them.");
}

}  // namespace griffith::app
