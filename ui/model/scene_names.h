#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace griffith::ui {

/// What each file is called in a list: its name, with its folder behind it where another has the same name.
std::vector<std::string> scene_names(std::span<const std::filesystem::path> files);

}  // namespace griffith::ui
