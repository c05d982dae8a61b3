#pragma once

#include "app/editor/holding_search.h"
#include "ui/model/editor_state.h"

namespace griffith::app {

/// Describes the result of a search: the critical strength, speed and thickness of the node. `run`: provides the
/// material of the node's body.
ui::WorkReport holding_report(const HoldingAnswer& answer, const RunToCrack& run);

}  // namespace griffith::app
