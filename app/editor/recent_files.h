#pragma once

#include <filesystem>
#include <vector>

namespace griffith::app {

/// The scenes that a user opened or saved last, newest first, kept in a file from one start to the next.
class RecentFiles {
 public:
  static constexpr std::size_t kMost = 10;

  /// `folder`: the user's folder for states; empty: nothing is kept. What is no longer there is passed by.
  explicit RecentFiles(const std::filesystem::path& folder);

  const std::vector<std::filesystem::path>& files() const { return files_; }
  /// Puts a scene on top. `file`: absolute. Throws InputError where the list cannot be written.
  void add(const std::filesystem::path& file);

 private:
  std::filesystem::path list_;
  std::vector<std::filesystem::path> files_;
};

}  // namespace griffith::app
