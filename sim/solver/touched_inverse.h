#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/solver/contact_problem.h"
#include "sim/solver/rigid_motion.h"

namespace griffith {

/// Static condensation of a body's matrix A, by its factors, onto the rows that contacts touch. While contacts change
/// their stiffness, only that of the touched rows is factored again.
///
/// As in RigidModePreconditioner, the velocity of a row is v = y + B W^½ c: y deforms the body, the six numbers c move
/// it as a whole, which follows from its mass alone. Both have an energy of their own, yᵀ C⁻¹ y and cᵀ c, so that the
/// small compliance C = ((I − Q) A⁻¹ (I − Q)ᵀ)ₜₜ of deformation is never hidden behind that of the whole, W.
class TouchedInverse {
 public:
  /// `body` has factors and stays.
  TouchedInverse(const DeformableInertia& body, std::span<const int> touched);

  /// Unknowns: three a touched row, then those of the whole, if it moves.
  int size() const { return rows() + (body_.whole.exists() ? 6 : 0); }
  /// Those of touched rows.
  int rows() const { return static_cast<int>(stiffness_.rows()); }
  /// C⁻¹, of touched rows [kg]; the stiffness of c is 1.
  const Eigen::MatrixXd& stiffness() const { return stiffness_; }
  /// B W^½ of a row, or of a point that only turns with the whole.
  RigidModes whole_at(int row) const;
  RigidModes whole_turning(const Vec3& arm) const;

  /// Takes impulses on all rows; returns those on the unknowns. `reduced`: to be handed to extend().
  Eigen::VectorXd restrict(const NodeVectors& r, std::vector<double>& reduced) const;
  /// The change of velocity of all rows by that of the unknowns.
  void extend(const Eigen::VectorXd& solved, std::vector<double> reduced, Eigen::Ref<NodeVectors> z) const;

 private:
  std::vector<std::vector<double>> reduce_units(std::span<const int> rows) const;
  NodeVectors deforming(const NodeVectors& r) const;
  /// y of touched rows by reduced impulses.
  Eigen::VectorXd moved_by(const std::vector<double>& reduced) const;

  const DeformableInertia& body_;
  double root_of_mass_ = 0;              // of W, of translations [kg^-½]
  Mat3 root_of_inertia_ = Mat3::Zero();  // of W, of turns
  std::vector<int> filled_;              // numbers of reduced vectors that impulses on touched rows reach
  Eigen::MatrixXd units_;                // reduced unit impulses on touched rows Y, transposed: C = Yᵀ Y
  Eigen::MatrixXd stiffness_;
};

}  // namespace griffith
