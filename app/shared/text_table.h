#pragma once

#include <string>
#include <vector>

namespace griffith::app {

/// Aligns lines in columns as wide as their widest text; all lines have as many cells as the first.
std::string text_table(const std::vector<std::vector<std::string>>& lines);

}  // namespace griffith::app
