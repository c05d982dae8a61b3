#pragma once

#include <filesystem>
#include <string_view>

namespace griffith {

/// Writes `content` beside `path`, then renames it to `path`: an interrupted write leaves the old file as it was. Links
/// are followed; devices and pipes are written to directly. Throws InputError when the file cannot be written.
void replace_file(const std::filesystem::path& path, std::string_view content);

}  // namespace griffith
