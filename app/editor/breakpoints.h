#pragma once

#include <optional>
#include <string>

#include "sim/world/frame.h"
#include "ui/model/selection.h"
#include "ui/model/time_view.h"

namespace griffith::app {

/// Why the simulation stopped before a step.
struct Stop {
  std::string reason;  ///< "Node 12 cracks in the next step."
  NodeId node;         ///< that cracks; invalid where none does that is there already
};

/// Whether a step from `before` to `after` met a breakpoint. `scene_body`, `selection`: those chosen in the editor.
std::optional<Stop> met_breakpoint(const ui::Breakpoints& breakpoints, const Frame& before, const Frame& after,
                                   int scene_body, const ui::Selection& selection);

}  // namespace griffith::app
