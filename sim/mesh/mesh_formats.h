#pragma once

#include <filesystem>

#include "sim/mesh/mesh_cells.h"

namespace griffith {

// One reader a format, behind read_mesh(); errors as described there.

/// `folder`/verts.csv (x, y, z) and `folder`/tets.csv (four 0-based indices); a heading line is passed over.
MeshFile read_csv_pair(const std::filesystem::path& folder);
/// TetGen's X.node and X.ele, given either; numbered from 0 or 1.
MeshFile read_tetgen(const std::filesystem::path& path);
/// Gmsh .msh 2.x and 4.1, text or binary of either byte order.
MeshFile read_gmsh(const std::filesystem::path& path);
/// Medit .mesh, text.
MeshFile read_medit(const std::filesystem::path& path);
/// VTK legacy unstructured grid, text or binary, file versions up to 5.
MeshFile read_vtk(const std::filesystem::path& path);
/// VTK XML unstructured grid, all pieces; text, base64 or raw appended.
MeshFile read_vtu(const std::filesystem::path& path);

}  // namespace griffith
