#pragma once

#include <optional>

#include "ui/model/gizmo.h"
#include "ui/model/scene_entry.h"

namespace griffith::ui {

/// Returns the placement of an entry in the world at the start; empty for an entry without one, such as a list of
/// nodes. Entries without angles have angles of 0.
std::optional<Placement> placement_of(const Scene& scene, const SceneEntry& entry);
/// True if the entry can be rotated: bodies and the direction of projectiles.
bool can_turn(const SceneEntry& entry);
/// Moves and rotates the entry by the change from one placement to the other.
void move_entry(Scene& scene, const SceneEntry& entry, const Placement& from, const Placement& to);

/// Returns the region of a support, load or probe; nullptr if the entry has none.
const Region* region_of(const Scene& scene, const SceneEntry& entry);
/// Sets the region of such an entry.
void set_region(Scene& scene, const SceneEntry& entry, const Region& region);

}  // namespace griffith::ui
