#include "ui/model/scene_names.h"

#include <algorithm>

namespace griffith::ui {

std::vector<std::string> scene_names(std::span<const std::filesystem::path> files) {
  std::vector<std::string> names;
  for (const std::filesystem::path& file : files) {
    const auto same = [&](const std::filesystem::path& other) { return other.stem() == file.stem(); };
    const bool alone = std::ranges::count_if(files, same) == 1;
    names.push_back(file.stem().string() + (alone ? "" : " (" + file.parent_path().string() + ")"));
  }
  return names;
}

}  // namespace griffith::ui
