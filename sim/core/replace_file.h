#pragma once

#include <filesystem>
#include <string_view>

namespace griffith {

/// Writes `content` to a new file beside `path`, with a unique name, and renames it to `path`. An interrupted or failed
/// write leaves the old file unchanged, and concurrent writers do not interfere. The mode of the old file is kept; a
/// file without write permission is not replaced. A link stays a link, and its target is replaced or created. Devices
/// and pipes are written directly. Throws InputError if any part fails, closing included.
void replace_file(const std::filesystem::path& path, std::string_view content);

/// Removes files that interrupted programs left in a folder during replace_file(): those of this user with such a name
/// that no program has locked and that are older than a minute.
void remove_stale_files(const std::filesystem::path& folder);

/// Throws the InputError of a later replace_file() as far as it can be predicted. Call it before long work whose result
/// goes there. Removes stale files in the folder.
void check_replaceable(const std::filesystem::path& path);

}  // namespace griffith
