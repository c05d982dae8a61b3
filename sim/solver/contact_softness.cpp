#include "sim/solver/contact_softness.h"

#include <Eigen/LU>
#include <algorithm>

#include "sim/core/rotation.h"

namespace griffith {
namespace {

/// Mean compliance of a rigid side, or of a node that moves alone, at its own point [1/kg].
double rigid_compliance(const RigidInertia& body, const Vec3& arm) {
  const Mat3 cross = cross_matrix(arm);
  return 1 / body.mass - (cross * body.inertia.inverse() * cross).trace() / 3;
}
/// Where held nodes carry nearly all of a point, its others count as much more than they have.
double compliance_of(const DeformableInertia& body, const WeightedRows& point) {
  constexpr double kLeastWeight = 0.05;
  double compliance = 0;
  for (int i = 0; i < 3; ++i)
    if (const int row = point.rows[i]; row >= 0) {
      const double of_node =
          body.matrix ? body.preconditioner->inverse_diagonal(row).trace() / 3 : 1 / body.masses[row];
      compliance += std::max(point.weights[i].squaredNorm() / 3, kLeastWeight * kLeastWeight) * of_node;
    }
  return compliance;
}

/// Compliance of a body at a point that does not deform [1/kg].
double whole_compliance(const WholeMotion& whole, const WeightedRows& point) {
  if (!whole.exists()) return 0;
  Vec3 arm = Vec3::Zero();
  for (int i = 0; i < 3; ++i)
    if (const int row = point.rows[i]; row >= 0) arm += point.weights[i].trace() / 3 * whole.arms.col(row);
  const Mat3 cross = cross_matrix(arm);
  return whole.inverse_mass - (cross * whole.inverse_inertia * cross).trace() / 3;
}

}  // namespace

ContactSoftness softness_of(std::span<const DeformableInertia> deformable, std::span<const RigidInertia> rigid,
                            const FrictionContact& contact) {
  constexpr double kOfElements = 0.3, kOfMasses = 1e-2, kFirstOfWhole = 1e-3, kLastOfWhole = 1e-9;
  constexpr double kStiffest = 1e-3;  // of what contacts begin with that converge quickly
  double of_elements = 0, of_masses = 0, of_whole = 0;
  for (const ContactSide* side : {&contact.a, &contact.b}) {
    if (side->body < 0) continue;
    if (!side->deformable) {
      of_masses += rigid_compliance(rigid[side->body], side->arm);
    } else {
      const DeformableInertia& body = deformable[side->body];
      (body.matrix ? of_elements : of_masses) += compliance_of(body, side->point);
      if (body.matrix) of_whole += whole_compliance(body.whole, side->point);
    }
  }
  const double local = kOfElements * of_elements + kOfMasses * of_masses;
  if (local + of_whole <= 0) return {};  // nothing could move
  const double settled = local + kLastOfWhole * of_whole;
  return {local + kFirstOfWhole * of_whole, settled, kStiffest * settled};
}

}  // namespace griffith
