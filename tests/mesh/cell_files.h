#pragma once

#include <vector>

#include "sim/mesh/mesh_cells.h"
#include "tests/mesh/sample_files.h"

namespace griffith::testing {

/// Volume cells of any shape, tets among them.
struct CellMesh {
  std::vector<Vec3> points;
  std::vector<VolumeCell> cells;

  void add(CellShape shape, std::vector<int> corners);
};

/// A unit cube of n × n × n hexahedra, some of them parted into prisms, pyramids or tets so that faces match, with
/// nodes moved by up to `jitter` of a hexahedron's edge and numbered in random order. Its border stays plane.
CellMesh mixed_block(int n, double jitter, int seed);

/// The mesh as text in each format that knows such cells; a triangle and a line are among them.
std::vector<SampleFile> cell_files(const CellMesh& mesh);

}  // namespace griffith::testing
