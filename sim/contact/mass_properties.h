#pragma once

#include "sim/contact/contact_world.h"
#include "sim/geometry/convex_hull.h"

namespace griffith {

/// Integrals over a homogeneous convex solid.
struct MassProperties {
  Vec3 center = Vec3::Zero();   ///< of mass [m]
  double volume = 0;            ///< [m³]
  Mat3 inertia = Mat3::Zero();  ///< about the center, of a solid of 1 kg/m³ [kg·m²]
};

/// Those of a hull.
MassProperties mass_properties(const ConvexHull& hull);

/// Whether a hull has room inside, however small: its points do not lie in a plane.
bool is_solid(const ConvexHull& hull);

}  // namespace griffith
