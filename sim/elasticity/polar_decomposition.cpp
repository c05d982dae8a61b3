#include "sim/elasticity/polar_decomposition.h"

#include <Eigen/SVD>
#include <cmath>

namespace griffith {
namespace {

Mat3 polar_rotation_by_svd(const Mat3& m) {
  const Eigen::JacobiSVD<Mat3> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) = -u.col(2);
  return u * svd.matrixV().transpose();
}

}  // namespace

Mat3 polar_rotation(const Mat3& deformation_gradient) {
  // Newton's iteration Q <- (Q + Q^-T)/2 (Higham 1986): two or three rounds for the small strains of stiff bodies.
  constexpr int kMaxIterations = 12;
  // Of the squared change. Convergence is quadratic, with half the square of the change left: 5e-15.
  constexpr double kTolerance = 1e-14;
  Mat3 q = deformation_gradient;
  for (int i = 0; i < kMaxIterations; ++i) {
    const Mat3 c = cofactor(q);
    const double determinant = q.col(0).dot(c.col(0));
    if (!(determinant > 1e-3)) break;
    const Mat3 next = 0.5 * (q + c / determinant);
    const double change = (next - q).squaredNorm();
    q = next;
    if (change < kTolerance) return q;
  }
  return polar_rotation_by_svd(deformation_gradient);
}

}  // namespace griffith
