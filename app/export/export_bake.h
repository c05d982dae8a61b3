#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/bake/bake.h"

namespace griffith::app {

/// Lists the formats of export_bake() for help: ".glb (glTF), .usda (USD) …".
std::string bake_formats_text();
/// Lists them by purpose, one line each: "Page for a browser: .html".
std::vector<std::string> bake_hints();

/// Throws InputError unless the file's extension names a format of export_bake().
void check_bake_path(const std::filesystem::path& path);

/// Writes a bake in the format of the file's extension; returns the size of the file [bytes]. Throws InputError if that
/// fails.
std::size_t export_bake(const std::filesystem::path& path, const Bake& bake);

}  // namespace griffith::app
