#pragma once

#include <optional>

#include "sim/world/output/frame.h"
#include "ui/model/selection.h"
#include "ui/model/stop.h"
#include "ui/model/time_view.h"

namespace griffith::app {

/// Returns the reason to stop before a step from `before` to `after`; empty if no breakpoint was reached. `scene_body`,
/// `selection`: those of the editor.
std::optional<ui::Stop> met_breakpoint(const ui::Breakpoints& breakpoints, const Frame& before, const Frame& after,
                                       int scene_body, const ui::Selection& selection);

}  // namespace griffith::app
