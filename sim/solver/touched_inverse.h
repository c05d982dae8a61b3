#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/lanes.h"
#include "sim/solver/contact_bodies.h"
#include "sim/solver/contact_jacobian.h"
#include "sim/solver/rigid_motion.h"

namespace griffith {

/// Static condensation of a body's matrix A, by its factors, onto the rows that contacts touch. All that contacts do to
/// the body and all that they feel of it passes through these rows, so that a contact problem needs no others.
///
/// As in RigidModePreconditioner, the velocity of a row is v = y + B W^½ c: y deforms the body, the six numbers c move
/// it as a whole, which follows from its mass alone. Both have an energy of their own, yᵀ C⁻¹ y and cᵀ c, so that the
/// small compliance C = ((I − Q) A⁻¹ (I − Q)ᵀ)ₜₜ of deformation is never hidden behind that of the whole, W.
class TouchedInverse {
 public:
  /// `body` has factors and stays; `touched`: rows, ascending.
  TouchedInverse(const DeformableInertia& body, std::vector<int> touched);

  /// Unknowns: three a touched row, then those of the whole, if it moves.
  int size() const { return rows() + (body_.whole.exists() ? 6 : 0); }
  /// Those of touched rows.
  int rows() const { return static_cast<int>(stiffness_.rows()); }
  /// C⁻¹, of touched rows [kg]; the stiffness of c is 1.
  const Eigen::MatrixXd& stiffness() const { return stiffness_; }

  /// Returns the product of the stiffness and a change of the unknowns.
  Eigen::VectorXd multiply(const Eigen::Ref<const Eigen::VectorXd>& change) const;
  /// Returns the square of about the largest speed of a touched row under impulses on the unknowns [m²/s²].
  double squared_speed_under(const Eigen::Ref<const Eigen::VectorXd>& impulses) const;
  /// Adds the derivatives of the velocity of a contact's side, along its axes, by the unknowns, which begin at `first`.
  void add_side(const ContactSide& side, const Mat3& axes, int first, ContactJacobian& jacobian) const;

 private:
  /// B W^½ of a row, or of a point that only turns with the whole.
  RigidModes whole_at(int row) const;
  RigidModes whole_turning(const Vec3& arm) const;
  /// Numbers of four vectors.
  using FourVectors = std::vector<simd::WideQuad>;
  /// Returns L⁻¹ of unit impulses on touched rows, without what moves the whole.
  std::vector<FourVectors> reduce_units() const;

  const DeformableInertia& body_;
  std::vector<int> touched_;
  double root_of_mass_ = 0;              // of W, of translations [kg^-½]
  Mat3 root_of_inertia_ = Mat3::Zero();  // of W, of turns
  Eigen::MatrixXd compliance_, stiffness_;
};

/// Condenses the bodies of a contact problem that have factors, unless so many of their rows are touched that the dense
/// matrix of those takes more operations to factor than the sparse one of all. Per body; the bodies stay.
std::vector<std::optional<TouchedInverse>> condense(std::span<const DeformableInertia> bodies,
                                                    std::span<const FrictionContact> contacts);

/// Collects the rows that contacts touch, ascending, per deformable body.
std::vector<std::vector<int>> touched_rows(std::size_t bodies, std::span<const FrictionContact> contacts);

}  // namespace griffith
