#pragma once

#include <filesystem>

#include "sim/mesh/mesh_cells.h"

namespace griffith {

/// Reads a mesh as tetrahedra, in the file's units: a folder with verts.csv and tets.csv (0-based), TetGen .node/.ele
/// (either one names the pair), Gmsh .msh 2.2 and 4.1 (text, binary), Medit .mesh (text), VTK .vtk (text, binary) and
/// .vtu (text, inline and appended, uncompressed). Tets come first, in the file's order; pyramids, prisms and hexahedra
/// are split (split_cells()). Of cells of higher order the corners alone are taken, and cells without a volume are left
/// out; `report`, if given, receives counts of both. The soup still has to be prepared (mesh_report.h). Throws
/// InputError with file and line (byte, in binary data) and what was expected there, also for polyhedra.
TetSoup read_mesh(const std::filesystem::path& path, CellReport* report = nullptr);

/// True if the path names one of the formats above by its ending, or a folder.
bool is_mesh_path(const std::filesystem::path& path);

}  // namespace griffith
