#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace griffith::fuzz {

/// Input of a target: the files of a folder. The entry to read is "input.<suffix>" (or the folder "input").
struct Input {
  std::string entry;                         ///< what is read
  std::map<std::string, std::string> files;  ///< path within the folder → content
};

std::string read_file(const std::filesystem::path& path);

/// Makes `folder` hold the input's files and nothing else.
void write_input(const Input& input, const std::filesystem::path& folder);

/// Reads a folder that write_input() made, or a file by itself (with the other half of a TetGen pair), or a CSV folder.
Input read_input(const std::filesystem::path& path);

/// The sum of the sizes of all files.
std::size_t size_of(const Input& input);

}  // namespace griffith::fuzz
