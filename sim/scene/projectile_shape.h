#pragma once

#include <filesystem>
#include <span>
#include <variant>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith {

// What a projectile may be besides a sphere: rigid and convex. Lengths are in metres.

struct BoxProjectile {
  Vec3 size = Vec3::Constant(0.3);  ///< edge lengths, > 0
  bool operator==(const BoxProjectile&) const = default;
};

/// The convex hull of some points.
struct PointsProjectile {
  /// At least four, not all in a plane [m].
  std::vector<Vec3> points = {{-0.1, -0.1, -0.1}, {0.2, 0, 0}, {0, 0.2, 0}, {0, 0, 0.2}};
  bool operator==(const PointsProjectile&) const = default;
};

/// The convex hull of a surface from a file.
struct SurfaceProjectile {
  std::filesystem::path path;  ///< as written in the scene; relative paths start at the scene file's folder
  double scale = 1;            ///< metres per unit of the file, > 0
  bool operator==(const SurfaceProjectile&) const = default;
};

/// Whether points do not lie in a plane: their least spread along any direction is a visible share of the largest.
bool span_volume(std::span<const Vec3> points);

using ProjectileShape = std::variant<BoxProjectile, PointsProjectile, SurfaceProjectile>;

}  // namespace griffith
