#include "app/editor/scene_document.h"

#include <utility>

#include "app/shared/scene_files.h"
#include "sim/core/replace_file.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"

namespace griffith::app {

namespace fs = std::filesystem;

SceneDocument::SceneDocument(Scene scene, fs::path path, const Scene* edited) : history_(Scene{}) {
  const FileTime file_time = time_of_file(path);
  show(std::move(scene), std::move(path), edited, file_time);
}

void SceneDocument::show(Scene scene, fs::path path, const Scene* edited, FileTime file_time) {
  history_ = ui::EditHistory(std::move(scene));
  if (edited) {
    history_.change("Unsaved edits", [&](Scene& changed) { changed = *edited; });
    history_.finish();
  }
  path_ = std::move(path);
  file_time_ = file_time;
  outdated_ = path_.empty() ? std::vector<InputError>() : outdated_names(path_);
}

fs::path SceneDocument::absolute_path() const { return path_.empty() ? path_ : fs::absolute(path_).lexically_normal(); }

std::string SceneDocument::title() const {
  return scene().name + (history_.modified() ? " * - Griffith" : " - Griffith");
}

std::string SceneDocument::saving_problem(const fs::path& file) const {
  if (!is_taken(file)) return {};
  std::error_code error;
  if (path_.empty() || !fs::equivalent(file, path_, error)) return file.string() + " already exists.";
  if (time_of_file(file) == file_time_) return {};
  if (file_time_ == FileTime::min()) return file.string() + " may be newer than the edits that were recovered.";
  return file.string() + " was changed by another program since it was opened.";
}

void SceneDocument::save(const fs::path& file, const ViewSettings& view) {
  const auto complete = [&](Scene& scene) {
    scene.view = view;
    if (scene.name == Scene().name) scene.name = file.stem().string();
  };
  Scene saved = scene();
  complete(saved);
  write_scene(saved, file);
  history_.change("Set view", complete);
  history_.finish();
  history_.mark_saved();
  path_ = file;
  file_time_ = time_of_file(path_);
  outdated_.clear();
}

}  // namespace griffith::app
