#pragma once

#include "sim/scene/scene.h"
#include "sim/world/frame.h"
#include "ui/model/commands.h"

namespace griffith::app {

/// Where what stands to the right of all bodies begins [m]: their end, as the scene starts, and some room. `frame`: of
/// a world that may lack the last bodies.
double free_place(const Scene& scene, const Frame& frame, double room);

/// A body of the kind that one of the commands add_box, add_plate, … adds: some decimetres large, of a material that it
/// is often made of, on the ground beside all others.
BodyDescription new_body(ui::CommandId command, const Scene& scene, const Frame& frame);

/// A copy of a body of the scene beside all others, by another name.
BodyDescription copy_of_body(const Scene& scene, int index, const Frame& frame);

}  // namespace griffith::app
