#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "sim/mesh/mesh_formats.h"

namespace griffith {

/// List of VTK cells: cell i has the type types[i] and the points connectivity[offsets[i−1]] ...
/// connectivity[offsets[i]−1], where offsets[−1] is 0.
struct VtkCells {
  std::span<const std::int64_t> types, offsets, connectivity;
};

/// Appends `cells` (of second and higher order: their corners) to `file`. Its `point_count` points are numbered from
/// `first_point`. Returns the problem; empty if there is none.
std::string add_vtk_cells(const VtkCells& cells, int first_point, std::int64_t point_count, MeshFile& file);

}  // namespace griffith
