#include <array>
#include <cfloat>
#include <string>

#include "ui/dialogs/dialog_window.h"
#include "ui/dialogs/dialogs.h"
#include "ui/widgets/field_range.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

/// Names in the order of MeshingMethod.
const std::array<std::string, 3> kMethods = {"automatic", "TetGen", "volumetric"};

void method_row(Panel& panel, MeshingMethod& method) {
  const int chosen = combo_row(panel, "surface/method", "Method", kMethods, kMethods[static_cast<std::size_t>(method)]);
  if (chosen >= 0) method = static_cast<MeshingMethod>(chosen);
}

void fill(Panel& panel) {
  issue(panel, {.name = "file.fill_surface"});
  panel.state.show_surface = false;
}

void text_lines(Panel& panel, const char* tag, const std::vector<std::string>& lines, ImU32 color) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    wrapped_text(lines[i], color);
    tag_last_item(panel.tags, tag + std::to_string(i), lines[i]);
  }
}

/// Draws the buttons of what the report offers to do.
void action_buttons(Panel& panel, const std::vector<WorkReport::Action>& actions) {
  for (const WorkReport::Action& action : actions) {
    ImGui::Spacing();
    if (text_button(panel, ("report/" + std::string(action.command)).c_str(), action.label.c_str(),
                    ImGui::GetContentRegionAvail().x)) {
      issue(panel, {.name = action.command});
      ImGui::CloseCurrentPopup();  // the command takes the report away
    }
    tooltip(command_info(action.command, panel).hint);
  }
}

}  // namespace

void draw_surface_dialog(Panel& panel) {
  EditorState& state = panel.state;
  SurfaceRequest& request = state.surface;
  if (!begin_dialog(panel, "Add a body from a surface", state.show_surface, 520)) return;
  ImGui::SetNextItemWidth(-FLT_MIN);
  const bool entered =
      ImGui::InputTextWithHint("##surface", "path of an OBJ, STL, PLY, OFF or glTF file", request.path.data(),
                               request.path.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  const bool left = escape_left_untyped();
  tag_last_item(panel.tags, "surface/path", request.path.data());
  number_field_row(panel,
                   {.tag = "surface/scale", .label = "Meters per unit", .numbers = range_of<SurfaceShape>("scale")},
                   request.scale);
  method_row(panel, request.method);
  checkbox(panel, "surface/automatic_size", "Automatic element size", request.automatic_size);
  if (!request.automatic_size)
    number_field_row(
        panel,
        {.tag = "surface/element_size", .label = "Element size", .numbers = range_of<SurfaceShape>("element_size")},
        request.element_size);
  hint(panel,
       "TetGen keeps every triangle of the surface; the volumetric method also accepts open and self-intersecting "
       "surfaces.");
  ImGui::Spacing();
  const bool pressed = text_button(panel, "surface/fill", "Fill", 120 * ui_scale(panel));
  if ((entered || pressed) && request.path[0] != '\0') fill(panel);
  ImGui::SameLine();
  if (text_button(panel, "surface/cancel", "Cancel", 120 * ui_scale(panel)) || escape_pressed() || left)
    state.show_surface = false;
  if (!state.show_surface) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void draw_report_dialog(Panel& panel) {
  std::optional<WorkReport>& report = panel.state.report;
  if (!begin_dialog(panel, "Done", report.has_value(), 520)) return;
  if (report) {
    ImGui::TextUnformatted(report->title.c_str());
    tag_last_item(panel.tags, "report/title", report->title);
    ImGui::Spacing();
    text_lines(panel, "report/fact", report->facts, palette::kText);
    text_lines(panel, "report/warning", report->warnings, palette::kAccent);
  }
  if (report) action_buttons(panel, report->actions);
  ImGui::Spacing();
  if (text_button(panel, "report/close", "Close", 120 * ui_scale(panel)) || dismiss_pressed()) report.reset();
  if (!report) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace griffith::ui
