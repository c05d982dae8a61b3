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

/// Returns the bounding box of a body of the scene in its rest space [m]. `frame`: of the world that was made from
/// `built`, which may lack the last bodies.
Eigen::AlignedBox3d rest_box(const Scene& scene, int body, const Frame& frame, const Scene& built);

/// Returns the end of a box toward `direction`, along the nearest axis, with a fiftieth of its length.
BoxRegion end_of_box(const Eigen::AlignedBox3d& box, const Vec3& direction);

/// Returns a support that holds the lower end of a body with that box.
Support new_support(const BodyDescription& body, const Eigen::AlignedBox3d& box);
/// Returns a pressure on its upper end.
Load new_load(const BodyDescription& body, const Eigen::AlignedBox3d& box);
/// Returns a probe at the center of a body, with a name that is new in the scene.
Probe new_probe(const Scene& scene, const BodyDescription& body, const Eigen::AlignedBox3d& box);

}  // namespace griffith::app
