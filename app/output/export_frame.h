#pragma once

#include <filesystem>

#include "sim/world/frame.h"

namespace griffith::app {

/// Throws InputError unless export_frame() knows the file's ending: to be called before the work, not after it.
void check_export_path(const std::filesystem::path& path);

/// Writes the deformed mesh of a frame for other programs: .vtu with every field (displacement, velocity, reaction,
/// separation stress, resistance, utilization and direction per node; stress, von Mises stress, body and scene body per
/// tet), .msh the mesh alone. The file is replaced as a whole. Throws InputError for another ending, or when it cannot
/// be written.
void export_frame(const std::filesystem::path& path, const Frame& frame);

}  // namespace griffith::app
