#pragma once

#include <Eigen/LU>

#include "sim/elasticity/element.h"

namespace griffith::app {

/// Returns barycentric coordinates of points in a tet, one column each.
template <class Points>
auto barycentric(const Corners& tet, const Points& points) {
  constexpr int kCount = Points::ColsAtCompileTime;
  Eigen::Matrix4d with_ones;
  with_ones << tet, Eigen::RowVector4d::Ones();
  Eigen::Matrix<double, 4, kCount> right;
  right << points, Eigen::Matrix<double, 1, kCount>::Ones();
  return Eigen::Matrix<double, 4, kCount>(with_ones.inverse() * right);
}

}  // namespace griffith::app
