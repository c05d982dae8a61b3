#pragma once

#include <Eigen/Core>
#include <functional>

namespace griffith {

/// Solves A x = b by the generalized minimal residual method (Saad & Schultz 1986), A given by its products. Stops at
/// |b − A x| <= tolerance · |b| or after `max_iterations`.
Eigen::VectorXd gmres(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& multiply, const Eigen::VectorXd& b,
                      double tolerance, int max_iterations);

}  // namespace griffith
