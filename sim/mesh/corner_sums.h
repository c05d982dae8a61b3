#pragma once

#include <array>
#include <span>

#include "sim/mesh/tet_mesh.h"

namespace griffith {

/// Sums contributions of elements at nodes, element by element. Each element is read once, not once per corner. The
/// sums equal those over the nodes' stars to the bit, since stars are ascending too. `body_tets`: those of one body,
/// ascending; `nodes`: a consecutive range of its nodes, ascending, not empty; `sums`: per node of the mesh. Calls
/// add(tet, to) for each tet with a corner among the nodes. to[i] points to the sum of corner i, or to an unused one
/// for corners that are not among the nodes. Threads with different nodes of a body therefore do not interfere.
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
