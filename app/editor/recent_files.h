#pragma once

#include <filesystem>
#include <vector>

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

}  // namespace griffith::app
