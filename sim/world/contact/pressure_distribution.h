#pragma once

#include <optional>

#include "sim/world/contact/face_contacts.h"

namespace griffith {

/// Returns the pressures of the least Σ p²/a that have a given sum and moments and do not pull: linear over the patch
/// where none vanishes (Navier). Empty if there are none.
/// \param moments    one column a point: 1 and its two coordinates in the plane [-, m]
/// \param areas      of the points, >= 0, where 0 takes nothing [m²]
/// \param resultant  sum of the impulses and their moments [N·s, N·s·m], the first > 0
std::optional<Eigen::VectorXd> even_pressures(const Eigen::Matrix3Xd& moments, const Eigen::VectorXd& areas,
                                              const Vec3& resultant);

/// Distributes the impulses of bodies that touch with their faces as rigid ones evenly over the nodes there: a rigid
/// solve has few contacts, and their impulses would bend what they press. Returns the contacts that they replace for
/// the deformation of these bodies, and the nodes with their impulses. Resultants stay the same.
SpreadContacts spread_impulses(const WorldState& world);

}  // namespace griffith
