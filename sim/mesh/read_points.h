#pragma once

#include <filesystem>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Reads points from a text file: x, y, z on each line, separated by blanks, commas or semicolons. A heading line is
/// skipped, and `#` starts a comment. Throws InputError, naming the line, for other content and if there is no point.
std::vector<Vec3> read_points(const std::filesystem::path& path);

}  // namespace griffith
