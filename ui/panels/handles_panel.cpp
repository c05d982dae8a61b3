#include <array>
#include <string>

#include "ui/panels/panels.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

/// Draws the choice of what the handles snap to.
void snap_rows(Panel& panel) {
  const std::array<std::string, 2> targets = {"round values", "surfaces"};  // by SnapTarget
  bool snap = panel.state.snap;
  if (checkbox(panel, "handles/snap", "Snap (Ctrl inverts)", snap)) issue(panel, {.name = "edit.snap"});
  const auto target = static_cast<int>(panel.state.snap_target);
  const int chosen = combo_row(panel, "handles/snap_to", "Snap to", targets, targets[static_cast<std::size_t>(target)]);
  field_tooltip(
      panel, "handles/snap_to",
      "Round values: of coordinates, angles (15°) and sizes.\nSurfaces: an arrow or a plane stops where bodies "
      "touch; the middle puts them onto the surface below the mouse.");
  if (chosen >= 0 && chosen != target) issue(panel, {.name = "edit.snap_to_surfaces"});
}

}  // namespace

void draw_handles_panel(Panel& panel) {
  if (panel.state.gizmo == GizmoTool::none) return;
  const bool scales = panel.state.gizmo == GizmoTool::scale;
  heading(panel, scales ? "Scale" : "Move and rotate");
  snap_rows(panel);
  hint(panel, scales ? "Squares scale along one axis, the ring scales all selected entries about the active one."
                     : "Arrows and squares move all selected entries, rings rotate the active one.");
}

}  // namespace griffith::ui
