#include <array>
#include <string>
#include <utility>

#include "ui/model/entry_choice.h"
#include "ui/model/material_choice.h"
#include "ui/model/surface_hit.h"
#include "ui/model/units.h"
#include "ui/panels/material_drag.h"
#include "ui/panels/overlays.h"
#include "ui/panels/panels.h"
#include "ui/panels/view_drawing.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr char kPayload[] = "material";

/// Returns the body of the scene below the mouse in the view.
std::optional<std::size_t> pointed_body(const Panel& panel) {
  if (!panel.state.pointed_at || !panel.input.pointed.valid()) return std::nullopt;
  const auto body = static_cast<std::size_t>(panel.input.frame.bodies[panel.input.pointed].scene_body);
  return body < panel.history.scene().bodies.size() ? std::optional(body) : std::nullopt;
}

/// Returns how many bodies get the material besides the named one: "wall and 2 more".
std::string names_of(const Scene& scene, const std::vector<std::size_t>& bodies) {
  const std::string first = scene.bodies[bodies.back()].name;
  return bodies.size() == 1 ? first : first + " and " + std::to_string(bodies.size() - 1) + " more";
}

void draw_row(Panel& panel, const Material& material) {
  const std::string tag = "materials/" + material.name;
  if (ImGui::Selectable(("###" + tag).c_str()))
    assign_material(panel.history, selected_body_indices(panel.state, panel.history.scene()), material);
  tag_last_item(panel.tags, tag, material.name);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  drag_material(panel, material);
  tooltip("Click: give it to the selected bodies.\nDrag: give it to a body in the view or the outliner.");
  const std::string note =
      format_quantity(material.young_modulus, "Pa", 3) + ", " + format_quantity(material.density, "kg/m³", 4);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddText({low.x + 4 * ui_scale(panel), low.y}, palette::kText, material.name.c_str());
  list->AddText({high.x - ImGui::CalcTextSize(note.c_str()).x, low.y}, palette::kTextDim, note.c_str());
}

/// Fills the faces of bodies that are toward the eye.
void tint(const Panel& panel, const std::vector<std::size_t>& bodies) {
  constexpr ImU32 kTint = IM_COL32(255, 214, 92, 90);
  const Frame& frame = panel.input.frame;
  const ViewCamera camera = view_camera(panel);
  std::vector<bool> is_tinted(panel.history.scene().bodies.size(), false);
  for (const std::size_t body : bodies) is_tinted[body] = true;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImDrawListFlags flags = std::exchange(list->Flags, ImDrawListFlags_None);  // smooth edges would show as lines
  for_each_surface_face(frame, [&](std::size_t tet, const std::array<NodeId, 3>& corners) {
    if (!is_tinted[static_cast<std::size_t>(frame.bodies[frame.elements.bodies[TetId(tet)]].scene_body)]) return;
    std::array<ImVec2, 3> pixels;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::optional<Vec2> pixel = camera.pixel(frame.nodes.positions[corners[i]]);
      if (!pixel) return;
      pixels[i] = on_screen(panel, *pixel);
    }
    const auto& [a, b, c] = pixels;
    const bool is_toward_eye = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) < 0;  // pixels count downward
    if (is_toward_eye) list->AddTriangleFilled(a, b, c, kTint);
  });
  list->Flags = flags;
}

}  // namespace

void drag_material(Panel& panel, const Material& material) {
  if (!ImGui::BeginDragDropSource()) return;
  panel.state.dragged_material = material;
  ImGui::SetDragDropPayload(kPayload, nullptr, 0);
  const std::optional<std::size_t> body = pointed_body(panel);
  const Scene& scene = panel.history.scene();
  const std::string onto = body ? " onto " + names_of(scene, material_targets(panel.state, scene, *body)) : "";
  const std::string text = material.name + onto;
  ImGui::TextUnformatted(text.c_str());
  tag_last_item(panel.tags, "materials/dragged", text);
  ImGui::EndDragDropSource();
}

void drop_material(Panel& panel, std::optional<std::size_t> body, bool outlined) {
  if (!panel.state.dragged_material || !body || !ImGui::BeginDragDropTarget()) return;
  const ImGuiDragDropFlags flags = outlined ? ImGuiDragDropFlags_None : ImGuiDragDropFlags_AcceptNoDrawDefaultRect;
  if (ImGui::AcceptDragDropPayload(kPayload, flags))
    assign_material(panel.history, material_targets(panel.state, panel.history.scene(), *body),
                    *panel.state.dragged_material);
  ImGui::EndDragDropTarget();
}

void drop_material_on_view(Panel& panel) { drop_material(panel, pointed_body(panel), false); }

void draw_material_target(Panel& panel) {
  if (!panel.state.dragged_material) return;
  if (!ImGui::GetDragDropPayload()) panel.state.dragged_material.reset();
  const std::optional<std::size_t> body = pointed_body(panel);
  if (panel.state.dragged_material && body) tint(panel, material_targets(panel.state, panel.history.scene(), *body));
}

void draw_material_list(Panel& panel) {
  open_if_sought(panel, "materials");
  const bool open = ImGui::CollapsingHeader("Materials###materials");
  tag_last_item(panel.tags, "materials", open ? "open" : "closed");
  if (!open) return;
  hint(panel, "Drag one onto a body, in the view or the outliner.");
  for (const Material& material : offered_materials(panel.history.scene())) draw_row(panel, material);
}

}  // namespace griffith::ui
