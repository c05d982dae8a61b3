#pragma once

#include "ui/model/editor_state.h"

namespace griffith::ui {

/// The entries that the outliner shows as chosen, the one that was chosen last at the end.
std::vector<SceneEntry> chosen_entries(const EditorState& state, const Scene& scene);
/// The last of them, whose fields are shown.
std::optional<SceneEntry> active_entry(const EditorState& state, const Scene& scene);
/// The names of the bodies among them.
std::vector<std::string> chosen_bodies(const EditorState& state, const Scene& scene);

/// Chooses entries that the scene has in place of those that were, and of what was picked in the view.
void choose_entries(EditorState& state, const Scene& scene, std::vector<SceneEntry> entries);
/// Chooses an entry besides the others, or no more.
void toggle_entry(EditorState& state, const Scene& scene, const SceneEntry& entry);
/// Chooses all from the active entry to this one, in the order in which they are `listed`.
void choose_range(EditorState& state, const Scene& scene, const std::vector<SceneEntry>& listed,
                  const SceneEntry& entry);

}  // namespace griffith::ui
