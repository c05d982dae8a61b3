#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "app/editor/thumbnail_maker.h"
#include "renderer/image_texture.h"
#include "ui/model/scene_browser.h"

namespace griffith::app {

/// What a scene file tells of itself, without a thumbnail. Topics follow from what the scene holds.
ui::SceneCard scene_card(const std::filesystem::path& file);

/// The scenes that the browser shows, with thumbnails as they come. Needs a current OpenGL context from construction to
/// destruction.
class SceneGallery {
 public:
  SceneGallery(const std::vector<std::filesystem::path>& files, const ThumbnailSource& source);

  /// To be called before each frame: takes over the thumbnails that have come.
  void follow();
  /// True once all thumbnails have arrived.
  bool done() const { return maker_.done(); }
  std::span<const ui::SceneCard> cards() const { return cards_; }

 private:
  std::vector<ui::SceneCard> cards_;
  std::vector<render::ImageTexture> thumbnails_;
  ThumbnailMaker maker_;
};

}  // namespace griffith::app
