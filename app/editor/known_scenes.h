#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "app/editor/scene_gallery.h"
#include "ui/model/editor_state.h"

namespace griffith::app {

/// Recently opened or saved scenes, newest first, kept in a file.
class RecentFiles {
 public:
  static constexpr std::size_t kMost = 10;

  /// `folder`: the user's state folder; empty to keep nothing. Missing files are skipped.
  explicit RecentFiles(const std::filesystem::path& folder);

  const std::vector<std::filesystem::path>& files() const { return files_; }
  /// Puts a scene on top. `file`: absolute. Throws InputError if the list cannot be written.
  void add(const std::filesystem::path& file);

 private:
  std::filesystem::path list_;
  std::vector<std::filesystem::path> files_;
};

/// Scenes that can be opened: the samples, those next to the current one and the recent ones; and their cards while
/// the browser is shown.
class KnownScenes {
 public:
  explicit KnownScenes(ui::EditorState& state) : state_(state) {}

  /// Lists the samples and the scenes in the folder of `path`.
  void list(const std::filesystem::path& path);
  /// Keeps the recent scenes in a file. `states`: the user's state folder; empty to keep nothing.
  void keep_recent(const std::filesystem::path& states) { recent_ = RecentFiles(states); }
  /// Puts a scene on top of the recent ones. `file`: absolute; nothing happens if it is empty.
  void remember(const std::filesystem::path& file);
  /// Sets the source of thumbnails.
  void show_thumbnails(ThumbnailSource source) { thumbnail_source_ = std::move(source); }
  /// Makes the cards while the browser is shown; call it in every drawn frame.
  void follow_browser();

  const std::vector<std::filesystem::path>& files() const { return files_; }
  const std::vector<std::filesystem::path>& recent() const { return recent_.files(); }
  std::span<const ui::SceneCard> cards() const;
  /// True if thumbnails are still being made.
  bool awaits_thumbnails() const { return gallery_ && !gallery_->done(); }

 private:
  ui::EditorState& state_;
  std::vector<std::filesystem::path> files_;
  RecentFiles recent_{""};
  ThumbnailSource thumbnail_source_;
  std::unique_ptr<SceneGallery> gallery_;  ///< while the browser is shown
};

}  // namespace griffith::app
