#pragma once

#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Returns the free position to the right of all bodies in their initial placement, with a margin [m]. `frame`: of a
/// world that may lack the last bodies.
double free_place(const Scene& scene, const Frame& frame, double room);

/// A body as commands add it: some decimeters large.
struct TypicalBody {
  const char* name;
  const char* material;  ///< preset
  Shape shape;
  Vec3 rotation_degrees = Vec3::Zero();
};

/// Returns such a body on the ground next to all others.
BodyDescription new_body(const TypicalBody& typical, const Scene& scene, const Frame& frame);

/// Returns a copy of a body of the scene next to all others, under another name.
BodyDescription copy_of_body(const Scene& scene, int index, const Frame& frame);

}  // namespace griffith::app
