#pragma once

#include <filesystem>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "sim/mesh/mesh_cells.h"

namespace griffith {

/// Reads a mesh as tetrahedra, in the file's units: a folder with verts.csv and tets.csv (0-based), TetGen .node/.ele
/// (either one names the pair), Gmsh .msh 2.2 and 4.1 (text, binary), Medit .mesh (text), VTK .vtk (text, binary) and
/// .vtu (text, inline and appended, uncompressed). Tets come first, in the file's order; pyramids, prisms and hexahedra
/// are split (split_cells()). Cells of higher order lose all nodes but their corners, and cells without a volume are
/// skipped; `report`, if given, receives counts of both. The soup still has to be prepared (mesh_report.h). Throws
/// InputError with file, line (byte in binary data) and the expected item, also for polyhedra.
TetSoup read_mesh(const std::filesystem::path& path, CellReport* report = nullptr);

/// True if the suffix of the path is of one of the formats above, or the path is a folder.
bool is_mesh_path(const std::filesystem::path& path);

/// Reads points from a text file: x, y, z on each line, separated by blanks, commas or semicolons. A heading line is
/// skipped, and `#` starts a comment. Throws InputError, naming the line, for other content and if there is no point.
std::vector<Vec3> read_points(const std::filesystem::path& path);

}  // namespace griffith
