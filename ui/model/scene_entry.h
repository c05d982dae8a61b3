#pragma once

#include <algorithm>
#include <compare>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scene/scene.h"

namespace griffith::ui {

enum class EntryKind { body, support, load, projectile, probe, camera };

/// A part of a scene, as listed in the outliner.
struct SceneEntry {
  EntryKind kind = EntryKind::body;
  int index = 0;  ///< index in its list: the scene's or, for supports and loads, their body's
  int body = 0;   ///< body of a support or load; 0 for others
  auto operator<=>(const SceneEntry&) const = default;
};

/// Calls `action` with the list that holds the entry. Its body must exist.
template <class AnyScene, class Action>
decltype(auto) visit_list(AnyScene& scene, const SceneEntry& entry, Action action) {
  const auto body = static_cast<std::size_t>(entry.body);
  switch (entry.kind) {
    case EntryKind::support:
      return action(scene.bodies[body].supports);
    case EntryKind::load:
      return action(scene.bodies[body].loads);
    case EntryKind::projectile:
      return action(scene.projectiles);
    case EntryKind::probe:
      return action(scene.probes);
    case EntryKind::camera:
      return action(scene.cameras);
    default:
      return action(scene.bodies);
  }
}

/// Calls `action` with the entry itself, which must exist.
template <class AnyScene, class Action>
decltype(auto) visit_entry(AnyScene& scene, const SceneEntry& entry, Action action) {
  return visit_list(scene, entry, [&](auto& list) { return action(list[static_cast<std::size_t>(entry.index)]); });
}

/// Returns all entries of a scene: each body with its supports and loads, then projectiles, probes and cameras.
std::vector<SceneEntry> scene_entries(const Scene& scene);
bool has_entry(const Scene& scene, const SceneEntry& entry);

/// True if entries of the kind belong to a body's list.
constexpr bool is_part_of_body(EntryKind kind) { return kind == EntryKind::support || kind == EntryKind::load; }
/// True if entries of the kind have a name of their own.
bool has_name(EntryKind kind);
/// Returns its name, or "Support 2".
std::string entry_name(const Scene& scene, const SceneEntry& entry);
/// Returns its name with its body: "Support 2 of wall".
std::string full_name(const Scene& scene, const SceneEntry& entry);
/// Returns the body that the entry is or belongs to; empty for projectiles, cameras, and probes without a body.
std::optional<int> body_of(const Scene& scene, const SceneEntry& entry);

/// Renames an entry; probes follow their body. Returns the reason if it cannot, else an empty text.
std::string rename_entry(Scene& scene, const SceneEntry& entry, const std::string& name);
/// Removes entries, and the probes of removed bodies.
void remove_entries(Scene& scene, std::vector<SceneEntry> entries);
/// Appends a copy of the entry under a new name to its list. Returns the copy.
SceneEntry append_copy(Scene& scene, const SceneEntry& entry);

/// True if any of the entries can move up (`way` -1) or down (1) in its list.
bool can_move(const Scene& scene, const std::vector<SceneEntry>& entries, int way);
/// Moves entries by one place up (`way` -1) or down (1) in their lists; those at that end, and those behind them, stay.
/// Returns their new entries in the same order.
std::vector<SceneEntry> move_entries(Scene& scene, std::vector<SceneEntry> entries, int way);

/// A name with its trailing number: "leg 2" is "leg" and 2; without one the number is 1.
struct NumberedName {
  std::string name;
  int number = 1;
};
NumberedName numbered_name(const std::string& name);

/// Returns the preferred name if no item has it, else the name with the next free number.
template <class T>
std::string free_name(const std::vector<T>& items, const std::string& preferred) {
  std::string free = preferred;
  auto [name, number] = numbered_name(preferred);
  while (std::ranges::find(items, free, &T::name) != items.end()) free = name + " " + std::to_string(++number);
  return free;
}

}  // namespace griffith::ui
