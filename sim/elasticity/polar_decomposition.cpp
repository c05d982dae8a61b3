#include "sim/elasticity/polar_decomposition.h"

#include <Eigen/SVD>

#include "sim/elasticity/rotation_kernel.h"

namespace griffith {

Mat3 simd::polar_rotation_by_svd(const Mat3& deformation_gradient) {
  const Eigen::JacobiSVD<Mat3> svd(deformation_gradient, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) = -u.col(2);
  return u * svd.matrixV().transpose();
}

Mat3 polar_rotation(const Mat3& deformation_gradient) {
  return simd::rotation_of(simd::numbers(deformation_gradient)).of(0);
}

}  // namespace griffith
