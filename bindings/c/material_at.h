#pragma once

#include "sim/world/output/frame.h"

namespace griffith::c {

/// Point of material: a tet and the barycentric weights of its corners 1 to 3.
struct MaterialPlace {
  int tet = -1;  ///< -1: there are no bodies
  Vec3 weights = Vec3::Zero();
};

/// Returns the material at a place [m], or the point of the surface that is nearest to it.
MaterialPlace material_at(const Frame& frame, const Vec3& place);

}  // namespace griffith::c
