#pragma once

#include <array>
#include <span>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Adds up at nodes what elements give them, element by element: each is read once, not once a corner, and the sums are
/// those over the stars of the nodes to the bit, since stars ascend too. `body_tets`: of one body, ascending; `nodes`:
/// some of its nodes in a row, ascending, not none; `sums`: per node of the mesh. Calls add(tet, to) for each tet with
/// a corner among the nodes, where to[i] points to the sum of corner i, or, of a node that is none of them, to one that
/// nobody reads: so threads with other nodes of the body do not meet.
template <class Sum, class Add>
void add_at_corners(std::span<const std::array<NodeId, 4>> tets, std::span<const TetId> body_tets,
                    std::span<const NodeId> nodes, std::span<Sum> sums, const Add& add) {
  const NodeId first = nodes.front(), last = nodes.back();
  Sum unread{};
  for (const TetId tet : body_tets) {
    std::array<Sum*, 4> to;
    bool counts = false;
    for (int i = 0; i < 4; ++i) {
      const NodeId corner = tets[tet][i];
      const bool is_among = first <= corner && corner <= last;
      to[i] = is_among ? &sums[corner] : &unread;
      counts = counts || is_among;
    }
    if (counts) add(tet, to);
  }
}

}  // namespace griffith
