#pragma once

#include "sim/world/state/world_state.h"

namespace griffith {

/// Returns the present law of a body's stress: that of the material times f, so that stress counts against the full
/// strength. In implicit steps, soft bodies resist compaction.
ElasticLaw effective_elastic_law(const WorldState& world, const Body& body);
/// True if a body resists compaction: one that implicit steps may strain that much. Brittle ones break long before, and
/// microsteps do not follow the frequencies of compacted elements.
bool can_be_compacted(const WorldState& world, const Body& body);

}  // namespace griffith
