#include "ui/model/material_choice.h"

#include <algorithm>

#include "ui/model/entry_choice.h"

namespace griffith::ui {

std::vector<Material> offered_materials(const Scene& scene) {
  std::vector<Material> offered = scene.materials;
  for (const MaterialPreset& preset : material_presets())
    if (std::ranges::find(scene.materials, preset.material.name, &Material::name) == scene.materials.end())
      offered.push_back(preset.material);
  return offered;
}

std::vector<std::size_t> material_targets(const EditorState& state, const Scene& scene, std::size_t body) {
  std::vector<std::size_t> selected = selected_body_indices(state, scene);
  const bool is_selected = std::ranges::find(selected, body) != selected.end();
  return is_selected ? selected : std::vector{body};
}

void assign_material(EditHistory& history, const std::vector<std::size_t>& bodies, const Material& material) {
  history.change("Set material " + material.name, [&](Scene& scene) {
    for (const std::size_t body : bodies) scene.bodies[body].material = material;
  });
  history.finish();
}

}  // namespace griffith::ui
