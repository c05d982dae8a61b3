#pragma once

#include "ui/model/editor_state.h"

namespace griffith::ui {

/// Returns the chosen entries of the outliner, the last chosen one at the end.
std::vector<SceneEntry> chosen_entries(const EditorState& state, const Scene& scene);
/// Returns the last chosen entry, whose fields are shown.
std::optional<SceneEntry> active_entry(const EditorState& state, const Scene& scene);
/// Returns the names of the chosen bodies.
std::vector<std::string> chosen_bodies(const EditorState& state, const Scene& scene);

/// Chooses entries of the scene, replacing the choice and the selection in the view.
void choose_entries(EditorState& state, const Scene& scene, std::vector<SceneEntry> entries);
/// Adds an entry to the choice, or removes it.
void toggle_entry(EditorState& state, const Scene& scene, const SceneEntry& entry);
/// Chooses all from the active entry to this one, in the order in which they are `listed`.
void choose_range(EditorState& state, const Scene& scene, const std::vector<SceneEntry>& listed,
                  const SceneEntry& entry);

}  // namespace griffith::ui
