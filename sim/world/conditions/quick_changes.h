#pragma once

#include <vector>

#include "sim/world/conditions/loads.h"

namespace griffith {

struct Body;
struct WorldState;

/// When loads and moving supports do to a body what waves must carry [s].
struct QuickChange {
  BodyId body;
  TimeSpan time;  ///< a moment, or that of a steep ramp
};

/// Changes that begin before the end of `span` and end at its start or later. A load or a support changes quickly where
/// the stress that it makes grows or falls by a tenth of what breaks the body while a wave crosses that.
std::vector<QuickChange> quick_changes(const WorldState& world, const TimeSpan& span);

/// True if what acts on a body changes quickly more than once within `span`: its waves are those of a pulse, which has
/// a length of its own.
bool is_pulsed(const WorldState& world, const Body& body, const TimeSpan& span);

}  // namespace griffith
