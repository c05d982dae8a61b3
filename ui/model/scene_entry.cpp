#include "ui/model/scene_entry.h"

#include <cstdint>
#include <numeric>
#include <utility>

namespace griffith::ui {
namespace {

constexpr bool kHasName[] = {true, false, false, false, true, true};  // by EntryKind

void add_all(std::vector<SceneEntry>& entries, EntryKind kind, std::size_t count, int body = 0) {
  for (std::size_t i = 0; i < count; ++i) entries.push_back({kind, static_cast<int>(i), body});
}

/// Renames a body in the probes that refer to it.
void rename_in_probes(Scene& scene, const std::string& from, const std::string& to) {
  for (Probe& probe : scene.probes)
    if (probe.body == from) probe.body = to;
}

}  // namespace

std::vector<SceneEntry> scene_entries(const Scene& scene) {
  std::vector<SceneEntry> entries;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const int body = static_cast<int>(i);
    entries.push_back({EntryKind::body, body});
    add_all(entries, EntryKind::support, scene.bodies[i].supports.size(), body);
    add_all(entries, EntryKind::load, scene.bodies[i].loads.size(), body);
  }
  add_all(entries, EntryKind::projectile, scene.projectiles.size());
  add_all(entries, EntryKind::probe, scene.probes.size());
  add_all(entries, EntryKind::camera, scene.cameras.size());
  return entries;
}

bool has_entry(const Scene& scene, const SceneEntry& entry) {
  if (is_part_of_body(entry.kind) && static_cast<std::size_t>(entry.body) >= scene.bodies.size()) return false;
  return visit_list(scene, entry,
                    [&](const auto& list) { return static_cast<std::size_t>(entry.index) < list.size(); });
}

bool has_name(EntryKind kind) { return kHasName[static_cast<std::size_t>(kind)]; }

std::string entry_name(const Scene& scene, const SceneEntry& entry) {
  constexpr const char* kKinds[] = {"Body", "Support", "Load", "Projectile", "Probe", "Camera"};
  return visit_entry(scene, entry, [&](const auto& item) {
    if constexpr (requires { item.name; }) {
      return item.name;
    } else {
      return kKinds[static_cast<std::size_t>(entry.kind)] + (" " + std::to_string(entry.index + 1));
    }
  });
}

std::string full_name(const Scene& scene, const SceneEntry& entry) {
  const std::string name = entry_name(scene, entry);
  if (!is_part_of_body(entry.kind)) return name;
  return name + " of " + scene.bodies[static_cast<std::size_t>(entry.body)].name;
}

std::optional<int> body_of(const Scene& scene, const SceneEntry& entry) {
  switch (entry.kind) {
    case EntryKind::body:
      return entry.index;
    case EntryKind::support:
    case EntryKind::load:
      return entry.body;
    case EntryKind::probe: {
      const std::string& name = scene.probes[static_cast<std::size_t>(entry.index)].body;
      const auto found = std::ranges::find(scene.bodies, name, &BodyDescription::name);
      if (found == scene.bodies.end()) return std::nullopt;
      return static_cast<int>(found - scene.bodies.begin());
    }
    default:
      return std::nullopt;
  }
}

std::string rename_entry(Scene& scene, const SceneEntry& entry, const std::string& name) {
  if (name.empty()) return "A name cannot be empty; it was not changed.";
  return visit_list(scene, entry, [&](auto& list) -> std::string {
    auto& item = list[static_cast<std::size_t>(entry.index)];
    if constexpr (requires { item.name; }) {
      for (const auto& other : list)
        if (&other != &item && other.name == name) return "There is already one with the name \"" + name + "\".";
      if (entry.kind == EntryKind::body) rename_in_probes(scene, item.name, name);
      item.name = name;
    }
    return {};
  });
}

void remove_entries(Scene& scene, std::vector<SceneEntry> entries) {
  // From the end, so that indices stay valid: the parts of bodies before the bodies themselves.
  std::ranges::sort(entries, [](const SceneEntry& a, const SceneEntry& b) {
    if ((a.kind == EntryKind::body) != (b.kind == EntryKind::body)) return b.kind == EntryKind::body;
    return a > b;
  });
  for (const SceneEntry& entry : entries) {
    if (entry.kind == EntryKind::body) {
      const std::string name = entry_name(scene, entry);
      std::erase_if(scene.probes, [&](const Probe& probe) { return probe.body == name; });
    }
    visit_list(scene, entry, [&](auto& list) { list.erase(list.begin() + entry.index); });
  }
}

namespace {

/// True if the entry has a neighbor on that side that does not move.
bool has_room(const Scene& scene, const std::vector<SceneEntry>& entries, SceneEntry entry, int way) {
  do entry.index += way;
  while (std::ranges::find(entries, entry) != entries.end());
  return entry.index >= 0 && has_entry(scene, entry);
}

/// Updates the parts of a body that moved.
void follow_body(std::vector<SceneEntry>& entries, const SceneEntry& from, const SceneEntry& to) {
  if (from.kind != EntryKind::body) return;
  for (SceneEntry& entry : entries)
    if (is_part_of_body(entry.kind) && (entry.body == from.index || entry.body == to.index))
      entry.body = entry.body == from.index ? to.index : from.index;
}

}  // namespace

bool can_move(const Scene& scene, const std::vector<SceneEntry>& entries, int way) {
  return std::ranges::any_of(entries, [&](const SceneEntry& entry) { return has_room(scene, entries, entry, way); });
}

std::vector<SceneEntry> move_entries(Scene& scene, std::vector<SceneEntry> entries, int way) {
  std::vector<std::size_t> order(entries.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // The leading entries go first, so that each finds its place free; parts go before their bodies.
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    if (entries[a].kind != entries[b].kind) return entries[a].kind > entries[b].kind;
    return way < 0 ? entries[a].index < entries[b].index : entries[a].index > entries[b].index;
  });
  std::vector<std::uint8_t> moves(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) moves[i] = has_room(scene, entries, entries[i], way);
  for (const std::size_t i : order) {
    if (!moves[i]) continue;
    const SceneEntry from = entries[i];
    entries[i].index += way;
    visit_list(scene, from, [&](auto& list) {
      std::swap(list[static_cast<std::size_t>(from.index)], list[static_cast<std::size_t>(entries[i].index)]);
    });
    follow_body(entries, from, entries[i]);
  }
  return entries;
}

NumberedName numbered_name(const std::string& name) {
  constexpr std::size_t kMostDigits = 6;
  const std::size_t end = name.find_last_not_of("0123456789") + 1, digits = name.size() - end;
  if (digits == 0 || digits > kMostDigits || end < 2 || name[end - 1] != ' ' || name[end] == '0') return {name};
  return {name.substr(0, end - 1), std::stoi(name.substr(end))};
}

SceneEntry append_copy(Scene& scene, const SceneEntry& entry) {
  SceneEntry copy = entry;
  visit_list(scene, entry, [&](auto& list) {
    auto item = list[static_cast<std::size_t>(entry.index)];
    if constexpr (requires { item.name; }) item.name = free_name(list, item.name);
    copy.index = static_cast<int>(list.size());
    list.push_back(std::move(item));
  });
  return copy;
}

}  // namespace griffith::ui
