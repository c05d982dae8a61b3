#include "ui/model/scene_problem.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace griffith::ui {
namespace {

constexpr std::array<std::pair<std::string_view, EntryKind>, 4> kLists = {{{"bodies", EntryKind::body},
                                                                           {"projectiles", EntryKind::projectile},
                                                                           {"probes", EntryKind::probe},
                                                                           {"cameras", EntryKind::camera}}};
constexpr std::array<std::pair<std::string_view, EntryKind>, 2> kListsOfBody = {
    {{"supports", EntryKind::support}, {"loads", EntryKind::load}}};

/// Removes and returns the first part of the pointer: "bodies" of "/bodies/0".
std::string_view take_part(std::string_view& pointer) {
  if (pointer.starts_with('/')) pointer.remove_prefix(1);
  const std::string_view part = pointer.substr(0, pointer.find('/'));
  pointer.remove_prefix(part.size());
  return part;
}

/// Removes and returns the list entry with which the pointer begins.
template <std::size_t N>
std::optional<SceneEntry> take_entry(const Scene& scene, std::string_view& pointer, int body,
                                     const std::array<std::pair<std::string_view, EntryKind>, N>& lists) {
  std::string_view rest = pointer;
  const std::string_view name = take_part(rest), number = take_part(rest);
  const auto list = std::ranges::find(lists, name, &std::pair<std::string_view, EntryKind>::first);
  int index = -1;
  std::from_chars(number.data(), number.data() + number.size(), index);
  if (list == lists.end() || index < 0) return std::nullopt;
  const SceneEntry entry{list->second, index, body};
  if (!has_entry(scene, entry)) return std::nullopt;
  pointer = rest;
  return entry;
}

/// Returns the entry that the pointer names or leads into, and removes it from the pointer.
std::optional<SceneEntry> take_entry(const Scene& scene, std::string_view& pointer) {
  const std::optional<SceneEntry> entry = take_entry(scene, pointer, 0, kLists);
  if (!entry || entry->kind != EntryKind::body) return entry;
  const std::optional<SceneEntry> part = take_entry(scene, pointer, entry->index, kListsOfBody);
  return part ? part : entry;
}

}  // namespace

FieldPlace field_place(const Scene& scene, std::string_view pointer) {
  const std::optional<SceneEntry> entry = take_entry(scene, pointer);
  const std::string rest(pointer);
  if (!entry) return {entry, "scene" + rest};
  if (entry->kind != EntryKind::body) return {entry, "entry" + rest};
  return {entry, rest.starts_with("/material") ? rest.substr(1) : "body" + rest};
}

std::string place_text(const Scene& scene, std::string_view pointer) {
  const std::optional<SceneEntry> entry = take_entry(scene, pointer);
  std::string text = entry ? full_name(scene, *entry) : "Scene";
  for (bool first = true; !pointer.empty(); first = false) {
    std::string part(take_part(pointer));
    std::ranges::replace(part, '_', ' ');
    text += (first ? ": " : ", ") + part;
  }
  return text;
}

bool is_within(std::string_view sought, std::string_view tag) {
  return sought.starts_with(tag) && (sought.size() == tag.size() || sought[tag.size()] == '/');
}

}  // namespace griffith::ui
