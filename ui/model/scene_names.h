#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace griffith::ui {

/// Returns the listed name of each file, followed by its folder if another file has the same name.
std::vector<std::string> scene_names(std::span<const std::filesystem::path> files);

}  // namespace griffith::ui
