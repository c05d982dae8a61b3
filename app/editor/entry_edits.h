#pragma once

#include "renderer/camera.h"
#include "sim/world/output/frame.h"
#include "ui/model/edit_history.h"
#include "ui/model/editor_state.h"

namespace griffith::app {

// Edits of the scene's entries. Each is one entry of the history, and selects what it made.

/// Adds bodies and selects them.
void add_bodies(ui::EditHistory& history, ui::EditorState& state, const std::string& label,
                std::vector<BodyDescription> bodies);
/// Adds a support, a load or a probe to the selected body. `frame`: of the world that was built from `built`.
void add_support(ui::EditHistory& history, ui::EditorState& state, const Frame& frame, const Scene& built);
void add_load(ui::EditHistory& history, ui::EditorState& state, const Frame& frame, const Scene& built);
void add_probe(ui::EditHistory& history, ui::EditorState& state, const Frame& frame, const Scene& built);
/// Adds a shot of the projectile tool from the eye at the camera's target.
void add_projectile(ui::EditHistory& history, ui::EditorState& state, const render::Camera& camera);
/// Adds the last shot.
void keep_shot(ui::EditHistory& history, ui::EditorState& state);
/// Adds a camera with this view.
void add_camera(ui::EditHistory& history, ui::EditorState& state, const render::Camera& camera);
/// Sets the active camera to this view.
void set_camera(ui::EditHistory& history, const ui::EditorState& state, const render::Camera& camera);

void duplicate_entries(ui::EditHistory& history, ui::EditorState& state, const Frame& frame);
void remove_entries(ui::EditHistory& history, ui::EditorState& state);
/// Moves the selected entries in their lists, up (-1) or down (1).
void move_entries(ui::EditHistory& history, ui::EditorState& state, int way);
void begin_renaming(ui::EditorState& state, const Scene& scene);
/// Hides the selected bodies, or shows them if all are hidden.
void toggle_hidden(ui::EditorState& state, const Scene& scene);

}  // namespace griffith::app
