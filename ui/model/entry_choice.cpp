#include "ui/model/entry_choice.h"

#include <algorithm>

namespace griffith::ui {

std::vector<SceneEntry> selected_entries(const EditorState& state, const Scene& scene) {
  std::vector<SceneEntry> chosen = state.entries;
  if (chosen.empty()) chosen.push_back({EntryKind::body, state.selected_body});
  std::erase_if(chosen, [&](const SceneEntry& entry) { return !has_entry(scene, entry); });
  return chosen;
}

std::optional<SceneEntry> active_entry(const EditorState& state, const Scene& scene) {
  const std::vector<SceneEntry> chosen = selected_entries(state, scene);
  return chosen.empty() ? std::nullopt : std::optional(chosen.back());
}

std::vector<std::size_t> selected_body_indices(const EditorState& state, const Scene& scene) {
  std::vector<std::size_t> bodies;
  for (const SceneEntry& entry : selected_entries(state, scene))
    if (entry.kind == EntryKind::body) bodies.push_back(static_cast<std::size_t>(entry.index));
  return bodies;
}

std::vector<std::string> selected_bodies(const EditorState& state, const Scene& scene) {
  std::vector<std::string> names;
  for (const std::size_t body : selected_body_indices(state, scene)) names.push_back(scene.bodies[body].name);
  return names;
}

void select_entries(EditorState& state, const Scene& scene, std::vector<SceneEntry> entries) {
  state.selection = {};
  state.entries = std::move(entries);
  if (state.entries.empty()) return;
  if (const std::optional<int> body = body_of(scene, state.entries.back())) state.selected_body = *body;
}

void toggle_entry(EditorState& state, const Scene& scene, const SceneEntry& entry) {
  std::vector<SceneEntry> chosen = selected_entries(state, scene);
  const bool was_chosen = std::erase(chosen, entry) > 0;
  if (!was_chosen || chosen.empty()) chosen.push_back(entry);
  select_entries(state, scene, std::move(chosen));
}

void select_range(EditorState& state, const Scene& scene, const std::vector<SceneEntry>& listed,
                  const SceneEntry& entry) {
  const std::optional<SceneEntry> start = active_entry(state, scene);
  const auto end = std::ranges::find(listed, entry);
  const auto from = start ? std::ranges::find(listed, *start) : listed.end();
  if (from == listed.end() || end == listed.end()) return select_entries(state, scene, {entry});
  // The active entry stays last: the next range starts from it.
  std::vector<SceneEntry> range(std::min(from, end), std::max(from, end) + 1);
  if (from < end) std::ranges::reverse(range);
  select_entries(state, scene, std::move(range));
}

}  // namespace griffith::ui
