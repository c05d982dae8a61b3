#include "app/shared/scene_files.h"

#include <algorithm>
#include <cstdio>

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

constexpr int kFoldersAbove = 5;

bool looks_like_scene(const fs::path& path) {
  return path.extension() == ".json" && path.stem().extension() != ".schema";
}

/// Returns the scenes shipped with the program.
std::vector<fs::path> samples() {
  std::vector<fs::path> files = scenes_in("scenes");
  std::error_code error;
  fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (int i = 0; i < kFoldersAbove && files.empty(); ++i, folder = folder.parent_path())
    files = scenes_in(folder / "scenes");
  return files;
}

}  // namespace

std::vector<fs::path> scenes_in(const fs::path& folder) {
  std::vector<fs::path> files = files_in(folder);
  std::erase_if(files, [](const fs::path& file) { return !looks_like_scene(file); });
  return files;
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    files.push_back(entry->path());
  std::ranges::sort(files);
  return files;
}

bool is_taken(const fs::path& path) {
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

std::vector<fs::path> scene_files(const fs::path& current) {
  std::error_code error;
  const std::vector<fs::path> offered = samples();
  if (!fs::is_regular_file(current, error)) return offered;
  const fs::path folder = current.parent_path().empty() ? "." : current.parent_path();
  std::vector<fs::path> files = scenes_in(folder);
  if (!offered.empty() && !fs::equivalent(folder, offered.front().parent_path(), error))
    files.insert(files.end(), offered.begin(), offered.end());
  return files;
}

fs::path free_screenshot_path() {
  for (int number = 1;; ++number) {
    char name[32];
    std::snprintf(name, sizeof name, "griffith_%04d.png", number);
    std::error_code error;
    if (!fs::exists(name, error)) return name;
  }
}

std::filesystem::file_time_type time_of_file(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::last_write_time(path, error);
}

}  // namespace griffith::app
