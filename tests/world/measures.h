#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "sim/world/energy/energy_account.h"
#include "sim/world/output/frame.h"

namespace griffith::testing {

/// The largest principal stress anywhere, by its size [Pa].
inline double largest_stress(const Frame& frame) {
  double largest = 0;
  for (const Mat3& stress : frame.elements.stresses)
    largest = std::max(
        largest,
        Eigen::SelfAdjointEigenSolver<Mat3>(stress, Eigen::EigenvaluesOnly).eigenvalues().cwiseAbs().maxCoeff());
  return largest;
}

/// Returns the total force of all supports [N].
inline Vec3 sum_of_reactions(const Frame& frame) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& reaction : frame.nodes.reactions) sum += reaction;
  return sum;
}

/// Returns the unaccounted fraction of the turnover.
inline double fraction_unaccounted(const EnergyAccount& energy) {
  return energy.turned_over() > 0 ? std::abs(energy.unaccounted()) / energy.turned_over() : 0;
}

}  // namespace griffith::testing
