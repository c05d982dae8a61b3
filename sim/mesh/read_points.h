#pragma once

#include <filesystem>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Points from a text file: x, y, z a line, parted by blanks, commas or semicolons; a heading line is passed over and
/// `#` starts a comment. Throws InputError, naming the line, when something else stands there or there is no point.
std::vector<Vec3> read_points(const std::filesystem::path& path);

}  // namespace griffith
