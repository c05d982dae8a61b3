#pragma once

#include <span>

#include "sim/fracture/force_dyads.h"
#include "sim/fracture/separation_tensor.h"

namespace griffith {

/// The load of a node while it is added up.
struct StarSums {
  Dyads dyads;       ///< Σ m(f_e⁺) − m(f_e⁻), at the end 2 ς [N]
  ForceLanes total;  ///< f⁺, f⁻ [N]
  simd::WideQuad diagonal = {},
                 off_diagonal = {};  ///< of volume times tension [J]: xx, yy, zz, volume [m³]; xy, xz, yz
  LargestPrincipal pulled;           ///< as in StarLoad
  double area = 0, largest = 0;      ///< as in StarLoad [m²], [Pa]

  StarLoad load() const;
};

/// Adds up the loads of `nodes`, some of a body's in a row (ascending, not none), from all its `tets` (ascending):
/// separation_tensor() and star_load() to the bit, but element by element, which are read twice and not four times for
/// each sum. Writes the entries of `nodes` in `sums` (per node of the mesh).
void add_up_stars(const SeparationInput& input, std::span<const TetId> tets, std::span<const NodeId> nodes,
                  std::span<StarSums> sums);

}  // namespace griffith
