#include "app/editor/known_scenes.h"

#include "app/editor/messages.h"
#include "app/shared/scene_files.h"

namespace griffith::app {

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
