#pragma once

#include <array>
#include <optional>

#include "sim/scene/scene.h"

namespace griffith::ui {

/// Groups of the axes x, y, z of a shape: those of one number can only be scaled together, as the two across a
/// cylinder.
using ScaleGroups = std::array<int, 3>;
ScaleGroups scale_groups(const Shape& shape);

/// Returns the lengths of a shape along its axes [m]; empty if they are in a file.
std::optional<Vec3> extents_of(const Shape& shape);

/// Returns the product without digits that come from rounding errors alone.
double scaled(double value, double factor);
Vec3 scaled(const Vec3& value, const Vec3& factors);

/// Multiplies the lengths of a shape by factors along its axes, which are equal within a group. The sizes of its
/// elements stay, as they are targets in meters.
void scale_lengths(Shape& shape, const Vec3& factors);
/// Multiplies the sizes of elements by the factors, so that the scaled shape has as many as before. No effect on files.
void scale_elements(Shape& shape, const Vec3& factors);
/// Multiplies places of a region in the rest space by the factors; the radius of a sphere if they are equal.
void scale_region(Region& region, const Vec3& factors);

}  // namespace griffith::ui
