#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "sim/fracture/fracture_law.h"
#include "sim/world/output/scaled_breaks.h"
#include "ui/model/entry_choice.h"
#include "ui/model/material_choice.h"
#include "ui/model/verdict.h"
#include "ui/panels/panels.h"
#include "ui/widgets/field_range.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/style.h"

namespace griffith::ui {
namespace {

constexpr std::array<std::string_view, 2> kElementModels = {"corotational", "Green's strain"};

/// Puts the edited material into the scene as a part of the edit `label`.
void keep(Panel& panel, const Edit& edit, const std::string& label, const Material& material) {
  const auto body = static_cast<std::size_t>(panel.state.selected_body);
  if (edit.changed) panel.history.change(label, [&](Scene& scene) { scene.bodies[body].material = material; });
  if (edit.finished) panel.history.finish();
}

/// Returns the material of that name: one of the scene's own, else a preset. Null if there is none.
const Material* original_of(const Scene& scene, const Material& material) {
  if (const auto own = std::ranges::find(scene.materials, material.name, &Material::name); own != scene.materials.end())
    return &*own;
  for (const MaterialPreset& preset : material_presets())
    if (preset.material.name == material.name) return &preset.material;
  return nullptr;
}

/// A property of the material.
struct Row {
  const char* name;  ///< key in scene files
  const char* label;
  const char* tooltip = "";
  double usual = 0;  ///< magnitude in usual materials, for properties that may be 0 and are no ratio
  double minimum = -std::numeric_limits<double>::infinity();  ///< narrows the range of scene files
  double maximum = std::numeric_limits<double>::infinity();   ///< narrows the range of scene files
};

void number_row(Panel& panel, Material& material, const Row& row, double& value,
                std::optional<double> original = std::nullopt) {
  Numbers range = range_of<Material>(row.name);
  range.minimum = std::max(range.minimum, row.minimum);
  range.maximum = std::min(range.maximum, row.maximum);
  const NumberField field = {.tag = std::string("material/") + row.name,
                             .label = row.label,
                             .numbers = range,
                             .tooltip = row.tooltip,
                             .original = original,
                             .usual = row.usual};
  const Edit edit = number_field_row(panel, field, value);
  keep(panel, edit, std::string("Set ") + row.label, material);
}

void number_row(Panel& panel, Material& material, const Row& row, double Material::*member) {
  const Material* original = original_of(panel.history.scene(), material);
  number_row(panel, material, row, material.*member, original ? std::optional(original->*member) : std::nullopt);
}

/// Returns the preset's name: "brick", or "brick (edited)" if its values differ.
std::string preset_text(const Scene& scene, const Material& material) {
  const Material* original = original_of(scene, material);
  return material.name + (original && *original != material ? " (edited)" : "");
}

/// Returns the source of a preset's numbers.
std::string source_text(const Material& material) {
  for (const MaterialPreset& preset : material_presets())
    if (preset.material.name == material.name) return "Values of the preset: " + std::string(preset.source);
  return "";
}

/// Draws the list of presets and the scene's own materials.
void preset_row(Panel& panel, Material& material) {
  const Scene& scene = panel.history.scene();
  const std::vector<Material> offered = offered_materials(scene);
  std::vector<std::string> names;
  for (const Material& one : offered) names.push_back(one.name);
  const int chosen = combo_row(panel, "material/preset", "Preset", names, preset_text(scene, material));
  field_tooltip(panel, "material/preset", source_text(material));
  const std::size_t selected = selected_bodies(panel.state, scene).size();
  if (selected > 1) hint(panel, "A preset goes to all " + std::to_string(selected) + " selected bodies.");
  if (chosen < 0) return;
  material = offered[static_cast<std::size_t>(chosen)];
  const auto shown = static_cast<std::size_t>(panel.state.selected_body);
  assign_material(panel.history, material_targets(panel.state, scene, shown), material);
}

/// Saves the body's material as one of the scene's own under that name, replacing an earlier one.
void keep_as(Panel& panel, Material material, const std::string& name) {
  const auto has_name = [&](const MaterialPreset& preset) {
    return preset.key == name || preset.material.name == name;
  };
  if (std::ranges::any_of(material_presets(), has_name)) {
    panel.state.field_note = {"material/keep_as", "\"" + name + "\" is a built-in preset; choose another name."};
    return;
  }
  material.name = name;
  const auto body = static_cast<std::size_t>(panel.state.selected_body);
  panel.history.change("Save material " + name, [&](Scene& scene) {
    scene.bodies[body].material = material;
    const auto own = std::ranges::find(scene.materials, name, &Material::name);
    if (own == scene.materials.end()) {
      scene.materials.push_back(material);
    } else {
      *own = material;
    }
  });
  panel.history.finish();
}

/// Draws the scene's own materials: under a name, other bodies can use the material too.
void library_rows(Panel& panel, const Material& material) {
  const Scene& scene = panel.history.scene();
  std::array<char, 64> name = {};
  row_label(panel, "Save as");
  const bool entered = ImGui::InputTextWithHint("##material/keep_as", "name, then Enter", name.data(), name.size(),
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  tag_last_item(panel.tags, "material/keep_as", "");
  field_tooltip(panel, "material/keep_as",
                "Saves the material in the scene under this name, so that other bodies can use it.");
  if (entered && name[0] != 0) keep_as(panel, material, name.data());
  if (std::ranges::find(scene.materials, material.name, &Material::name) == scene.materials.end()) return;
  if (!text_button(panel, "material/forget", ("Delete preset " + material.name).c_str())) return;
  panel.history.change("Delete preset " + material.name, [&](Scene& changed) {
    std::erase_if(changed.materials, [&](const Material& own) { return own.name == material.name; });
  });
  panel.history.finish();
}

void criterion_row(Panel& panel, Material& material) {
  std::vector<std::string> names;
  std::string meanings;
  for (const FractureLaw& law : fracture_laws()) {
    names.emplace_back(law.label);
    meanings += (meanings.empty() ? "" : "\n") + names.back() + ": " + std::string(law.meaning);
  }
  const int chosen = combo_row(panel, "material/criterion", "Criterion", names, fracture_law(material).label);
  field_tooltip(panel, "material/criterion", meanings);
  if (chosen < 0) return;
  adopt(fracture_laws()[static_cast<std::size_t>(chosen)], material);
  keep(panel, {true, true}, "Set criterion", material);
}

void fracture_rows(Panel& panel, Material& material) {
  criterion_row(panel, material);
  if (fracture_law(material).resistance == &Material::separation_toughness) {
    number_row(panel, material,
               {"separation_toughness", "Toughness τ",
                "Separation toughness: a node separates when the largest eigenvalue of its separation tensor exceeds "
                "it. Depends on the "
                "element size."},
               &Material::separation_toughness);
    return;
  }
  number_row(panel, material,
             {"tensile_strength", "Tensile strength",
              "A node separates when its mesh-independent separation stress exceeds it.", 0, 0,
              material.compressive_strength.value_or(std::numeric_limits<double>::infinity())},
             &Material::tensile_strength);
  if (material.compressive_strength)
    number_row(panel, material,
               {"compressive_strength", "Compression σ_c",
                "Compressive strength: the pressure at which a free bar fails.", 0, material.tensile_strength},
               *material.compressive_strength);
  number_row(panel, material,
             {"fracture_toughness", "Toughness K_Ic",
              "Lowers the resistance at a crack front: with small values, a crack runs once it has started."},
             &Material::fracture_toughness);
}

void element_model_row(Panel& panel, Material& material) {
  const std::vector<std::string> names(kElementModels.begin(), kElementModels.end());
  const bool green = material.element_model == ElementModel::green_strain;
  const int chosen = combo_row(panel, "material/element_model", "Strain measure", names, kElementModels[green]);
  if (chosen < 0) return;
  material.element_model = static_cast<ElementModel>(chosen);
  keep(panel, {true, true}, "Set strain measure", material);
}

void yield_rows(Panel& panel, Material& material) {
  bool yields = material.yield_strength.has_value();
  if (checkbox(panel, "material/yields", "Yields before it breaks", yields)) {
    material.yield_strength = yields ? std::optional(material.tensile_strength) : std::nullopt;
    keep(panel, {true, true}, "Set yielding", material);
  }
  if (!material.yield_strength) return;
  number_row(panel, material, {"yield_strength", "Yield strength", "The von Mises stress above which it flows."},
             *material.yield_strength);
  number_row(panel, material, {"plastic_limit", "Plastic limit", "The norm of the plastic strain at which flow ends."},
             &Material::plastic_limit);
}

void damping_rows(Panel& panel, Material& material) {
  number_row(panel, material, {"friction", "Friction"}, &Material::friction);
  number_row(panel, material, {"restitution", "Restitution"}, &Material::restitution);
  number_row(panel, material,
             {"stiffness_damping", "Damping β", "Rayleigh coefficient β: damps fast vibrations.", 1e-4},
             &Material::stiffness_damping);
  number_row(panel, material, {"mass_damping", "Damping α", "Rayleigh coefficient α: damps all motion."},
             &Material::mass_damping);
}

/// Warns that the shown values are not those that broke.
void scaled_row(Panel& panel) {
  for (const ScaledBreak& broken : scaled_breaks(panel.input.frame)) {
    if (broken.scene_body != panel.state.selected_body) continue;
    value_row(panel, "Broke at", scale_text(broken.least), palette::kWarning);
    tag_last_item(panel.tags, "material/broke_scaled", scale_text(broken.least));
    tooltip(stand_in_text(broken.least));
  }
}

}  // namespace

void draw_material_panel(Panel& panel) {
  const std::vector<BodyDescription>& bodies = panel.history.scene().bodies;
  if (bodies.empty()) return;
  panel.state.selected_body = std::clamp(panel.state.selected_body, 0, static_cast<int>(bodies.size()) - 1);
  const BodyDescription& body = bodies[static_cast<std::size_t>(panel.state.selected_body)];
  heading(panel, ("Material of " + body.name).c_str());
  Material material = body.material;
  preset_row(panel, material);
  scaled_row(panel);
  number_row(
      panel, material,
      {"young_modulus", "Young's modulus", "E: stiffness. Drag it, or click and type a value: 20, 20 GPa, 2*10 GPa."},
      &Material::young_modulus);
  number_row(panel, material,
             {"poisson_ratio", "Poisson's ratio",
              "ν: lateral contraction over extension; below 0.5, the limit of incompressible materials."},
             &Material::poisson_ratio);
  number_row(panel, material, {"density", "Density", "ρ"}, &Material::density);
  fracture_rows(panel, material);
  element_model_row(panel, material);
  yield_rows(panel, material);
  open_if_sought(panel, "material/contact");
  if (ImGui::TreeNodeEx("Contact and damping", ImGuiTreeNodeFlags_SpanAvailWidth)) {
    damping_rows(panel, material);
    ImGui::TreePop();
  }
  library_rows(panel, material);
}

}  // namespace griffith::ui
