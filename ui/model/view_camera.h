#pragma once

#include <optional>

#include "sim/core/linear_algebra.h"

namespace griffith::ui {

/// Ray from the eye through a point of the picture; `direction` has length 1.
struct ViewRay {
  Vec3 origin, direction;
};

/// Perspective camera of the picture, with the axes of the eye. Points of the picture are in pixels from its top left
/// corner.
struct ViewCamera {
  Vec3 eye = Vec3(0, 0, 5);                                                        ///< [m]
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitY(), forward = Vec3(-Vec3::UnitZ());  ///< orthonormal
  double tangent = 0.36;             ///< tangent of half the vertical field of view
  double width = 640, height = 480;  ///< size of the picture [pixels]

  ViewRay ray(const Vec2& pixel) const;
  /// Projects a point; empty if it is not in front of the eye.
  std::optional<Vec2> pixel(const Vec3& point) const;
  /// Returns the length of a pixel at the depth of the point [m].
  double pixel_length(const Vec3& point) const;
};

}  // namespace griffith::ui
