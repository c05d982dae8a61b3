#pragma once

#include <optional>

#include "sim/solver/pivot.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Returns the place and axes about which its supports let a body turn, none where they hold it more firmly.
std::optional<Pivot> pivot_of(const WorldState& world, const Body& body);
/// True if supports move the body.
bool is_driven(const WorldState& world, const Body& body);
/// True if supports let the body move as a whole, otherwise than about a pivot: a hammer on rails. To be stored in
/// Body::guided.
bool is_guided(const WorldState& world, const Body& body);

}  // namespace griffith
