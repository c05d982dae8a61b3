#pragma once

#include <optional>

#include "sim/scene/region.h"

namespace griffith {

enum class SupportKind {
  fixed,       ///< no motion
  sliding,     ///< free in the plane normal to `normal`: a symmetry plane, a smooth bearing
  prescribed,  ///< moves with `velocity`
};

/// Supported nodes of a region. Where supports overlap, a node obeys all of them, the earlier ones first. Directions
/// are in world axes.
struct Support {
  Region region;
  SupportKind kind = SupportKind::fixed;
  Vec3 normal = Vec3::UnitY();                ///< normal of a sliding support; any length but 0
  Vec3 velocity = Vec3::Zero();               ///< velocity of a prescribed support [m/s]
  std::optional<double> stop = std::nullopt;  ///< time at which a prescribed support stops [s]; absent: never
  bool can_tear = true;                       ///< true if the body tears off where its material fails there
  bool operator==(const Support&) const = default;
};

enum class LoadKind {
  point_force,  ///< `force`, in equal parts on the region's nodes
  traction,     ///< `traction` times the undeformed area, on surface faces with all nodes in the region
  pressure,     ///< `pressure` against the present surface of these faces
  body_force,   ///< `acceleration` times the mass, in tets with all nodes in the region
};

/// Load on a region of a body. It acts from `start` for `duration` and grows linearly during the first `ramp`.
/// Directions are in world axes.
struct Load {
  Region region;
  LoadKind kind = LoadKind::point_force;
  Vec3 force = Vec3::Zero();                      ///< total force [N]
  Vec3 traction = Vec3::Zero();                   ///< [Pa]
  double pressure = 0;                            ///< [Pa], > 0 pushes inward
  Vec3 acceleration = Vec3::Zero();               ///< [m/s²], like gravity
  double start = 0;                               ///< [s], >= 0
  std::optional<double> duration = std::nullopt;  ///< [s], > 0; absent: forever
  double ramp = 0;                                ///< [s], >= 0
  bool operator==(const Load&) const = default;
};

}  // namespace griffith
