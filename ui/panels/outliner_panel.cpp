#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "ui/model/entry_choice.h"
#include "ui/panels/outliner_row.h"
#include "ui/panels/panels.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

float line_height() { return ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y; }

/// Returns the number of rows before the list scrolls: a quarter of the window.
std::size_t max_shown() {
  constexpr std::size_t kAtLeast = 10;
  return std::max(kAtLeast, static_cast<std::size_t>(0.25f * ImGui::GetIO().DisplaySize.y / line_height()));
}

void apply_sorting(std::vector<BodyRow>& rows) {
  const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  if (!specs || specs->SpecsCount == 0) return;
  const ImGuiTableColumnSortSpecs& first = specs->Specs[0];
  sort_rows(rows, static_cast<BodyColumn>(first.ColumnIndex), first.SortDirection == ImGuiSortDirection_Descending);
}

/// A column of numbers next to the names.
struct NumberColumn {
  const char* title;
  float min_width;  ///< design pixels
  std::string (*text)(const BodyRow& row);
};

constexpr std::array<NumberColumn, 4> kNumberColumns = {{
    {"State", 40, [](const BodyRow& row) { return std::string(row.state()); }},
    {"Pieces", 26, [](const BodyRow& row) { return std::to_string(row.pieces()); }},
    {"Tets", 34, [](const BodyRow& row) { return std::to_string(row.tets); }},
    {"Mass", 46, [](const BodyRow& row) { return mass_text(row.mass); }},
}};

/// Returns the width of the widest of these texts, in the first thousand rows.
template <class Text>
float widest(const std::vector<BodyRow>& rows, Text text) {
  constexpr std::size_t kMaxMeasured = 1000;
  float width = 0;
  for (std::size_t i = 0; i < std::min(rows.size(), kMaxMeasured); ++i)
    width = std::max(width, ImGui::CalcTextSize(text(rows[i]).c_str()).x);
  return width;
}

/// Begins the columns, names first: columns at the end are left out if there is no room for all.
void begin_columns(const Panel& panel, const std::vector<BodyRow>& rows) {
  const float scale = ui_scale(panel), line = ImGui::GetTextLineHeight(), arrow = ImGui::GetFontSize();
  const float gap = 2 * ImGui::GetStyle().CellPadding.x;
  const float name = line + 8 * scale + widest(rows, [](const BodyRow& row) { return row.name + "  " + row.mark(); });
  float room = ImGui::GetContentRegionAvail().x - std::min(name, 130 * scale) - line - 2 * gap;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch);
  for (const NumberColumn& column : kNumberColumns) {
    const float width =
        std::max({ImGui::CalcTextSize(column.title).x + arrow, column.min_width * scale, widest(rows, column.text)});
    room -= width + gap;
    ImGui::TableSetupColumn(
        column.title,
        ImGuiTableColumnFlags_WidthFixed | (room < 0 ? ImGuiTableColumnFlags_Disabled : ImGuiTableColumnFlags_None),
        width);
  }
  ImGui::TableSetupColumn("##eye", ImGuiTableColumnFlags_WidthFixed | ImGuiTableColumnFlags_NoSort, line);
  ImGui::TableHeadersRow();
}

std::vector<OutlinerRow> shown_rows(const Panel& panel, std::vector<BodyRow> bodies) {
  const std::string_view filter = panel.state.body_filter.data();
  if (panel.state.list_pieces) return outliner_piece_rows(std::move(bodies), filter);
  return outliner_rows(panel.history.scene(), bodies, filter);
}

using Rows = std::vector<OutlinerRow>;

void scroll_to(Rows::difference_type row, float line) {
  const float top = line * static_cast<float>(row), room = ImGui::GetWindowHeight() - line;
  if (top < ImGui::GetScrollY() || top + line > ImGui::GetScrollY() + room) ImGui::SetScrollY(top - room / 2);
}

/// Scrolls to the active entry if it was selected elsewhere: in the view, by an edit, to be renamed.
void follow_active(Panel& panel, const Rows& rows, float line) {
  const std::optional<SceneEntry> active = active_entry(panel.state, panel.history.scene());
  if (std::exchange(panel.state.listed_entry, active) == active || panel.state.list_pieces) return;
  const auto row = std::ranges::find(rows, active, [](const OutlinerRow& other) { return std::optional(other.entry); });
  if (row != rows.end()) scroll_to(row - rows.begin(), line);
}

/// Returns the row from which the arrow keys move: the active one, or the other end of a range selected with Shift.
Rows::const_iterator row_of_keys(const Panel& panel, const Rows& rows) {
  if (panel.state.list_pieces)
    return std::ranges::find_if(rows, [&](const OutlinerRow& row) { return is_chosen(panel, row); });
  const std::vector<SceneEntry> chosen = selected_entries(panel.state, panel.history.scene());
  if (chosen.empty()) return rows.end();
  return std::ranges::find(rows, ImGui::GetIO().KeyShift ? chosen.front() : chosen.back(), &OutlinerRow::entry);
}

/// Moves the selection with Up and Down, extends it with Shift, while the list has the focus.
void choose_by_keys(Panel& panel, const Rows& rows, float line) {
  const int direction = ImGui::IsKeyPressed(key::kDown) - ImGui::IsKeyPressed(key::kUp);
  const ImGuiIO& io = ImGui::GetIO();
  if (direction == 0 || rows.empty() || !ImGui::IsWindowFocused() || io.WantTextInput || io.KeyCtrl) return;
  const auto now = row_of_keys(panel, rows);
  const auto last = std::ssize(rows) - 1;
  const auto next = now == rows.end() ? 0 : std::clamp<Rows::difference_type>(now - rows.begin() + direction, 0, last);
  select_row(panel, rows, rows[static_cast<std::size_t>(next)]);
  scroll_to(next, line);
}

void draw_table(Panel& panel, std::vector<BodyRow> bodies, std::size_t lines) {
  const float line = line_height(), height = line * static_cast<float>(lines + 1);
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_Sortable | ImGuiTableFlags_SortTristate | ImGuiTableFlags_ScrollY |
                                     ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings;
  if (!ImGui::BeginTable("##outliner", 6, kFlags, {0, height + 4 * ui_scale(panel)})) return;
  begin_columns(panel, bodies);
  apply_sorting(bodies);
  const Rows rows = shown_rows(panel, std::move(bodies));
  choose_by_keys(panel, rows, line);
  follow_active(panel, rows, line);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_outliner_row(panel, rows, rows[static_cast<std::size_t>(i)]);
  ImGui::EndTable();
}

void add_button(Panel& panel, float width) {
  if (text_button(panel, "outliner/add", "Add", width)) ImGui::OpenPopup("##add");
  tooltip("Add a body, a support, load or probe of the selected body, a projectile or a camera.");
  if (!ImGui::BeginPopup("##add")) return;
  close_on_escape();
  for (const CommandInfo& info : panel.input.commands)
    if (info.menu == Menu::add) command_menu_item(panel, info, "outliner/");
  ImGui::EndPopup();
}

/// Draws the choice between bodies and pieces, and the filter.
void filter_row(Panel& panel) {
  checkbox(panel, "bodies/pieces", "Pieces", panel.state.list_pieces);
  tooltip("List each piece separately. Click one to select it in the view.");
  ImGui::SameLine();
  const float button = 48 * ui_scale(panel);
  ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x);
  std::array<char, 64>& text = panel.state.body_filter;
  ImGui::InputTextWithHint("##filter", "name or state", text.data(), text.size());
  tag_last_item(panel.tags, "bodies/filter", text.data());
  tooltip(
      "Filter by name, state (elastic, rigid, asleep) or kind (fixed, pressure, ...); E/ finds bodies that broke "
      "scaled");
  ImGui::SameLine();
  add_button(panel, button);
}

}  // namespace

void draw_outliner_panel(Panel& panel) {
  heading(panel, "Outliner");
  const Scene& scene = panel.history.scene();
  const Frame& frame = panel.input.frame;
  filter_row(panel);
  const std::size_t entries = scene_entries(scene).size();
  if (entries == 0)
    return hint(panel,
                "The scene is empty. Add a body, or open a scene with File > Open or by dropping its file here.");
  const bool pieces = panel.state.list_pieces;
  ImGui::PushFont(panel.input.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {3 * ui_scale(panel), 2 * ui_scale(panel)});
  ImGui::PushStyleColor(ImGuiCol_Header, palette::kFieldActive);
  // Fracture and the filter must not move anything below the list.
  const std::size_t lines = pieces ? max_shown() : std::min(entries, max_shown());
  draw_table(panel, pieces ? piece_rows(scene, frame) : body_rows(scene, frame), lines);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

}  // namespace griffith::ui
