#include "sim/core/point_compliance.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/core/sort_unique.h"

namespace griffith {
namespace {

void push_nodes(const PointCompliance& compliance, int point, const Vec3& impulse, Eigen::Matrix3Xd& nodes) {
  const WeightedRows& at = compliance.points[point];
  for (int k = 0; k < 3; ++k)
    if (const int node = at.rows[k]; node >= 0)
      nodes.col(node) += compliance.nodes[node] * (at.weights[k].transpose() * impulse);
}

Vec3 velocity_of_nodes(const PointCompliance& compliance, int point, const Eigen::Matrix3Xd& nodes) {
  const WeightedRows& at = compliance.points[point];
  Vec3 velocity = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    if (const int node = at.rows[k]; node >= 0) velocity += at.weights[k] * nodes.col(node);
  return velocity;
}

}  // namespace

void PointCompliance::scale(double factor) {
  modes *= std::sqrt(factor);
  for (Mat3& node : nodes) node *= factor;
}

void PointCompliance::add_modes(const Mat3& inverse, const std::vector<Mat3>& blocks, bool removed) {
  assert(removed || removed_modes == 0);
  const Mat3 half = inverse.llt().matrixU();
  const Eigen::Index first = modes.rows();
  modes.conservativeResize(first + 3, 3 * static_cast<Eigen::Index>(blocks.size()));
  for (std::size_t i = 0; i < blocks.size(); ++i)
    modes.block<3, 3>(first, 3 * static_cast<Eigen::Index>(i)) = half * blocks[i];
  if (removed) removed_modes += 3;
}

Mat3 PointCompliance::block(int point) const {
  const auto of_point = modes.middleCols<3>(3 * point);
  const auto removed = of_point.bottomRows(removed_modes);
  Mat3 sum = of_point.transpose() * of_point - 2 * (removed.transpose() * removed);
  const WeightedRows& at = points[point];
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < 3; ++l)
      if (at.rows[k] >= 0 && at.rows[k] == at.rows[l])
        sum += at.weights[k] * nodes[at.rows[k]] * at.weights[l].transpose();
  return sum;
}

PointCompliance node_compliance(std::span<const WeightedRows> points, std::span<const Mat3> nodes) {
  PointCompliance compliance;
  compliance.modes.resize(0, 3 * static_cast<Eigen::Index>(points.size()));
  compliance.points.assign(points.begin(), points.end());
  std::vector<int> used;
  for (const WeightedRows& point : points)
    for (int row : point.rows)
      if (row >= 0) used.push_back(row);
  sort_unique(used);
  for (int row : used) compliance.nodes.push_back(nodes[row]);
  for (WeightedRows& point : compliance.points)
    for (int& row : point.rows)
      if (row >= 0) row = static_cast<int>(std::lower_bound(used.begin(), used.end(), row) - used.begin());
  return compliance;
}

PointMotion::PointMotion(const PointCompliance& compliance, Eigen::Matrix3Xd velocities)
    : groups_((compliance.modes.rows() + 3) / 4),
      columns_(compliance.modes.cols() * groups_, simd::WideQuad{}),
      signs_(groups_, simd::WideQuad{}),
      shares_(compliance.points.size()),
      velocities_(std::move(velocities)),
      modes_(groups_, simd::WideQuad{}),
      nodes_(compliance.nodes.size(), simd::WideQuad{}) {
  const Eigen::Index modes = compliance.modes.rows();
  for (Eigen::Index mode = 0; mode < modes; ++mode) {
    signs_[mode / 4][mode % 4] = mode < modes - compliance.removed_modes ? 1 : -1;
    for (Eigen::Index column = 0; column < compliance.modes.cols(); ++column)
      columns_[column * groups_ + mode / 4][mode % 4] = compliance.modes(mode, column);
  }
  for (std::size_t point = 0; point < shares_.size(); ++point)
    for (int k = 0; k < 3; ++k)
      if (const int node = compliance.points[point].rows[k]; node >= 0) {
        const Mat3& weight = compliance.points[point].weights[k];
        shares_[point][k] = {node, weight, compliance.nodes[node] * weight.transpose()};
      }
}

void PointMotion::push(int point, const Vec3& impulse) {
  const simd::WideQuad* columns = columns_.data() + 3 * groups_ * point;
  for (std::size_t i = 0; i < groups_; ++i)
    modes_[i] += signs_[i] *
                 (columns[i] * impulse[0] + columns[groups_ + i] * impulse[1] + columns[2 * groups_ + i] * impulse[2]);
  for (const Share& share : shares_[point])
    if (share.node >= 0) nodes_[share.node] += simd::product(share.answer.data(), impulse[0], impulse[1], impulse[2]);
}

Vec3 PointMotion::velocity(int point) const {
  const simd::WideQuad* columns = columns_.data() + 3 * groups_ * point;
  simd::WideQuad x = {}, y = {}, z = {}, none = {};
  for (std::size_t i = 0; i < groups_; ++i) {
    x += columns[i] * modes_[i];
    y += columns[groups_ + i] * modes_[i];
    z += columns[2 * groups_ + i] * modes_[i];
  }
  simd::transpose(x, y, z, none);
  simd::WideQuad sum = (x + y) + (z + none);
  for (const Share& share : shares_[point])
    if (share.node >= 0) {
      const simd::WideQuad& node = nodes_[share.node];
      sum += simd::product(share.weight.data(), node[0], node[1], node[2]);
    }
  return velocities_.col(point) + Vec3(sum[0], sum[1], sum[2]);
}

Eigen::Matrix3Xd respond(const PointCompliance& compliance, const Eigen::Matrix3Xd& impulses) {
  Eigen::VectorXd modes = compliance.modes * impulses.reshaped();
  modes.tail(compliance.removed_modes) *= -1;
  Eigen::Matrix3Xd velocities = (compliance.modes.transpose() * modes).reshaped(3, impulses.cols());
  Eigen::Matrix3Xd nodes = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(compliance.nodes.size()));
  for (Eigen::Index i = 0; i < impulses.cols(); ++i)
    push_nodes(compliance, static_cast<int>(i), impulses.col(i), nodes);
  for (Eigen::Index i = 0; i < impulses.cols(); ++i)
    velocities.col(i) += velocity_of_nodes(compliance, static_cast<int>(i), nodes);
  return velocities;
}

}  // namespace griffith
