#include <algorithm>
#include <array>

#include "ui/body_rows.h"
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/units.h"
#include "ui/widgets.h"

namespace griffith::ui {
namespace {

constexpr std::size_t kMostShown = 8;  ///< rows before the list scrolls
constexpr std::size_t kFewBodies = 6;  ///< so many need no filter

void choose(Panel& panel, const BodyRow& row) {
  panel.state.selected_body = row.scene_body;
  panel.state.selection = {};
  if (!row.piece.valid()) return;
  const Frame& frame = panel.input.frame;
  const auto tet = std::ranges::find(frame.tet_bodies, row.piece);
  if (tet == frame.tet_bodies.end()) return;
  const TetId first(tet - frame.tet_bodies.begin());
  panel.state.selection = select(frame, first, frame.tets[first][0]);
}

bool is_chosen(const Panel& panel, const BodyRow& row) {
  if (!row.piece.valid()) return panel.state.selected_body == row.scene_body;
  const Selection& selection = panel.state.selection;
  return selection.valid() && panel.input.frame.tet_bodies[selection.tet] == row.piece;
}

ImU32 state_color(const BodyRow& row) {
  return row.elastic > 0 ? palette::kAccent : row.rigid > 0 ? palette::kText : palette::kTextDim;
}

void state_tooltip(const BodyRow& row) {
  tooltip(row.name + ": " + std::to_string(row.elastic) + " elastic, " + std::to_string(row.rigid) + " rigid, " +
          std::to_string(row.asleep) +
          " asleep.\nRigid: moves as a whole until something strikes it; asleep: lies still and costs nothing.");
}

void text_cell(ImU32 color, const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::TextColored(as_vec4(color), "%s", text.c_str());
}

std::string mass_text(double mass) {
  constexpr double kTonne = 1000, kGram = 1e-3;
  if (mass >= 10 * kTonne) return format_quantity(mass / kTonne, "t", 3);
  return mass >= 1 ? format_quantity(mass, "kg", 3) : format_quantity(mass / kGram, "g", 3);
}

void draw_row(Panel& panel, const BodyRow& row, std::size_t place) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string tag = "bodies/" + std::to_string(row.piece.valid() ? static_cast<int>(place) : row.scene_body);
  const std::string name = fitted(row.name, ImGui::GetContentRegionAvail().x);
  if (ImGui::Selectable((name + "###" + tag).c_str(), is_chosen(panel, row), ImGuiSelectableFlags_SpanAllColumns))
    choose(panel, row);
  tag_last_item(panel.tags, tag, row.name);
  state_tooltip(row);
  text_cell(state_color(row), std::string(row.state()));
  if (row.pieces() > 0) tag_last_item(panel.tags, tag + "/state", std::string(row.state()));
  text_cell(row.pieces() > 1 ? palette::kAccent : palette::kTextDim, std::to_string(row.pieces()));
  text_cell(palette::kTextDim, std::to_string(row.tets));
  text_cell(palette::kTextDim, mass_text(row.mass));
}

void apply_sorting(std::vector<BodyRow>& rows) {
  const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  if (!specs || specs->SpecsCount == 0) return;
  const ImGuiTableColumnSortSpecs& first = specs->Specs[0];
  sort_rows(rows, static_cast<BodyColumn>(first.ColumnIndex), first.SortDirection == ImGuiSortDirection_Descending);
}

void begin_columns(const Panel& panel) {
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch);
  constexpr std::array<std::pair<const char*, float>, 4> kColumns = {
      {{"State", 44}, {"Pcs", 34}, {"Tets", 38}, {"Mass", 50}}};
  for (const auto& [name, width] : kColumns)
    ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed, width * ui_scale(panel));
  ImGui::TableHeadersRow();
}

void draw_table(Panel& panel, std::vector<BodyRow> rows) {
  const float line = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const float height = line * static_cast<float>(std::clamp<std::size_t>(rows.size(), 1, kMostShown) + 1);
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_Sortable | ImGuiTableFlags_SortTristate | ImGuiTableFlags_ScrollY |
                                     ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings;
  if (!ImGui::BeginTable("##bodies", 5, kFlags, {0, height + 4 * ui_scale(panel)})) return;
  begin_columns(panel);
  apply_sorting(rows);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_row(panel, rows[static_cast<std::size_t>(i)], static_cast<std::size_t>(i));
  ImGui::EndTable();
}

/// What the list is of, and which of them are shown.
void filter_row(Panel& panel) {
  checkbox(panel, "bodies/pieces", "Pieces", panel.state.list_pieces);
  tooltip("Lists each piece by itself. A click on one selects it in the view.");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-FLT_MIN);
  std::array<char, 64>& text = panel.state.body_filter;
  ImGui::InputTextWithHint("##filter", "filter: name, elastic, rigid, asleep", text.data(), text.size());
  tag_last_item(panel.tags, "bodies/filter", text.data());
}

}  // namespace

void draw_bodies_panel(Panel& panel) {
  heading(panel, "Bodies");
  const Scene& scene = panel.history.scene();
  const Frame& frame = panel.input.frame;
  if (scene.bodies.empty())
    return hint(panel, "The scene has no bodies. Open one with File > Open, or drop a scene file here.");
  if (std::max(scene.bodies.size(), frame.bodies.size()) > kFewBodies || panel.state.list_pieces) filter_row(panel);
  std::vector<BodyRow> rows = panel.state.list_pieces ? piece_rows(scene, frame) : body_rows(scene, frame);
  filter_rows(rows, panel.state.body_filter.data());
  ImGui::PushFont(panel.input.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {3 * ui_scale(panel), 2 * ui_scale(panel)});
  draw_table(panel, std::move(rows));
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

}  // namespace griffith::ui
