#include "ui/panels/outliner_row.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <initializer_list>

#include "ui/model/entry_choice.h"
#include "ui/model/units.h"
#include "ui/model/verdict.h"
#include "ui/panels/material_drag.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

void select_piece(Panel& panel, const OutlinerRow& row) {
  select_entries(panel.state, panel.history.scene(), {row.entry});
  const Frame& frame = panel.input.frame;
  const auto tet = std::ranges::find(frame.elements.bodies, row.body.piece);
  if (tet == frame.elements.bodies.end()) return;
  const TetId first(tet - frame.elements.bodies.begin());
  panel.state.selection = select(frame, first, frame.elements.tets[first][0]);
}

void begin_renaming(Panel& panel, const SceneEntry& entry) {
  if (has_name(entry.kind)) issue(panel, {.name = "edit.rename"});
}

}  // namespace

void select_row(Panel& panel, const std::vector<OutlinerRow>& rows, const OutlinerRow& row) {
  const Scene& scene = panel.history.scene();
  if (row.body.piece.valid()) return select_piece(panel, row);
  if (ImGui::GetIO().KeyCtrl) return toggle_entry(panel.state, scene, row.entry);
  if (!ImGui::GetIO().KeyShift) {
    // Two quick clicks are no double click if a second row took the place of the first.
    const bool again = selected_entries(panel.state, scene) == std::vector{row.entry};
    select_entries(panel.state, scene, {row.entry});
    if (again && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) begin_renaming(panel, row.entry);
    return;
  }
  std::vector<SceneEntry> listed;
  for (const OutlinerRow& other : rows) listed.push_back(other.entry);
  select_range(panel.state, scene, listed, row.entry);
}

bool is_chosen(const Panel& panel, const OutlinerRow& row) {
  if (!row.body.piece.valid())
    return std::ranges::count(selected_entries(panel.state, panel.history.scene()), row.entry) > 0;
  const Selection& selection = panel.state.selection;
  return selection.valid() && panel.input.frame.elements.bodies[selection.tet] == row.body.piece;
}

namespace {

ImU32 state_color(const BodyRow& row) {
  return row.elastic > 0 ? palette::kAccent : row.rigid > 0 ? palette::kText : palette::kTextDim;
}

void row_tooltip(const OutlinerRow& row) {
  if (row.entry.kind != EntryKind::body) return tooltip(row.name + (row.note.empty() ? "" : ": " + row.note));
  tooltip(
      row.name + ": " + std::to_string(row.body.tets) + " tetrahedra, " + mass_text(row.body.mass) + "; " +
      std::to_string(row.body.elastic) + " elastic, " + std::to_string(row.body.rigid) + " rigid, " +
      std::to_string(row.body.asleep) +
      " asleep.\nRigid: moves as a whole until an impact; asleep: at rest and not computed." +
      (row.body.broke_scaled ? "\nBroke at " + row.body.mark() + ". " + stand_in_text(*row.body.broke_scaled) : ""));
}

/// Draws the context menu of the selected entries.
void context_menu(Panel& panel, const OutlinerRow& row) {
  if (!ImGui::BeginPopupContextItem(nullptr)) return;
  if (ImGui::IsWindowAppearing() && !is_chosen(panel, row))
    select_entries(panel.state, panel.history.scene(), {row.entry});
  close_on_escape();
  const auto items = [&](std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) command_menu_item(panel, command_info(name, panel), "context/");
  };
  items({"edit.rename", "edit.duplicate", "edit.delete", "edit.move_up", "edit.move_down"});
  ImGui::Separator();
  if (row.entry.kind == EntryKind::camera) {
    items({"view.look_through", "view.set_camera"});
  } else if (row.entry.kind == EntryKind::body) {
    items({"view.hide", "edit.gizmo", "edit.scale"});
    if (ImGui::BeginMenu("Add")) {
      items({"add.support", "add.load", "add.probe"});
      ImGui::EndMenu();
    }
  } else {
    items({"edit.gizmo", "edit.scale"});
    if (row.entry.kind != EntryKind::projectile) items({"edit.paint"});
  }
  ImGui::EndPopup();
}

/// Draws the box in which the entry's name is typed; Enter accepts it, Escape cancels.
void name_box(Panel& panel, const OutlinerRow& row) {
  EditorState& state = panel.state;
  const std::string tag = row.tag + "/name";
  ImGui::SetNextItemWidth(-FLT_MIN);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {4 * ui_scale(panel), 0});  // as high as other rows
  if (ImGui::IsWindowAppearing() || !ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputText("##name", &state.new_name,
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  const bool left = ImGui::IsItemDeactivated();
  ImGui::PopStyleVar();
  tag_last_item(panel.tags, tag, state.new_name);
  field_tooltip(panel, tag, "Enter: rename, Escape: cancel.");
  if (!entered && !left) return;
  state.renamed.reset();
  if (ImGui::IsKeyPressed(key::kEscape, false)) return;
  const std::string name = state.new_name;
  std::string problem;
  panel.history.change("Rename " + row.name, [&](Scene& scene) { problem = rename_entry(scene, row.entry, name); });
  panel.history.finish();
  if (problem.empty() && row.entry.kind == EntryKind::body && state.hidden_bodies.erase(row.name) > 0)
    state.hidden_bodies.insert(name);
  if (!problem.empty()) state.field_note = {row.tag, problem};
}

Icon icon_of(EntryKind kind) {
  constexpr std::array kIcons = {Icon::body,       Icon::support, Icon::load,
                                 Icon::projectile, Icon::probe,   Icon::camera};  // by EntryKind
  return kIcons[static_cast<std::size_t>(kind)];
}

/// Draws icon and name on the last item, which spans all columns, and the note of an entry that is no body.
void draw_name(const Panel& panel, const OutlinerRow& row, float width, bool hidden) {
  const float scale = ui_scale(panel), line = ImGui::GetTextLineHeight();
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImVec2 start = {low.x + (is_part_of_body(row.entry.kind) ? 16 : 4) * scale, (low.y + high.y - line) / 2};
  ImDrawList* list = ImGui::GetWindowDrawList();
  const bool is_body = row.entry.kind == EntryKind::body;
  const std::string mark = row.body.mark();
  const float gap = 8 * scale, marked = mark.empty() ? 0 : ImGui::CalcTextSize(mark.c_str()).x + gap;
  const float room = is_body ? start.x - low.x + line + 4 * scale + marked : 0;
  if (!is_body) list->PushClipRect(low, high);
  draw_icon(list, icon_of(row.entry.kind), {start.x + line / 2, (low.y + high.y) / 2}, 0.8f * line, palette::kTextDim);
  const std::string name = is_body ? fitted(row.name, width - room) : row.name;
  const ImVec2 place = {start.x + line + 4 * scale, start.y};
  list->AddText(place, hidden ? palette::kTextDim : palette::kText, name.c_str());
  const float end = place.x + ImGui::CalcTextSize(name.c_str()).x + gap;
  list->AddText({end, start.y}, is_body ? palette::kWarning : palette::kTextDim, (is_body ? mark : row.note).c_str());
  if (!is_body) list->PopClipRect();
}

void text_cell(ImU32 color, const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::TextColored(as_vec4(color), "%s", text.c_str());
}

/// Draws an icon in the last column that acts on the row's entry. True if it was clicked; then the entry is the active
/// one.
bool icon_cell(Panel& panel, const OutlinerRow& row, Icon icon, const std::string& tag, const std::string& value) {
  constexpr int kLastColumn = 5;
  ImGui::TableSetColumnIndex(kLastColumn);
  const float size = ImGui::GetTextLineHeight();
  const bool clicked = ImGui::InvisibleButton(tag.c_str(), {size, size});
  tag_last_item(panel.tags, tag, value);
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImU32 color = ImGui::IsItemHovered() ? palette::kText : palette::kTextDim;
  draw_icon(ImGui::GetWindowDrawList(), icon, {low.x + size / 2, low.y + size / 2}, 0.9f * size, color);
  if (clicked) select_entries(panel.state, panel.history.scene(), {row.entry});
  return clicked;
}

/// Draws the eye icon of a body: shown or hidden.
void eye_cell(Panel& panel, const OutlinerRow& row, bool hidden) {
  const Icon icon = hidden ? Icon::closed_eye : Icon::eye;
  if (icon_cell(panel, row, icon, row.tag + "/eye", hidden ? "hidden" : "shown")) issue(panel, {.name = "view.hide"});
  tooltip(hidden ? "Hidden. Click to show it." : "Shown. Click to hide it; it is still simulated.");
}

void camera_cell(Panel& panel, const OutlinerRow& row) {
  if (icon_cell(panel, row, Icon::frame, row.tag + "/look", "")) issue(panel, {.name = "view.look_through"});
  tooltip("Look through this camera.");
}

void body_cells(Panel& panel, const OutlinerRow& row, bool hidden) {
  text_cell(state_color(row.body), std::string(row.body.state()));
  if (row.body.pieces() > 0) tag_last_item(panel.tags, row.tag + "/state", std::string(row.body.state()));
  if (row.body.broke_scaled) tag_last_item(panel.tags, row.tag + "/broke_scaled", row.body.mark());
  text_cell(row.body.pieces() > 1 ? palette::kAccent : palette::kTextDim, std::to_string(row.body.pieces()));
  text_cell(palette::kTextDim, std::to_string(row.body.tets));
  text_cell(palette::kTextDim, mass_text(row.body.mass));
  if (!row.body.piece.valid()) eye_cell(panel, row, hidden);
}

/// Draws a bar at the left end of a selected row, brightest in the active one.
void mark_chosen(const Panel& panel, const OutlinerRow& row) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const bool active = row.body.piece.valid() || active_entry(panel.state, panel.history.scene()) == row.entry;
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + 3 * ui_scale(panel), high.y},
                                            active ? palette::kAccent : palette::kAccentDim);
}

}  // namespace

void draw_outliner_row(Panel& panel, const std::vector<OutlinerRow>& rows, const OutlinerRow& row) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (panel.state.renamed == row.entry && !row.body.piece.valid()) return name_box(panel, row);
  const bool is_body = row.entry.kind == EntryKind::body;
  const bool hidden = is_body && panel.state.hidden_bodies.contains(row.name);
  const float width = ImGui::GetContentRegionAvail().x;
  constexpr ImGuiSelectableFlags kFlags = ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap |
                                          ImGuiSelectableFlags_AllowDoubleClick;
  const bool chosen = is_chosen(panel, row);
  if (ImGui::Selectable(("###" + row.tag).c_str(), chosen, kFlags)) select_row(panel, rows, row);
  tag_last_item(panel.tags, row.tag, row.name);
  const std::optional<int> body = body_of(panel.history.scene(), row.entry);
  if (is_body && body) drop_material(panel, static_cast<std::size_t>(*body));
  if (chosen) mark_chosen(panel, row);
  draw_name(panel, row, width, hidden);
  if (panel.state.field_note.tag == row.tag) {
    field_tooltip(panel, row.tag, "");
  } else {
    row_tooltip(row);
  }
  if (!row.body.piece.valid()) context_menu(panel, row);
  if (is_body) body_cells(panel, row, hidden);
  if (row.entry.kind == EntryKind::camera) camera_cell(panel, row);
}

std::string mass_text(double mass) {
  constexpr double kTonne = 1000, kGram = 1e-3;
  if (mass >= 10 * kTonne) return format_quantity(mass / kTonne, "t", 3);
  return mass >= 1 ? format_quantity(mass, "kg", 3) : format_quantity(mass / kGram, "g", 3);
}

}  // namespace griffith::ui
