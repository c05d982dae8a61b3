#pragma once

#include <limits>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// The state of a node's separation.
struct NodeSeparation {
  Mat3 tensor = Mat3::Zero();      ///< ς, world frame [N]
  double eigenvalue = 0;           ///< v⁺, its largest [N]
  Vec3 direction = Vec3::UnitX();  ///< n̂, its unit eigenvector: normal of the candidate crack plane
  double stress = 0;               ///< s [Pa] (strength criterion), averaged over the last substeps
  double resistance = std::numeric_limits<double>::infinity();  ///< [Pa] or, with the force criterion, [N]
  double utilization = 0;  ///< load over resistance [-]; the node separates above 1
};

}  // namespace griffith
