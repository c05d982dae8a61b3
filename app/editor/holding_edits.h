#pragma once

#include "app/editor/holding_search.h"
#include "ui/model/edit_history.h"

namespace griffith::app {

/// Result of a search for what would have held a node, with the run that it changed.
struct HoldingFound {
  HoldingAnswer answer;
  RunToCrack run;
};

// Edits with which the node would have held. Each is one entry of the history, and needs the factor of its kind.

/// Makes the material of the node's body as strong as needed. It acts from the shown step on, as a branch.
void apply_strength(ui::EditHistory& history, const HoldingFound& found);
/// Slows all shots, those fired by hand included, and all bodies that move at the start.
void apply_speed(ui::EditHistory& history, const HoldingFound& found);
/// Makes the node's body as thick as needed.
void apply_thickness(ui::EditHistory& history, const HoldingFound& found);

}  // namespace griffith::app
