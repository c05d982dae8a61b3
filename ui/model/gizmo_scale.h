#pragma once

#include "ui/model/gizmo.h"

namespace griffith::ui {

/// Returns the handles that scale an entry at a place along its axes, `size` pixels long.
std::vector<HandleShape> scale_shapes(const ViewCamera& camera, const Vec3& place, double size,
                                      const ScaleFrame& frame);

/// True if the handle scales.
bool scales(GizmoHandle handle);

/// Sets the factors of a handle that scales: the ratio of the cursor's distances from the place, rounded so that a
/// length is a multiple of the step, within the range of scene files.
void follow_scaling(GizmoDrag& drag, const ViewRay& ray, const DragSteps& steps);

/// Describes a scaling: "x 0.75 m   (× 1.5)".
std::string scaling_text(const GizmoDrag& drag);

}  // namespace griffith::ui
