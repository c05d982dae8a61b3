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

/// A part of a scene, as the outliner lists it.
struct SceneEntry {
  EntryKind kind = EntryKind::body;
  int index = 0;  ///< in its list: the scene's or, of supports and loads, their body's
  int body = 0;   ///< whose support or load it is; of others 0
  auto operator<=>(const SceneEntry&) const = default;
};

/// Calls `action` with the list that holds the entry, which its body has to have.
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

/// Calls `action` with the entry itself, which has to be there.
template <class AnyScene, class Action>
decltype(auto) visit_entry(AnyScene& scene, const SceneEntry& entry, Action action) {
  return visit_list(scene, entry, [&](auto& list) { return action(list[static_cast<std::size_t>(entry.index)]); });
}

/// All that a scene holds: each body with its supports and loads, then projectiles, probes and cameras.
std::vector<SceneEntry> scene_entries(const Scene& scene);
bool has_entry(const Scene& scene, const SceneEntry& entry);

/// Whether entries of the kind are in a list of their body.
constexpr bool is_part_of_body(EntryKind kind) { return kind == EntryKind::support || kind == EntryKind::load; }
/// Whether entries of the kind have a name of their own.
bool has_name(EntryKind kind);
/// Its name, or "Support 2".
std::string entry_name(const Scene& scene, const SceneEntry& entry);
/// "Support 2 of wall".
std::string full_name(const Scene& scene, const SceneEntry& entry);
/// Which body it is, or belongs to; nothing for projectiles, cameras, and probes of none.
std::optional<int> body_of(const Scene& scene, const SceneEntry& entry);

/// Gives a named entry another name; probes follow their body. Returns why not, or an empty text.
std::string rename_entry(Scene& scene, const SceneEntry& entry, const std::string& name);
/// Takes entries out, and the probes of bodies that go.
void remove_entries(Scene& scene, std::vector<SceneEntry> entries);
/// Appends a copy of the entry to its list, by another name. Returns which it is.
SceneEntry append_copy(Scene& scene, const SceneEntry& entry);

/// Whether any of the entries has room in its list for a place further up (`way` -1) or down (1).
bool can_move(const Scene& scene, const std::vector<SceneEntry>& entries, int way);
/// Moves entries by one place in their lists, up (`way` -1) or down (1); those at the end that way, and those behind
/// them, stay. Returns which they are now, in the same order.
std::vector<SceneEntry> move_entries(Scene& scene, std::vector<SceneEntry> entries, int way);

/// A name that ends in a number of its own: "leg 2" is "leg" and 2; without one the number is 1.
struct NumberedName {
  std::string name;
  int number = 1;
};
NumberedName numbered_name(const std::string& name);

/// The wanted name where no item has it, else with the next number that is free behind it.
template <class T>
std::string free_name(const std::vector<T>& items, const std::string& wanted) {
  std::string free = wanted;
  auto [name, number] = numbered_name(wanted);
  while (std::ranges::find(items, free, &T::name) != items.end()) free = name + " " + std::to_string(++number);
  return free;
}

}  // namespace griffith::ui
