#pragma once

#include <string_view>

#include "ui/model/scaled_shape.h"
#include "ui/model/scene_entry.h"

namespace griffith::ui {

/// Returns the reason why an entry cannot be scaled; empty if it can.
std::string_view scale_problem(const Scene& scene, const SceneEntry& entry);

/// Axes and size of an entry that can be scaled.
struct ScaleFrame {
  Mat3 axes = Mat3::Identity();      ///< columns: directions of its own axes in the world
  ScaleGroups groups = {0, 1, 2};    ///< axes that are scaled together
  std::optional<Vec3> extents = {};  ///< lengths along its axes [m]; empty: those of a file
};
ScaleFrame scale_frame(const Scene& scene, const SceneEntry& entry);

/// Multiplies an entry's size by factors along its own axes, about its place. Regions of a body's supports, loads and
/// probes follow it; lengths that describe material or mesh, such as bricks and elements, stay.
void scale_entry(Scene& scene, const SceneEntry& entry, const Vec3& factors);

/// Scales a region about its own place.
void scale_about_place(Region& region, const Vec3& factors);

}  // namespace griffith::ui
