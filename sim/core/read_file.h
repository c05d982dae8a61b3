#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace griffith {

/// Most bytes that are read of a file unless another limit is given.
inline constexpr std::int64_t kMaxFileBytes = (std::int64_t{2} << 30) - 1;

/// The content of a regular file. Throws InputError where there is none, where it is a pipe, a device or a folder (to
/// open one of those could wait for ever), where it is larger than `max_bytes` and where it cannot be read.
std::string read_file(const std::filesystem::path& path, std::int64_t max_bytes = kMaxFileBytes);

/// Throws InputError as read_file() does for what is not there or no regular file.
void require_regular_file(const std::filesystem::path& path);

}  // namespace griffith
