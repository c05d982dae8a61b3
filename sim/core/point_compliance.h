#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/core/lanes.h"
#include "sim/core/linear_algebra.h"

namespace griffith {

/// Point whose velocity is the sum of weights_i · v(rows_i) over a few nodes.
struct WeightedRows {
  std::array<int, 3> rows;  ///< -1 for a fixed node
  std::array<Mat3, 3> weights;
};

/// Velocities of n points of an elastic body per impulse at each of them: C = Mᵀ S M + W D Wᵀ, a symmetric matrix of
/// 3×3 blocks [1/kg]. M holds the modes of the whole body, mostly few; W D Wᵀ adds the response of the nodes next to
/// the points. The cost of an impulse is that of the modes, while that of a full C would be quadratic in the points.
struct PointCompliance {
  Eigen::MatrixXd modes = Eigen::MatrixXd(0, 0);  ///< M, one column for each of the 3n components [kg^-1/2]
  int removed_modes = 0;                          ///< number of last modes with S = −1; S is 1 for the others
  std::vector<WeightedRows> points = {};          ///< W, with indices into `nodes` as rows
  std::vector<Mat3> nodes = {};                   ///< D [1/kg]

  /// Multiplies C by `factor` >= 0.
  void scale(double factor);
  /// Appends three modes Lᵀ A, where L Lᵀ = `inverse` and A has one 3×3 block for each point. Modes that are `removed`
  /// are subtracted and must be the last ones.
  void add_modes(const Mat3& inverse, const std::vector<Mat3>& blocks, bool removed);
  /// Returns the block of a point's own velocity under its own impulse.
  Mat3 block(int point) const;
};

/// Returns the compliance of points whose nodes respond independently, each by its own block of `nodes`. The points'
/// rows select these blocks; unused ones are dropped.
PointCompliance node_compliance(std::span<const WeightedRows> points, std::span<const Mat3> nodes);

/// Motion of such points under consecutive impulses, with data laid out for vector registers.
class PointMotion {
 public:
  /// `velocities`: those of the points without the later impulses [m/s].
  PointMotion(const PointCompliance& compliance, Eigen::Matrix3Xd velocities);

  void push(int point, const Vec3& impulse);
  Vec3 velocity(int point) const;

 private:
  /// Coupling of a point to a node: W, and D Wᵀ.
  struct Share {
    int node = -1;
    Mat3 weight, answer;
  };
  std::size_t groups_;                        // groups of four modes, the last padded with zeros
  std::vector<simd::WideQuad> columns_;       // M: by point, axis and group
  std::vector<simd::WideQuad> signs_;         // S: by group
  std::vector<std::array<Share, 3>> shares_;  // by point
  Eigen::Matrix3Xd velocities_;               // of the points without the impulses
  std::vector<simd::WideQuad> modes_;         // S M p, by group
  std::vector<simd::WideQuad> nodes_;         // D Wᵀ p, in three lanes
};

/// Returns C p for impulses on all points, one column each.
Eigen::Matrix3Xd respond(const PointCompliance& compliance, const Eigen::Matrix3Xd& impulses);

}  // namespace griffith
