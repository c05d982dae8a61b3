#pragma once

#include "ui/model/editor_state.h"

namespace griffith::ui {

/// Returns the selected entries of the outliner, the active one at the end.
std::vector<SceneEntry> selected_entries(const EditorState& state, const Scene& scene);
/// Returns the last selected entry, whose fields are shown.
std::optional<SceneEntry> active_entry(const EditorState& state, const Scene& scene);
/// Returns the indices of the selected bodies, the one selected last at the end.
std::vector<std::size_t> selected_body_indices(const EditorState& state, const Scene& scene);
/// Returns the names of the selected bodies.
std::vector<std::string> selected_bodies(const EditorState& state, const Scene& scene);

/// Selects entries of the scene, and nothing else in the outliner or the view.
void select_entries(EditorState& state, const Scene& scene, std::vector<SceneEntry> entries);
/// Adds an entry to the selection, or removes it.
void toggle_entry(EditorState& state, const Scene& scene, const SceneEntry& entry);
/// Selects all from the active entry to this one, in the order in which they are `listed`.
void select_range(EditorState& state, const Scene& scene, const std::vector<SceneEntry>& listed,
                  const SceneEntry& entry);

}  // namespace griffith::ui
