#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "app/editor/thumbnail_maker.h"
#include "renderer/image_texture.h"
#include "ui/model/scene_browser.h"

namespace griffith::app {

/// Returns the card of a scene file without a thumbnail. Topics follow from its content.
ui::SceneCard scene_card(const std::filesystem::path& file);

/// Scenes in the browser, with thumbnails as they arrive. Needs a current OpenGL context from construction to
/// destruction.
class SceneGallery {
 public:
  SceneGallery(const std::vector<std::filesystem::path>& files, const ThumbnailSource& source);

  /// Takes over newly arrived thumbnails; call it before each frame.
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
