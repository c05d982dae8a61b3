#pragma once

#include "sim/scene/scene.h"

namespace griffith::ui {

bool shows_layer(const ViewSettings& view, ViewLayer layer);

/// Shows or hides a layer. A layer inside bodies also makes them transparent, unless they are sliced or drawn in
/// another mode already.
void show_layer(ViewSettings& view, ViewLayer layer, bool show = true);

/// True if blue and red stand for values below and above 0 on a symmetric scale: for a signed quantity with default
/// colors and no range with another center. The automatic range is then symmetric.
bool parts_at_zero(const ViewSettings& view);

/// Returns a slice perpendicular to the axis that points most toward the eye, through the center of `low` and `high`
/// [m]; it hides the nearer half. `toward_eye`: any length but 0.
SlicePlane middle_slice(const Vec3& low, const Vec3& high, const Vec3& toward_eye);

}  // namespace griffith::ui
