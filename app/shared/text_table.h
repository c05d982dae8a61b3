#pragma once

#include <string>
#include <vector>

namespace griffith::app {

/// The lines as columns, each as wide as its widest text; all have as many cells as the first.
std::string text_table(const std::vector<std::vector<std::string>>& lines);

}  // namespace griffith::app
