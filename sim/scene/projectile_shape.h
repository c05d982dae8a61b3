#pragma once

#include <filesystem>
#include <span>
#include <variant>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith {

// Shapes of projectiles other than spheres, rigid and convex. Lengths are in meters.

struct BoxProjectile {
  Vec3 size = Vec3::Constant(0.3);  ///< edge lengths, > 0
  bool operator==(const BoxProjectile&) const = default;
};

/// Convex hull of points.
struct PointsProjectile {
  /// At least four points, not all in a plane [m].
  std::vector<Vec3> points = {{-0.1, -0.1, -0.1}, {0.2, 0, 0}, {0, 0.2, 0}, {0, 0, 0.2}};
  bool operator==(const PointsProjectile&) const = default;
};

/// Convex hull of a surface from a file.
struct SurfaceProjectile {
  std::filesystem::path path;  ///< as written in the scene; relative to the scene file's folder
  double scale = 1;            ///< meters per unit of the file, > 0
  bool operator==(const SurfaceProjectile&) const = default;
};

/// True if points do not lie in a plane: their smallest extent along any direction is a visible fraction of the
/// largest.
bool span_volume(std::span<const Vec3> points);

using ProjectileShape = std::variant<BoxProjectile, PointsProjectile, SurfaceProjectile>;

}  // namespace griffith
