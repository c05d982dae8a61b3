#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Shapes of cells in mesh files. Those from the tetrahedron on have a volume.
enum class CellShape : std::uint8_t {
  point,
  line,
  triangle,
  quadrilateral,
  polygon,
  tetrahedron,
  pyramid,
  prism,
  hexahedron
};
inline constexpr int kCellShapes = 9;

/// Returns the number of corners; 0 for a polygon, which may have any number.
int corner_count(CellShape shape);

inline bool has_volume(CellShape shape) { return shape >= CellShape::tetrahedron; }

/// Pyramid, prism or hexahedron. Corners are in the order of VTK and Gmsh: around the base, then the apex, or the
/// opposite face in the same sense.
struct VolumeCell {
  CellShape shape = CellShape::hexahedron;
  std::array<int, 8> corners = {};  ///< indices of points; only the first corner_count() are used
};

/// Counts of a file's cells that are not plain tetrahedra.
struct CellReport {
  std::array<std::int64_t, kCellShapes> skipped = {};       ///< cells without a volume, by shape
  std::array<std::int64_t, kCellShapes> split = {};         ///< cells that were split into tets, by shape
  std::array<std::int64_t, kCellShapes> higher_order = {};  ///< cells read that have more nodes than corners, by shape
  std::int64_t tets_of_split = 0;                           ///< tets created by splitting
};

/// Returns the nonzero counts by shape, "12 triangles, 8 lines and 1 point"; empty for none.
std::string count_list(const std::array<std::int64_t, kCellShapes>& counts);

/// Returns sentences on cells that were split, skipped or simplified; empty for plain tetrahedra.
std::vector<std::string> findings(const CellReport& report);

/// Contents of a mesh file.
struct MeshFile {
  TetSoup soup;
  std::vector<VolumeCell> cells;  ///< pyramids, prisms and hexahedra, not yet split
  CellReport report;

  /// Counts a cell without a volume.
  void skip(CellShape shape, std::int64_t count = 1) { report.skipped[static_cast<std::size_t>(shape)] += count; }
  /// Adds a cell with a volume. `corners`: corner_count() indices of points. `nodes`: the number of nodes in the file.
  void add(CellShape shape, std::span<const int> corners, std::int64_t nodes);
};

/// Splits the cells of `file` into tets of its soup. Quadrilateral faces are cut through their node of the smallest
/// number (Dompierre et al. 1999, "How to subdivide pyramids, prisms and hexahedra into tetrahedra"), or along the edge
/// that tets or other triangular faces of the file have there, so that neighbors match. Cells become fans of tets
/// around a corner, or around an added central point if no corner sees all faces well. Throws InputError, about `name`,
/// for cells that overlap themselves.
void split_cells(MeshFile& file, const std::string& name);

}  // namespace griffith
