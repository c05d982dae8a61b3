#pragma once

#include <span>

#include "sim/fracture/force_dyads.h"
#include "sim/fracture/separation_tensor.h"

namespace griffith {

/// Partial sums of a node's load.
struct NodeLoadSums {
  Dyads dyads;       ///< Σ m(f_e⁺) − m(f_e⁻), finally 2 ς [N]
  ForceLanes total;  ///< f⁺, f⁻ [N]
  simd::WideQuad diagonal = {},
                 off_diagonal = {};  ///< sums of volume times tension [J]: xx, yy, zz, volume [m³]; xy, xz, yz
  LargestPrincipal pulled;           ///< as in NodeLoad
  double area = 0, largest = 0;      ///< as in NodeLoad [m²], [Pa]

  NodeLoad load() const;
};

/// Sums the loads of `nodes`, a consecutive range of a body's (ascending, not empty), from all its `tets` (ascending).
/// Equals separation_tensor() and node_load() to the bit, but works element by element, so that each is read twice
/// instead of four times per sum. Writes the entries of `nodes` in `sums` (per node of the mesh).
void accumulate_node_loads(const SeparationInput& input, std::span<const TetId> tets, std::span<const NodeId> nodes,
                           std::span<NodeLoadSums> sums);

}  // namespace griffith
