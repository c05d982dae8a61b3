#pragma once

#include <filesystem>
#include <map>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Meshes that take the place of files: each body whose shape is a MeshFileShape with this path gets the soup, times
/// the shape's scale; one whose shape is a SurfaceShape with this path is filled with the soup as it is [m]. The soup
/// need not be prepared (mesh_report.h).
using InMemoryMeshes = std::map<std::filesystem::path, TetSoup>;

}  // namespace griffith
