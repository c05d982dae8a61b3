#pragma once

#include <optional>

#include "sim/scene/region.h"

namespace griffith {

enum class SupportKind {
  fixed,       ///< stands still
  sliding,     ///< free in the plane across `normal`: a symmetry plane, a smooth bearing
  prescribed,  ///< moves with `velocity`
};

/// The nodes of a region, held. Where supports overlap, a node obeys all of them, the earlier ones first. Directions
/// are the world's.
struct Support {
  Region region;
  SupportKind kind = SupportKind::fixed;
  Vec3 normal = Vec3::UnitY();                ///< of a sliding support; any length but 0
  Vec3 velocity = Vec3::Zero();               ///< of a prescribed one [m/s]
  std::optional<double> stop = std::nullopt;  ///< when a prescribed one comes to a halt [s]; absent: never
  bool can_tear = true;                       ///< whether the body tears off it where its material fails there
  bool operator==(const Support&) const = default;
};

enum class LoadKind {
  point_force,  ///< `force`, in equal parts on the region's nodes
  traction,     ///< `traction` times the undeformed area, on the surface whose nodes all lie in the region
  pressure,     ///< `pressure` against that surface as it is now
  body_force,   ///< `acceleration` times the mass, in the tets whose nodes all lie in the region
};

/// A load on a region of a body. It acts from `start` for `duration` and grows in proportion to time during the first
/// `ramp`. Directions are the world's.
struct Load {
  Region region;
  LoadKind kind = LoadKind::point_force;
  Vec3 force = Vec3::Zero();                      ///< in all [N]
  Vec3 traction = Vec3::Zero();                   ///< [Pa]
  double pressure = 0;                            ///< [Pa], > 0 pushes inwards
  Vec3 acceleration = Vec3::Zero();               ///< [m/s²], as gravity is
  double start = 0;                               ///< [s], >= 0
  std::optional<double> duration = std::nullopt;  ///< [s], > 0; absent: for ever
  double ramp = 0;                                ///< [s], >= 0
  bool operator==(const Load&) const = default;
};

}  // namespace griffith
