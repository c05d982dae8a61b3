#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/core/lanes.h"
#include "sim/core/linear_algebra.h"

namespace griffith {

/// A point that moves with a few nodes: its velocity is the sum of weights_i · v(rows_i).
struct WeightedRows {
  std::array<int, 3> rows;  ///< -1 for a node that is held
  std::array<Mat3, 3> weights;
};

/// How n points of an elastic body answer impulses, each at all: C = Mᵀ S M + W D Wᵀ, a symmetric matrix of 3×3 blocks
/// [1/kg]. M are modes of the whole body, mostly few, W D Wᵀ what the nodes next to the points do on top. An impulse so
/// costs what the modes cost, where the whole of C costs what the points cost squared.
struct PointCompliance {
  Eigen::MatrixXd modes = Eigen::MatrixXd(0, 0);  ///< M, one column for each of the 3n components [kg^-1/2]
  int removed_modes = 0;                          ///< so many of the last modes count against: S is −1 there, else 1
  std::vector<WeightedRows> points = {};          ///< W: rows are indices into nodes
  std::vector<Mat3> nodes = {};                   ///< D [1/kg]

  /// All of C times `factor` >= 0.
  void scale(double factor);
  /// Appends three modes Lᵀ A, where L Lᵀ = `inverse` and A has one 3×3 block a point. `removed` ones count against;
  /// after them no others may be added.
  void add_modes(const Mat3& inverse, const std::vector<Mat3>& blocks, bool removed);
  /// The block of a point's own velocity under its own impulse.
  Mat3 block(int point) const;
};

/// That of points whose nodes answer alone, each by its own block of `nodes`, by the points' rows; the others are not
/// kept.
PointCompliance node_compliance(std::span<const WeightedRows> points, std::span<const Mat3> nodes);

/// The motion of such points under impulses that come one after the other, laid out for vector registers.
class PointMotion {
 public:
  /// `velocities`: of the points without the impulses to come [m/s].
  PointMotion(const PointCompliance& compliance, Eigen::Matrix3Xd velocities);

  void push(int point, const Vec3& impulse);
  Vec3 velocity(int point) const;

 private:
  /// What a point has to do with a node: W, and D Wᵀ.
  struct Share {
    int node = -1;
    Mat3 weight, answer;
  };
  std::size_t groups_;                        // of four modes, the last filled up with zeros
  std::vector<simd::WideQuad> columns_;       // M: by point, axis and group
  std::vector<simd::WideQuad> signs_;         // S: by group
  std::vector<std::array<Share, 3>> shares_;  // by point
  Eigen::Matrix3Xd velocities_;               // without the impulses
  std::vector<simd::WideQuad> modes_;         // S M p, by group
  std::vector<simd::WideQuad> nodes_;         // D Wᵀ p, in three lanes
};

/// C p for impulses on all points, one column each.
Eigen::Matrix3Xd respond(const PointCompliance& compliance, const Eigen::Matrix3Xd& impulses);

}  // namespace griffith
