#pragma once

#include "sim/scene/scene.h"
#include "sim/world/frame.h"
#include "ui/model/commands.h"

namespace griffith::app {

/// Returns the free position to the right of all bodies in their initial placement, with a margin [m]. `frame`: of a
/// world that may lack the last bodies.
double free_place(const Scene& scene, const Frame& frame, double room);

/// Returns a body for one of the commands add_box, add_plate, …: some decimeters large, of a typical material, on the
/// ground next to all others.
BodyDescription new_body(ui::CommandId command, const Scene& scene, const Frame& frame);

/// Returns a copy of a body of the scene next to all others, under another name.
BodyDescription copy_of_body(const Scene& scene, int index, const Frame& frame);

}  // namespace griffith::app
