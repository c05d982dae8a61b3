#include <cmath>

#include "sim/core/number_text.h"
#include "ui/dialogs/dialog_window.h"
#include "ui/dialogs/dialogs.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

/// Rounds an estimate to two digits.
long long rounded(double count) {
  const double unit = std::pow(10, std::floor(std::log10(std::max(count, 1.0))) - 1);
  return std::llround(std::round(count / unit) * unit);
}

}  // namespace

void draw_large_mesh_dialog(Panel& panel) {
  EditorState& state = panel.state;
  if (!begin_dialog(panel, "Large mesh", state.large_mesh.has_value(), 480)) return;
  if (state.large_mesh) {
    const std::string text = "The bodies would have about " + count_text(rounded(*state.large_mesh)) +
                             " tetrahedra. Building them may take minutes and gigabytes, and each step seconds.";
    wrapped_text(text);
    tag_last_item(panel.tags, "large_mesh/text", text);
  }
  ImGui::Spacing();
  const float width = 120 * ui_scale(panel);
  if (text_button(panel, "large_mesh/build", "Build", width)) {
    state.build_large_mesh = true;
    state.large_mesh.reset();
  }
  ImGui::SameLine();
  if (text_button(panel, "large_mesh/cancel", "Cancel", width) || escape_pressed()) {
    state.cancel_work = true;
    state.large_mesh.reset();
  }
  if (!state.large_mesh) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace griffith::ui
