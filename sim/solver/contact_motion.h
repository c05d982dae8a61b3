#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/solver/contact_bodies.h"
#include "sim/solver/contact_jacobian.h"
#include "sim/solver/touched_inverse.h"

namespace griffith {

/// Bodies of a contact problem in one vector: rows of the deformable ones, or the unknowns of those that are condensed,
/// then six numbers of each rigid one.
class ContactBodies {
 public:
  using Condensed = std::vector<std::optional<TouchedInverse>>;

  /// `condensed`: per deformable body.
  ContactBodies(std::span<const DeformableInertia> deformable, std::span<const RigidInertia> rigid,
                Condensed condensed);

  int size() const { return size_; }
  int offset(const ContactSide& side) const {
    return side.deformable ? offsets_[side.body] : first_rigid_ + 6 * side.body;
  }
  int first_of_deformable(std::size_t body) const { return offsets_[body]; }
  int first_of_rigid() const { return first_rigid_; }
  /// Null where all rows take part.
  const TouchedInverse* condensed(std::size_t body) const { return condensed_[body] ? &*condensed_[body] : nullptr; }
  /// Rows of a deformable body that is not condensed, one column each.
  NodeVectors change(std::size_t body, const Eigen::VectorXd& v) const;

  /// Returns about the largest speed that impulses would give a node, or a rigid body's mass, without contacts [m/s].
  double speed_under(const Eigen::VectorXd& impulses) const;

  /// Writes A v. The whole of a body resists by its mass alone.
  void multiply(const Eigen::VectorXd& v, Eigen::VectorXd& product) const;

 private:
  double squared_speed_of_deformable(std::size_t body, const Eigen::VectorXd& impulses) const;
  double squared_speed_of_rigid(std::size_t body, const Eigen::VectorXd& impulses) const;

  std::span<const DeformableInertia> deformable_;
  std::span<const RigidInertia> rigid_;
  Condensed condensed_;
  std::vector<int> offsets_;
  int first_rigid_ = 0, size_ = 0;
};

/// The map J from the velocities of bodies to the relative velocities at contacts.
class ContactMotion {
 public:
  ContactMotion(const ContactBodies& bodies, std::span<const DeformableInertia> deformable,
                std::span<const FrictionContact> contacts);

  /// Returns J v, one column a contact.
  Eigen::Matrix3Xd of(const Eigen::VectorXd& v) const;
  /// v becomes v + Jᵀ p.
  void add_impulses(const Eigen::Matrix3Xd& p, Eigen::VectorXd& v) const;

 private:
  /// A contact off the surface of a body that turns as a whole.
  struct Lever {
    int contact, body, offset;
    Mat3 arm;  ///< from spin to velocity along the axes
  };

  void add_side(const ContactBodies& bodies, const ContactSide& side, const Mat3& axes);
  Vec3 spin_of(const Lever& lever, const Eigen::VectorXd& v) const;
  void add_torques(std::span<const int> levers, const Eigen::Matrix3Xd& p, Eigen::VectorXd& v) const;

  std::span<const DeformableInertia> deformable_;
  ContactJacobian local_;
  std::vector<Lever> levers_;
  std::vector<std::vector<int>> levers_of_;  ///< indices into levers_, per deformable body
};

}  // namespace griffith
