#pragma once

#include <filesystem>

#include "app/bake/bake.h"

namespace griffith::app {

/// Throws InputError unless the file's extension names a format of export_bake(): .glb, .usda, .html, .json, .csv.
void check_bake_path(const std::filesystem::path& path);

/// Writes a bake in the format of the file's extension; returns the size of the file [bytes]. Throws InputError if that
/// fails.
std::size_t export_bake(const std::filesystem::path& path, const Bake& bake);

}  // namespace griffith::app
