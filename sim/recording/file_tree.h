#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace griffith {

/// Contents of files by their paths, which are relative and lead nowhere above: "assets/1/wall.msh".
using FileTree = std::map<std::string, std::string>;

/// Limit of all contents together [bytes].
inline constexpr std::int64_t kMaxTreeBytes = std::int64_t{1} << 30;

/// A tar archive, compressed by Zstandard, of the files. The same files give the same bytes. Throws InputError, which
/// names the archive as `where`, when they are larger than allowed.
std::string pack_files(const FileTree& files, const std::string& where);

/// The files of such an archive. Folders in it are passed over. Throws InputError where it is damaged, too large or of
/// another kind, and for links, devices, files that are there twice and paths that lead elsewhere.
FileTree unpack_files(const std::string& archive, const std::string& where);

/// Writes the files below a folder, which is made where it is missing. Throws InputError when one cannot be written.
void write_files(const FileTree& files, const std::filesystem::path& folder);

}  // namespace griffith
