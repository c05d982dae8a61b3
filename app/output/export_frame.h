#pragma once

#include <filesystem>
#include <string>

#include "sim/world/output/frame.h"

namespace griffith::app {

/// Lists the formats of export_frame() for help: ".vtu (ParaView) or .msh (Gmsh)".
std::string frame_formats_text();

/// Throws InputError unless export_frame() supports the file's extension. Call it before long work.
void check_export_path(const std::filesystem::path& path);

/// Writes the deformed mesh of a frame for other programs: .vtu with every field (displacement, velocity, reaction,
/// separation stress, resistance, utilization and direction per node; stress, von Mises stress, body and scene body per
/// tet), .msh with the mesh alone. The file is replaced atomically. Throws InputError for another extension, or if it
/// cannot be written.
void export_frame(const std::filesystem::path& path, const Frame& frame);

}  // namespace griffith::app
