#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace griffith {

/// Contents of files by their paths, which are relative and never lead upward: "assets/1/wall.msh".
using FileTree = std::map<std::string, std::string>;

/// Limit of the total size of contents [bytes].
inline constexpr std::int64_t kMaxTreeBytes = std::int64_t{1} << 30;

/// Returns the files as a tar archive compressed by Zstandard. The same files give the same bytes. Throws InputError,
/// which names the archive as `where`, if they are larger than allowed.
std::string pack_files(const FileTree& files, const std::string& where);

/// Returns the files of such an archive, ignoring folders. Throws InputError if it is damaged, too large or of another
/// kind. Throws too for links, devices, duplicate files and paths that lead outside.
FileTree unpack_files(const std::string& archive, const std::string& where);

/// Writes the files below a folder, which is created if missing. Throws InputError if a file cannot be written.
void write_files(const FileTree& files, const std::filesystem::path& folder);

}  // namespace griffith
