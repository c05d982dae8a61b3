#pragma once

#include <limits>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// State of a node's separation.
struct NodeSeparation {
  Mat3 tensor = Mat3::Zero();      ///< separation tensor ς, world frame [N]
  double eigenvalue = 0;           ///< its largest eigenvalue v⁺ [N]
  Vec3 direction = Vec3::UnitX();  ///< n̂, its unit eigenvector: normal of the candidate crack plane
  /// Separation stress s, or the equivalent tension of materials with a strength surface [Pa] (strength criterion),
  /// mean of the start and the end of an implicit substep.
  double stress = 0;
  double end_stress = 0;        ///< the same at the end of the last substep [Pa]
  double mean_tension = 0;      ///< that load, averaged over the part that a crack needs [Pa]
  double averaging_radius = 0;  ///< radius of that part [m]; 0: single elements are larger, and it is s
  /// [Pa] or, with the force criterion, [N]. At a crack front where energy decides: the stress at which G is G_c. Where
  /// the mean tension decides: the stress at which that is the strength [Pa].
  double resistance = std::numeric_limits<double>::infinity();
  double energy_release = 0;                                         ///< energy release rate G at a crack front [J/m²]
  double fracture_energy = std::numeric_limits<double>::infinity();  ///< G_c across the plane [J/m²]
  double utilization = 0;  ///< larger of mean tension over strength and √(G/G_c) [-]; the node separates above 1
};

}  // namespace griffith
