#include <algorithm>
#include <array>
#include <functional>

#include "ui/model/units.h"
#include "ui/panels/body_rows.h"
#include "ui/panels/panels.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr std::size_t kMaxShown = 8;  ///< rows before the list scrolls

void choose(Panel& panel, const BodyRow& row) {
  panel.state.selected_body = row.scene_body;
  panel.state.selection = {};
  if (!row.piece.valid()) return;
  const Frame& frame = panel.input.frame;
  const auto tet = std::ranges::find(frame.elements.bodies, row.piece);
  if (tet == frame.elements.bodies.end()) return;
  const TetId first(tet - frame.elements.bodies.begin());
  panel.state.selection = select(frame, first, frame.elements.tets[first][0]);
}

bool is_chosen(const Panel& panel, const BodyRow& row) {
  if (!row.piece.valid()) return panel.state.selected_body == row.scene_body;
  const Selection& selection = panel.state.selection;
  return selection.valid() && panel.input.frame.elements.bodies[selection.tet] == row.piece;
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

/// As wide as its title, a number that is likely, and all that is in it.
float column_width(const Panel& panel, const char* title, float design_width, const std::vector<BodyRow>& rows,
                   const std::function<std::string(const BodyRow&)>& text) {
  constexpr std::size_t kMaxMeasured = 1000;
  const float arrow = ImGui::GetFontSize();
  float width = std::max(ImGui::CalcTextSize(title).x + arrow, design_width * ui_scale(panel));
  for (std::size_t i = 0; i < std::min(rows.size(), kMaxMeasured); ++i)
    width = std::max(width, ImGui::CalcTextSize(text(rows[i]).c_str()).x);
  return width;
}

void begin_columns(const Panel& panel, const std::vector<BodyRow>& rows) {
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch);
  const auto column = [&](const char* title, float design_width, const auto& text) {
    ImGui::TableSetupColumn(title, ImGuiTableColumnFlags_WidthFixed,
                            column_width(panel, title, design_width, rows, text));
  };
  column("State", 44, [](const BodyRow& row) { return std::string(row.state()); });
  column("Pcs", 30, [](const BodyRow& row) { return std::to_string(row.pieces()); });
  column("Tets", 38, [](const BodyRow& row) { return std::to_string(row.tets); });
  column("Mass", 50, [](const BodyRow& row) { return mass_text(row.mass); });
  ImGui::TableHeadersRow();
}

void draw_table(Panel& panel, std::vector<BodyRow> rows, std::size_t lines) {
  const float line = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const float height = line * static_cast<float>(lines + 1);
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_Sortable | ImGuiTableFlags_SortTristate | ImGuiTableFlags_ScrollY |
                                     ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings;
  if (!ImGui::BeginTable("##bodies", 5, kFlags, {0, height + 4 * ui_scale(panel)})) return;
  begin_columns(panel, rows);
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
  ImGui::InputTextWithHint("##filter", "name or state", text.data(), text.size());
  tag_last_item(panel.tags, "bodies/filter", text.data());
  tooltip("Lists what has this in its name or is so: elastic, rigid or asleep.");
}

}  // namespace

void draw_bodies_panel(Panel& panel) {
  heading(panel, "Bodies");
  const Scene& scene = panel.history.scene();
  const Frame& frame = panel.input.frame;
  if (scene.bodies.empty())
    return hint(panel,
                "The scene has no bodies. The menu Add makes one; File > Open opens a scene, and so does dropping its "
                "file here.");
  filter_row(panel);
  const bool pieces = panel.state.list_pieces;
  std::vector<BodyRow> rows = pieces ? piece_rows(scene, frame) : body_rows(scene, frame);
  // What breaks and what the filter hides moves nothing below the list.
  const std::size_t lines = pieces ? kMaxShown : std::min(scene.bodies.size(), kMaxShown);
  filter_rows(rows, panel.state.body_filter.data());
  ImGui::PushFont(panel.input.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {3 * ui_scale(panel), 2 * ui_scale(panel)});
  draw_table(panel, std::move(rows), lines);
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

}  // namespace griffith::ui
