#pragma once

#include "sim/scene/scene.h"

namespace griffith::ui {

bool shows_layer(const ViewSettings& view, ViewLayer layer);

/// Shows or hides a layer. What lies inside of bodies comes with bodies that can be seen through, unless they are cut
/// or drawn otherwise already.
void show_layer(ViewSettings& view, ViewLayer layer, bool show = true);

/// Whether blue and red stand for values below and above 0, the same of either: of a quantity that has a sign, where no
/// other colours and no range with another middle were chosen. The automatic range is then symmetric.
bool parts_at_zero(const ViewSettings& view);

/// A slice across the axis that points most towards the eye, through the middle of `low` and `high` [m]: it hides the
/// nearer half. `towards_eye`: any length but 0.
SlicePlane middle_slice(const Vec3& low, const Vec3& high, const Vec3& towards_eye);

}  // namespace griffith::ui
