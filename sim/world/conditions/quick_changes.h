#pragma once

#include <vector>

#include "sim/world/conditions/loads.h"

namespace griffith {

struct Body;
struct WorldState;

/// Change of loads or supports of a body that causes waves [s].
struct QuickChange {
  BodyId body;
  TimeSpan time;  ///< a moment, or that of a steep ramp
};

/// Returns changes that begin before the end of `span` and end at its start or later. A load or support changes quickly
/// if the stress that it causes changes by a tenth of the body's strength while a wave crosses the body. A grab follows
/// its target step by step and is none.
std::vector<QuickChange> quick_changes(const WorldState& world, const TimeSpan& span);

/// True if what acts on a body changes quickly more than once within `span`: its waves are those of a pulse, which has
/// a length of its own.
bool is_pulsed(const WorldState& world, const Body& body, const TimeSpan& span);

}  // namespace griffith
