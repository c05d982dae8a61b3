#pragma once

#include <optional>

#include "ui/model/gizmo.h"
#include "ui/model/scene_entry.h"

namespace griffith::ui {

/// Where an entry stands in the world at the start; nothing for one without a place, such as a list of nodes. What has
/// no angles of its own has those of 0.
std::optional<Placement> placement_of(const Scene& scene, const SceneEntry& entry);
/// Whether it can be turned: bodies, and the flight of projectiles.
bool can_turn(const SceneEntry& entry);
/// Moves and turns the entry as it takes to bring the one placement to the other.
void move_entry(Scene& scene, const SceneEntry& entry, const Placement& from, const Placement& to);

/// The region of a support, a load or a probe; nullptr where the entry has none.
const Region* region_of(const Scene& scene, const SceneEntry& entry);
/// Gives such an entry another region.
void set_region(Scene& scene, const SceneEntry& entry, const Region& region);

}  // namespace griffith::ui
