#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "sim/core/read_file.h"

namespace griffith {

/// Throws InputError where the first bytes of a file show that it holds something else than its ending says: a Git LFS
/// pointer, a web page, a compressed file, or another format of meshes, surfaces or pictures. The error names what it
/// is and the remedy. `content`: the file's beginning, 512 bytes or more where it has them.
void require_expected_content(const std::filesystem::path& path, std::string_view content);

/// As above for a file whose beginning has not been read. Passes where it cannot be read: its reader tells that.
void require_expected_content(const std::filesystem::path& path);

/// read_file() for a file that has to hold what its ending says.
std::string read_expected_file(const std::filesystem::path& path, std::int64_t max_bytes = kMaxFileBytes);

}  // namespace griffith
