#pragma once

#include <filesystem>
#include <vector>

namespace griffith::app {

/// The scene files to offer: those beside `current` if it is a file, then those of a folder named scenes in the working
/// folder or above the program. Both are sorted; none comes twice.
std::vector<std::filesystem::path> scene_files(const std::filesystem::path& current);

/// Those in a folder, sorted.
std::vector<std::filesystem::path> scenes_in(const std::filesystem::path& folder);

/// "griffith_0001.png" in the working folder, with the first number that is free.
std::filesystem::path free_screenshot_path();

/// What is in a folder, sorted; nothing where it cannot be read.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder);

/// Whether something has this name, be it a link to nothing.
bool is_taken(const std::filesystem::path& path);

/// When the file was written last; the earliest time where there is none.
std::filesystem::file_time_type time_of_file(const std::filesystem::path& path);

}  // namespace griffith::app
