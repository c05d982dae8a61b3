#pragma once

#include <vector>

#include "sim/splinters/fragments.h"

namespace griffith {

/// Two fragments that touch.
struct FragmentContact {
  int a = 0, b = 0;                ///< fragments
  int tet_face = -1;               ///< of a's tet, where the two are in different tets
  bool is_wall = false;            ///< they are of different cells
  int face = 0;                    ///< of a's polyhedron
  std::vector<Vec3> outline = {};  ///< the part of the face in which they touch; empty: all of it
  double area = 0;                 ///< [m²]
};

/// All contacts from both sides: a tet's face or a wall appears once for each fragment that it bounds.
std::vector<FragmentContact> find_contacts(const TetMesh& mesh, const CellPartition& cells,
                                           const std::vector<Fragment>& fragments);

/// Which splinter a fragment belongs to, numbered from 0 in the order of their first fragments. See make_splinters().
std::vector<int> group_fragments(const CellPartition& cells, const std::vector<Fragment>& fragments,
                                 const std::vector<FragmentContact>& contacts);

}  // namespace griffith
