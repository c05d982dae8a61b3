#pragma once

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Impulse that a contact takes, and how it changes with what is asked of it.
struct ConeProjection {
  Vec3 impulse = Vec3::Zero();     ///< along normal and tangents [N·s]
  Mat3 derivative = Mat3::Zero();  ///< by what was asked for: symmetric, eigenvalues 0..1 [-]
};

/// Euclidean projection of an impulse along the axes of a contact onto Coulomb's cone, |tangential| <= friction ·
/// normal. Inside the cone it is the impulse itself (sticking), inside the polar cone 0 (open), else on the cone's
/// surface (sliding). See Castro, Permenter & Han 2022, section IV. Of the cone the part counts whose normal impulse is
/// at least `least` [N·s] >= 0.
ConeProjection project_on_cone(const Vec3& asked, double friction, double least = 0);
/// Impulse of a bond that resists what exceeds `slack`, with at most `strength`, out of what is asked of it without
/// either [N·s]. It is the derivative of a convex function, as are those on cones.
ConeProjection hold_back(const Vec3& asked, double slack, double strength);
/// True if an impulse along the axes of a contact pushes and lies inside Coulomb's cone: the contact sticks.
bool sticks(const Vec3& impulse, double friction);

}  // namespace griffith
