#pragma once

#include <filesystem>

#include "sim/mesh/mesh_cells.h"

namespace griffith {

// One reader per format, called by read_mesh(); errors as described there.

/// Reads `folder`/verts.csv (x, y, z) and `folder`/tets.csv (four 0-based indices). A heading line is skipped.
MeshFile read_csv_pair(const std::filesystem::path& folder);
/// Reads TetGen's X.node and X.ele, given either one; numbered from 0 or 1.
MeshFile read_tetgen(const std::filesystem::path& path);
/// Reads Gmsh .msh 2.x and 4.1, text or binary of either byte order.
MeshFile read_gmsh(const std::filesystem::path& path);
/// Reads Medit .mesh, text.
MeshFile read_medit(const std::filesystem::path& path);
/// Reads a VTK legacy unstructured grid, text or binary, file versions up to 5.
MeshFile read_vtk(const std::filesystem::path& path);
/// Reads all pieces of a VTK XML unstructured grid; text, base64 or raw appended.
MeshFile read_vtu(const std::filesystem::path& path);

}  // namespace griffith
