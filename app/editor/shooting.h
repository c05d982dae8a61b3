#pragma once

#include <optional>

#include "sim/scene/scene.h"
#include "sim/world/frame.h"
#include "ui/model/aim.h"

namespace griffith::app {

/// How far along origin + t · direction the frame's surface or the ground is hit first [in lengths of `direction`].
std::optional<double> surface_hit(const Frame& frame, const std::optional<Ground>& ground, const Vec3& origin,
                                  const Vec3& direction);

/// `shot` placed at `muzzle` and aimed so that it flies through `target` under `gravity` [m/s²] on the flatter of the
/// two arcs; straight at it when that is out of reach.
ProjectileBurst aimed_shot(ProjectileBurst shot, const Vec3& muzzle, const Vec3& target, const Vec3& gravity);

/// The flight of the shot's centre under `gravity` [m/s²] until it meets the frame's surface or the ground, as bodies
/// stand now; followed half as far again as the way to `target` at most.
ui::Aim flight_of(const ProjectileBurst& shot, const Vec3& target, const Vec3& gravity, const Frame& frame,
                  const std::optional<Ground>& ground);

}  // namespace griffith::app
