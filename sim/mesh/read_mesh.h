#pragma once

#include <cstdint>
#include <filesystem>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Reads tetrahedra, in the file's units and order: a folder with verts.csv and tets.csv (0-based), TetGen .node/.ele
/// (either one names the pair), Gmsh .msh 2.2 and 4.1 (text, binary), Medit .mesh (text), VTK .vtk (text, binary) and
/// .vtu (text, inline and appended, uncompressed). Second-order tets give their corners; elements that are no tets are
/// skipped and counted in `skipped_elements` if given. The soup still has to be prepared (mesh_report.h). Throws
/// InputError with file and line (byte, in binary data) and what was expected there.
TetSoup read_mesh(const std::filesystem::path& path, std::int64_t* skipped_elements = nullptr);

}  // namespace griffith
