#pragma once

#include <cstddef>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "renderer/image.h"

namespace griffith::app {

/// Source of thumbnails.
struct ThumbnailSource {
  std::filesystem::path program;  ///< program whose command `thumbnail` draws them; empty: none are drawn
  std::filesystem::path folder;   ///< cache, which may be deleted at any time; empty: none
};

/// Returns the user's folder for thumbnails, in the cache of the meshes; empty if there is none.
std::filesystem::path thumbnail_cache();

/// Returns the file in `folder` for the thumbnail of a scene, named by a hash of the scene's file and the program's
/// version. Throws InputError if the scene cannot be read.
std::filesystem::path thumbnail_entry(const std::filesystem::path& folder, const std::filesystem::path& scene);

/// Finds the thumbnails of scenes on a thread of its own. Shipped and cached ones come first; missing ones are then
/// drawn one by one, in processes that end with this object.
class ThumbnailMaker {
 public:
  struct Made {
    std::size_t scene;  ///< index of the scene
    render::Image picture;
  };

  ThumbnailMaker(std::vector<std::filesystem::path> scenes, ThumbnailSource source);
  /// Stops drawing, within a fraction of a second.
  ~ThumbnailMaker();
  ThumbnailMaker(const ThumbnailMaker&) = delete;
  ThumbnailMaker& operator=(const ThumbnailMaker&) = delete;

  /// Returns a thumbnail that has arrived since the last call; empty if there is none.
  std::optional<Made> take();
  /// True once all thumbnails have arrived.
  bool done() const;

 private:
  struct Shared;
  static void make_all(const std::vector<std::filesystem::path>& scenes, const ThumbnailSource& source, Shared& shared);

  std::shared_ptr<Shared> shared_;
  std::future<void> work_;
};

}  // namespace griffith::app
