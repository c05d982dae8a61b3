#pragma once

#include <vector>

#include "ui/model/edit_history.h"
#include "ui/model/editor_state.h"

namespace griffith::ui {

/// Returns the materials that bodies can be given: the scene's own, then the presets of other names.
std::vector<Material> offered_materials(const Scene& scene);

/// Returns the bodies that get a material dropped on one of them: all selected ones if it is among them, else it alone.
std::vector<std::size_t> material_targets(const EditorState& state, const Scene& scene, std::size_t body);

/// Gives bodies a material, as one entry of the history.
void assign_material(EditHistory& history, const std::vector<std::size_t>& bodies, const Material& material);

}  // namespace griffith::ui
