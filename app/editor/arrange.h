#pragma once

#include <string>

#include "sim/core/linear_algebra.h"
#include "ui/model/edit_history.h"
#include "ui/model/editor_state.h"

namespace griffith::app {

// Arrangement of the selected bodies. Each is one entry of the history and leaves the bodies it placed selected.

/// Moves the selected bodies straight down, the lowest first, until each rests on the ground or on a body below it; up
/// if it has sunk into one, by less than half its height. False if they rest already. Throws InputError if nothing is
/// below one of them.
bool drop_bodies(ui::EditHistory& history, ui::EditorState& state);

/// Adds copies of the selected bodies so that there are `count` of each, every one `offset` [m] from the last.
void array_bodies(ui::EditHistory& history, ui::EditorState& state, int count, const Vec3& offset);
/// Returns the offset at which copies of the selected bodies stand side by side along x [m].
Vec3 side_by_side(const Scene& scene, const ui::EditorState& state);

/// Adds mirror images of the selected bodies along the axis: on the other side of the center of the body selected last,
/// which is not copied itself, or of the origin if only one is selected. All of them stay selected, that body last, for
/// the next mirror; of a single body only the image. Throws InputError for a body without one.
void mirror_bodies(ui::EditHistory& history, ui::EditorState& state, int axis);

/// Moves the selected bodies along the axis until their centers are level with that of the one selected last.
void align_bodies(ui::EditHistory& history, ui::EditorState& state, int axis);

}  // namespace griffith::app
