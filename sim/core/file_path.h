#pragma once

#include <filesystem>

namespace griffith {

/// Where a file is that a scene names: paths that are not absolute start at the scene's folder.
inline std::filesystem::path file_path(const std::filesystem::path& folder, const std::filesystem::path& path) {
  return (folder / path).lexically_normal();
}

}  // namespace griffith
