#pragma once

#include <filesystem>
#include <vector>

namespace griffith::app {

/// Returns the scene files to offer: those next to `current` if it is a file, then those of a folder named scenes in
/// the working folder or above the program. Both are sorted, without duplicates.
std::vector<std::filesystem::path> scene_files(const std::filesystem::path& current);

/// Returns the scene files in a folder, sorted.
std::vector<std::filesystem::path> scenes_in(const std::filesystem::path& folder);

/// Returns "griffith_0001.png" in the working folder, with the first free number.
std::filesystem::path free_screenshot_path();

/// Returns the content of a folder, sorted; empty if it cannot be read.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder);

/// True if the name exists, even as a broken link.
bool is_taken(const std::filesystem::path& path);

/// Returns the modification time of the file; the earliest time if there is none.
std::filesystem::file_time_type time_of_file(const std::filesystem::path& path);

}  // namespace griffith::app
