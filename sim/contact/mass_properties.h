#pragma once

#include "sim/contact/contact_world.h"
#include "sim/geometry/convex_hull.h"

namespace griffith {

/// Integrals over a homogeneous convex solid.
struct MassProperties {
  Vec3 center = Vec3::Zero();   ///< center of mass [m]
  double volume = 0;            ///< [m³]
  Mat3 inertia = Mat3::Zero();  ///< inertia about the center, for a density of 1 kg/m³ [kg·m²]
};

/// Returns the properties of a hull.
MassProperties mass_properties(const ConvexHull& hull);

/// True if a hull encloses a volume, however small: its points do not lie in a plane.
bool is_solid(const ConvexHull& hull);

}  // namespace griffith
