#pragma once

#include <optional>

#include "sim/core/linear_algebra.h"

namespace griffith::ui {

/// The half-line from the eye through a point of the picture; `direction` has length 1.
struct ViewRay {
  Vec3 origin, direction;
};

/// How the picture shows places of the world: perspective, with the axes of the eye. Points of the picture are in
/// pixels from its top left corner.
struct ViewCamera {
  Vec3 eye = Vec3(0, 0, 5);                                                        ///< [m]
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitY(), forward = Vec3(-Vec3::UnitZ());  ///< orthonormal
  double tangent = 0.36;             ///< of half the vertical angle of view
  double width = 640, height = 480;  ///< of the picture [pixels]

  ViewRay ray(const Vec2& pixel) const;
  /// Where the point is seen; nothing where it is not before the eye.
  std::optional<Vec2> pixel(const Vec3& point) const;
  /// How long a pixel is at the depth of the point [m].
  double pixel_length(const Vec3& point) const;
};

}  // namespace griffith::ui
