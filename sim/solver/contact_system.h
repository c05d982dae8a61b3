#pragma once

#include <optional>
#include <span>

#include "sim/solver/contact_motion.h"
#include "sim/solver/contact_preconditioner.h"
#include "sim/solver/contact_response.h"

namespace griffith {

/// Bodies of a contact problem and how its contacts join them, which all phases of a solve share, and all solves that
/// differ in the laws of contacts alone.
struct ContactSystem {
  /// The bodies stay; of contacts, sides and axes count.
  ContactSystem(std::span<const DeformableInertia> deformable_bodies, std::span<const RigidInertia> rigid_bodies,
                std::span<const FrictionContact> contacts)
      : deformable(deformable_bodies),
        rigid(rigid_bodies),
        bodies(deformable, rigid, condense(deformable, contacts)),
        motion(bodies, deformable, contacts),
        preconditioner(bodies, deformable, rigid, contacts),
        response(bodies, motion, deformable, rigid, contacts) {}
  ContactSystem(const ContactSystem&) = delete;
  ContactSystem& operator=(const ContactSystem&) = delete;

  std::span<const DeformableInertia> deformable;
  std::span<const RigidInertia> rigid;
  ContactBodies bodies;
  ContactMotion motion;
  ContactPreconditioner preconditioner;
  ContactResponse response;
  std::optional<Eigen::VectorXd> compressed;  ///< changes of velocity by the last solve's phase of compression [m/s]
};

}  // namespace griffith
