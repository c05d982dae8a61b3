#pragma once

#include "app/editor/holding_search.h"
#include "ui/model/editor_state.h"

namespace griffith::app {

/// What a search found, in words: for each of strength, speed and thickness from what on the node stands. `material`:
/// what the node's body is made of.
ui::WorkReport holding_report(const HoldingAnswer& answer, const RunToCrack& run);

}  // namespace griffith::app
