#pragma once

#include <optional>

#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"
#include "ui/model/aim.h"

namespace griffith::app {

/// Returns the parameter t of the first intersection of origin + t · direction with the frame's surface or the ground.
std::optional<double> surface_hit(const Frame& frame, const std::optional<Ground>& ground, const Vec3& origin,
                                  const Vec3& direction);

/// Returns `shot` placed at `muzzle` and aimed so that it passes through `target` under `gravity` [m/s²] on the flatter
/// of the two arcs; straight at it if it is out of range.
ProjectileBurst aimed_shot(ProjectileBurst shot, const Vec3& muzzle, const Vec3& target, const Vec3& gravity);

/// Returns the path of the shot's center under `gravity` [m/s²] to its first intersection with the frame's surface or
/// the ground in their current state; at most half as far again as the distance to `target`.
ui::Aim flight_of(const ProjectileBurst& shot, const Vec3& target, const Vec3& gravity, const Frame& frame,
                  const std::optional<Ground>& ground);

}  // namespace griffith::app
