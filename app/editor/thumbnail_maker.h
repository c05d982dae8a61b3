#pragma once

#include <cstddef>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "renderer/image.h"

namespace griffith::app {

/// How thumbnails come about.
struct ThumbnailSource {
  std::filesystem::path program;  ///< Griffith's, whose command `thumbnail` draws them; empty: none are drawn
  std::filesystem::path folder;   ///< where they are kept; may be deleted at any time; empty: they are not kept
};

/// The user's folder for thumbnails, in the cache of the meshes; empty where there is none.
std::filesystem::path thumbnail_cache();

/// The file in `folder` for the thumbnail of a scene, named by a hash of the scene's file and the program's version.
/// Throws InputError where the scene cannot be read.
std::filesystem::path thumbnail_entry(const std::filesystem::path& folder, const std::filesystem::path& scene);

/// Finds the thumbnails of scenes on a thread of its own: first those that come with them or are kept, then it has
/// missing ones drawn, one after another, by processes that end with it.
class ThumbnailMaker {
 public:
  struct Made {
    std::size_t scene;  ///< which of them
    render::Image picture;
  };

  ThumbnailMaker(std::vector<std::filesystem::path> scenes, ThumbnailSource source);
  /// Gives up what is missing, within a fraction of a second.
  ~ThumbnailMaker();
  ThumbnailMaker(const ThumbnailMaker&) = delete;
  ThumbnailMaker& operator=(const ThumbnailMaker&) = delete;

  /// A thumbnail that has come since; nothing where there is none now.
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
