#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "sim/core/read_file.h"

namespace griffith {

/// Throws InputError if the first bytes of a file contradict its suffix: a Git LFS pointer, a web page, a compressed
/// file, or another format of meshes, surfaces or pictures. The error names the actual content and the remedy.
/// `content`: the first 512 bytes of the file or more, or all of a shorter one.
void require_expected_content(const std::filesystem::path& path, std::string_view content);

/// As above for a file that has not been read yet. Ignores unreadable files, since their reader reports them.
void require_expected_content(const std::filesystem::path& path);

/// Returns read_file() of a file whose content must match its suffix.
std::string read_expected_file(const std::filesystem::path& path, std::int64_t max_bytes = kMaxFileBytes);

}  // namespace griffith
