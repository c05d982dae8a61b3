#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace griffith {

/// All that is in a file.
inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace griffith
