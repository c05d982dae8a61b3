#pragma once

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace griffith {

/// Returns the path of a file that a scene names. Relative paths start at the scene's folder.
inline std::filesystem::path file_path(const std::filesystem::path& folder, const std::filesystem::path& path) {
  return (folder / path).lexically_normal();
}

/// True if `file` exists in `folder` or below it after all links are resolved.
inline bool is_within(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::path real_folder = std::filesystem::canonical(folder.empty() ? "." : folder, error);
  if (error) return false;
  const std::filesystem::path real_file = std::filesystem::canonical(file, error);
  return !error && std::ranges::mismatch(real_folder, real_file).in1 == real_folder.end() && real_file != real_folder;
}

}  // namespace griffith
