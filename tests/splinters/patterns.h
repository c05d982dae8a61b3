#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "sim/core/temporary_folder.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/splinters/convex_cells.h"
#include "tests/splinters/cell_files.h"

namespace griffith::testing {

struct NamedPattern {
  std::string name;
  SplinterPattern pattern;
};

inline void PrintTo(const NamedPattern& pattern, std::ostream* stream) { *stream << pattern.name; }

/// One of each kind and their degenerate cases, of splinters of about 0.1 m.
inline std::vector<NamedPattern> patterns() {
  VoronoiSplinters shards, lattice, wood;
  lattice.jitter = 0;
  wood.size = 0.06;
  wood.grain = Vec3(1, 0.2, 0.1);
  wood.elongation = 6;
  RadialSplinters glass, regular;
  glass.center = Vec3(0.07, 0.03, 0);
  regular.jitter = 0;
  regular.sectors = 8;
  BrickSplinters bricks, dry;
  bricks.size = Vec3(0.19, 0.09, 0.19);
  dry.size = Vec3(0.2, 0.1, 0.2);
  dry.mortar = 0;
  static const TemporaryFolder folder;
  CellSplinters file;
  file.path = write_cells(folder.path() / "turned_bond.obj", turned_bond());
  return {{"shards", shards},   {"lattice", lattice}, {"wood", wood}, {"glass", glass},
          {"regular", regular}, {"bricks", bricks},   {"dry", dry},   {"file", file}};
}

inline Eigen::AlignedBox3d bounds(const TetMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& position : mesh.rest_positions) box.extend(position);
  return box;
}

}  // namespace griffith::testing
