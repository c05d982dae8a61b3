#include "ui/panels/editor_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/dialogs/dialogs.h"
#include "ui/panels/panels.h"
#include "ui/panels/shortcuts.h"
#include "ui/panels/side_panels.h"
#include "ui/panels/window_flags.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr float kLogHeight = 180, kProblemsHeight = 130, kPlotsHeight = 230, kMinimumDock = 90;  // design pixels
constexpr ImGuiWindowFlags kBar = kFixedWindow | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoScrollbar;

/// Arrangement of the fixed windows.
struct Layout {
  ImVec2 corner, end;  ///< rectangle below the menu
  float toolbar_height, time_height, status_height;
  float top() const { return corner.y + toolbar_height; }
  float bottom() const { return end.y - status_height - time_height; }
};

Layout lay_out(const Panel& panel) {
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  const ImGuiStyle& style = ImGui::GetStyle();
  const float row = ImGui::GetFrameHeight() + style.ItemSpacing.y;
  return {viewport->WorkPos,
          {viewport->WorkPos.x + viewport->WorkSize.x, viewport->WorkPos.y + viewport->WorkSize.y},
          ImGui::GetFrameHeight() + 2 * style.WindowPadding.y,
          ImGui::GetFrameHeight() + style.WindowPadding.y + (panel.input.microsteps ? 2 * row : 0),
          ImGui::GetTextLineHeight() + style.WindowPadding.y};
}

void begin_fixed(const char* name, ImVec2 corner, ImVec2 end, ImGuiWindowFlags flags, ImU32 color) {
  ImGui::SetNextWindowPos(corner);
  ImGui::SetNextWindowSize({end.x - corner.x, end.y - corner.y});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, color);
  ImGui::Begin(name, nullptr, flags);
  ImGui::PopStyleColor();
}

void draw_bars(Panel& panel, const Layout& layout) {
  begin_fixed("##toolbar", layout.corner, {layout.end.x, layout.top()}, kBar, palette::kWindow);
  draw_toolbar(panel);
  ImGui::End();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ImGui::GetStyle().WindowPadding.x, 4 * ui_scale(panel)});
  const float status = layout.end.y - layout.status_height;
  begin_fixed("##timebar", {layout.corner.x, layout.bottom()}, {layout.end.x, status}, kBar, palette::kWindow);
  if (panel.input.microsteps && panel.state.microsteps) draw_microstep_bar(panel);
  draw_time_bar(panel);
  ImGui::End();
  begin_fixed("##status", {layout.corner.x, status}, layout.end, kBar, palette::kWindow);
  draw_status_bar(panel);
  ImGui::End();
  ImGui::PopStyleVar();
}

/// A panel below the view.
struct Dock {
  const char* window;
  float first_height;  ///< [design pixels]
  float first_part;    ///< fraction of the available height, if that is more
  void (*draw)(Panel& panel);
};

/// Draws the panel, whose upper border can be dragged, above the `covered` pixels of others. Updates its `height`
/// [pixels] and that which is kept [design pixels]. Returns the height.
float draw_dock(Panel& panel, const Layout& layout, const Dock& dock, float& height, double& kept, float covered) {
  const float scale = ui_scale(panel), left = layout.corner.x + panel.state.left_width;
  const float width = layout.end.x - panel.state.right_width - left;
  const ImGuiCond once = height == 0 ? ImGuiCond_Always : ImGuiCond_Once;
  const float room = layout.bottom() - layout.top() - covered;
  if (height == 0)
    height = kept > 0 ? static_cast<float>(kept) * scale : std::max(dock.first_height * scale, dock.first_part * room);
  ImGui::SetNextWindowSize({width, height}, once);
  ImGui::SetNextWindowSizeConstraints({width, kMinimumDock * scale}, {width, room / 2});
  ImGui::SetNextWindowPos({left, layout.bottom() - covered - height});
  ImGui::Begin(dock.window, nullptr, kFixedWindow);
  const bool dragged = std::abs(std::exchange(height, ImGui::GetWindowHeight()) - height) > 0.5f &&
                       ImGui::IsMouseDown(ImGuiMouseButton_Left);
  if (dragged) kept = height / scale;
  dock.draw(panel);
  ImGui::End();
  return height;
}

/// Draws plots, messages and problems below the view. Returns their total height.
float draw_docks(Panel& panel, const Layout& layout) {
  PlotsState& plots = panel.state.plots;
  LogView& log = panel.state.log_view;
  ProblemView& problems = panel.state.problem_view;
  Preferences& kept = panel.state.preferences;
  float covered = 0;
  if (plots.shown)
    covered += draw_dock(panel, layout, {"##plots", kPlotsHeight, 0.25f, draw_plot_panel}, plots.height,
                         kept.plots_height, covered);
  if (log.shown)
    covered += draw_dock(panel, layout, {"##log", kLogHeight, 0, draw_log_panel}, log.height, kept.log_height, covered);
  if (problems.shown)
    covered += draw_dock(panel, layout, {"##problems", kProblemsHeight, 0, draw_problem_panel}, problems.height,
                         kept.problems_height, covered);
  return covered;
}

void draw_center(Panel& panel, const Layout& layout, float docks_height) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  begin_fixed("##view", {layout.corner.x + panel.state.left_width, layout.top()},
              {layout.end.x - panel.state.right_width, layout.bottom() - docks_height},
              kBar | ImGuiWindowFlags_NoScrollWithMouse, palette::kWindow);
  ImGui::PopStyleVar();
  draw_viewport(panel);
  ImGui::End();
}

}  // namespace

std::vector<Command> draw_editor(const EditorInput& input, EditorState& state, EditHistory& history, WidgetTags& tags) {
  std::vector<Command> commands;
  tags.clear();
  Panel panel{input, state, history, tags, commands};
  const bool had_error = state.error.has_value();
  const std::int64_t revision = history.revision();
  for (int button = 0; button < ImGuiMouseButton_COUNT; ++button)
    if (ImGui::IsMouseClicked(button)) state.field_note = {};
  issue_shortcuts(panel);
  draw_menu_bar(panel);
  const Layout layout = lay_out(panel);
  draw_bars(panel, layout);
  draw_side_panels(panel, {layout.corner.x, layout.top()}, {layout.end.x, layout.bottom()});
  draw_center(panel, layout, draw_docks(panel, layout));
  if (state.sought.frames > 0) --state.sought.frames;
  draw_dialogs(panel);
  draw_caption(panel);
  const bool acted = !commands.empty() || history.revision() != revision || (had_error && !state.error);
  if (acted) state.log_seen = state.log.size();
  return commands;
}

}  // namespace griffith::ui
