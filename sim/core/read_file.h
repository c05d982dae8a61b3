#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace griffith {

/// Largest file that is read unless another limit is given [bytes].
inline constexpr std::int64_t kMaxFileBytes = (std::int64_t{2} << 30) - 1;

/// Returns the content of a regular file. Throws InputError if the file does not exist, is larger than `max_bytes` or
/// cannot be read. Throws too for pipes, devices and folders, which could block forever.
std::string read_file(const std::filesystem::path& path, std::int64_t max_bytes = kMaxFileBytes);

/// Throws InputError, as read_file() does, if there is no such regular file.
void require_regular_file(const std::filesystem::path& path);

}  // namespace griffith
