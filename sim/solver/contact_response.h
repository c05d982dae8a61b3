#pragma once

#include <span>
#include <vector>

#include "sim/solver/contact_motion.h"

namespace griffith {

/// Changes of the velocities of all rows of deformable bodies by the impulses of a contact problem.
class ContactResponse {
 public:
  /// `bodies`, `motion`: the unknowns of the problem and what contacts feel of them; all stay.
  ContactResponse(const ContactBodies& bodies, const ContactMotion& motion,
                  std::span<const DeformableInertia> deformable, std::span<const RigidInertia> rigid,
                  std::span<const FrictionContact> contacts);

  /// Lets all rows respond to impulses along the axes of contacts, which gave the unknowns the change `y`, up to a
  /// residual of `relative_residual` of the impulses on a body. Its deformation counts by what it carries, however
  /// slow it is. Returns the relative velocities at contacts beyond those of `y`: the factors of condensed bodies are
  /// those of an earlier matrix, and `y` itself is exact up to a speed.
  Eigen::Matrix3Xd respond(const Eigen::Matrix3Xd& impulses, const Eigen::VectorXd& y, double relative_residual,
                           int max_iterations);
  /// Returns the change of a body's rows by the last call, one column a row [m/s]. The momentum of the whole is exact.
  const NodeVectors& change(std::size_t body) const { return changes_[body]; }

 private:
  const ContactBodies& bodies_;
  const ContactMotion& motion_;
  std::span<const DeformableInertia> deformable_;
  ContactBodies all_rows_;
  ContactMotion motion_of_all_rows_;
  std::vector<NodeVectors> changes_;
};

/// Change of the velocities of a body by impulses on its rows alone [N·s]; the momentum of the whole is exact. The rest
/// begins with `guess` where there is one, and stops at a residual of `relative_residual`.
NodeVectors respond_alone(const DeformableInertia& body, const NodeVectors& impulses, double relative_residual,
                          int max_iterations, const NodeVectors& guess = {});

}  // namespace griffith
