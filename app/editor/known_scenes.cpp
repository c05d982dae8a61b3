#include "app/editor/known_scenes.h"

#include <fstream>
#include <string>

#include "app/editor/messages.h"
#include "app/shared/scene_files.h"
#include "sim/core/replace_file.h"

namespace griffith::app {

namespace fs = std::filesystem;

RecentFiles::RecentFiles(const fs::path& folder) : list_(folder.empty() ? fs::path() : folder / "recent") {
  std::ifstream list(list_);
  std::error_code error;
  for (std::string line; files_.size() < kMost && std::getline(list, line);)
    if (fs::is_regular_file(line, error)) files_.emplace_back(line);
}

void RecentFiles::add(const fs::path& file) {
  if (!files_.empty() && files_.front() == file) return;
  std::erase(files_, file);
  files_.insert(files_.begin(), file);
  if (files_.size() > kMost) files_.pop_back();
  if (list_.empty()) return;
  std::string text;
  for (const fs::path& recent : files_) text += recent.string() + "\n";
  std::error_code error;  // if the folder cannot be made, writing reports it
  fs::create_directories(list_.parent_path(), error);
  replace_file(list_, text);
}

void KnownScenes::list(const std::filesystem::path& path) { files_ = scene_files(path); }

void KnownScenes::remember(const std::filesystem::path& file) {
  try {
    if (!file.empty()) recent_.add(file);
  } catch (const InputError& error) {
    log_message(state_, ui::LogLevel::warning, error.what());
  }
}

void KnownScenes::follow_browser() {
  if (!state_.browser.shown) return gallery_.reset();
  if (!gallery_) gallery_ = std::make_unique<SceneGallery>(files_, thumbnail_source_);
  gallery_->follow();
}

std::span<const ui::SceneCard> KnownScenes::cards() const {
  return gallery_ ? gallery_->cards() : std::span<const ui::SceneCard>();
}

}  // namespace griffith::app
