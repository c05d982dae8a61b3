#pragma once

#include <vector>

#include "sim/splinters/fragments.h"

namespace griffith {

/// Contact of two fragments.
struct FragmentContact {
  int a = 0, b = 0;                ///< fragments
  int tet_face = -1;               ///< face of a's tet, if the two are in different tets
  bool is_wall = false;            ///< true if they belong to different cells
  int face = 0;                    ///< face of a's polyhedron
  std::vector<Vec3> outline = {};  ///< part of the face in which they touch; empty: all of it
  double area = 0;                 ///< [m²]
};

/// Returns all contacts from both sides: a tet's face or a wall appears once for each fragment that it bounds.
std::vector<FragmentContact> find_contacts(const TetMesh& mesh, const CellPartition& cells,
                                           const std::vector<Fragment>& fragments);

/// Returns the splinter of each fragment, numbered from 0 in the order of their first fragments. See make_splinters().
std::vector<int> group_fragments(const CellPartition& cells, const std::vector<Fragment>& fragments,
                                 const std::vector<FragmentContact>& contacts);

}  // namespace griffith
