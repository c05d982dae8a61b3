#pragma once

#include <string>

#include "sim/world/output/frame.h"

namespace griffith::app {

/// Returns all crack events of a run, oldest first, as a JSON array of objects in SI units: `step`, `time`, `body`,
/// `children`, `node`, `position`, `rest_position`, `normal`, `eigenvalue`, `load`, `resistance`, `nodes_made`,
/// `torn_off` and `elements` with `tet`, `above` and the forces `tensile` and `compressive` on the node.
std::string crack_events_json(const Frame& frame);

}  // namespace griffith::app
