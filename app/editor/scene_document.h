#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/core/error.h"
#include "ui/model/edit_history.h"

namespace griffith::app {

/// The edited scene with its undo history and its file.
class SceneDocument {
 public:
  using FileTime = std::filesystem::file_time_type;

  /// As show(), with the file's current time.
  SceneDocument(Scene scene, std::filesystem::path path, const Scene* edited);

  /// Replaces the scene. `edited`: unsaved version of it, if there is one. `file_time`: time of the file before it was
  /// read; the earliest time if it may be newer than the edits.
  void show(Scene scene, std::filesystem::path path, const Scene* edited, FileTime file_time);

  const Scene& scene() const { return history_.scene(); }
  ui::EditHistory& history() { return history_; }
  const ui::EditHistory& history() const { return history_; }
  /// Returns the scene's file; empty if there is none.
  const std::filesystem::path& path() const { return path_; }
  /// Returns its absolute path; empty if there is none.
  std::filesystem::path absolute_path() const;
  /// Returns the outdated names in the file.
  const std::vector<InputError>& outdated() const { return outdated_; }
  /// Returns the title of the window; a star marks unsaved edits.
  std::string title() const;

  /// Describes the loss that saving to the file would cause; empty if it is safe.
  std::string saving_problem(const std::filesystem::path& file) const;
  /// Writes the scene with this view to the file, which becomes its own. Throws InputError.
  void save(const std::filesystem::path& file, const ViewSettings& view);

 private:
  ui::EditHistory history_;
  std::filesystem::path path_;
  FileTime file_time_;  ///< time of the file before it was read, or when it was last written
  std::vector<InputError> outdated_;
};

}  // namespace griffith::app
