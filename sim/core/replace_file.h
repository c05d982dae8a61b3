#pragma once

#include <filesystem>
#include <string_view>

namespace griffith {

/// Writes `content` into a new file of a name of its own beside `path`, then renames it to `path`: an interrupted or
/// failed write leaves the old file as it was, and several writers at once do not meet. The mode of the old file is
/// kept; one that may not be written to is not replaced. A link stays a link, and the file it leads to is replaced or
/// made; devices and pipes are written to directly. Throws InputError when anything fails, to the end of closing the
/// file.
void replace_file(const std::filesystem::path& path, std::string_view content);

/// Removes what replace_file() left in a folder where the program was killed: files of this user with the names that it
/// gives, which nobody holds and that are older than a minute.
void remove_stale_files(const std::filesystem::path& folder);

/// Throws the InputError that replace_file() would throw, as far as that can be told before: to be called before long
/// work whose result goes there. Removes stale files there.
void check_replaceable(const std::filesystem::path& path);

}  // namespace griffith
