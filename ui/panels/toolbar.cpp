#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/panels/panels.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

void gap(const Panel& panel, float design_pixels) { ImGui::SameLine(0, design_pixels * ui_scale(panel)); }

void simulation_buttons(Panel& panel) {
  const bool running = panel.state.running || (panel.state.microsteps && panel.state.microsteps->playing);
  command_button(panel, "simulation.run", running ? Icon::pause : Icon::play, false, running);
  ImGui::SameLine();
  command_button(panel, "simulation.step", Icon::step, true);
  ImGui::SameLine();
  command_button(panel, "simulation.reset", Icon::reset, true);
  gap(panel, 18);
  command_button(panel, "simulation.fire", Icon::fire, true);
  ImGui::SameLine();
  command_button(panel, "simulation.grab", Icon::grab, true, panel.state.grab_tool);
  ImGui::SameLine();
  command_button(panel, "simulation.push", Icon::push, true, panel.state.push_tool);
}

/// Draws the speed, 0.1 to 100 % of real time.
void speed_field(Panel& panel) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(as_vec4(palette::kTextDim), "Speed");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(150 * ui_scale(panel));
  double percent = 100 * panel.state.speed;
  const NumberField field = {
      .tag = "toolbar/speed",
      .label = {},
      .numbers = between(0.1, 100, "%"),
      .tooltip =
          "Slow motion: simulated time over real time. The time step stays the same; fewer steps are made per second."};
  if (number_field(panel, field, percent).changed) panel.state.speed = percent / 100;
}

void clock(const Panel& panel) {
  const EditorInput& input = panel.input;
  char text[160];
  std::snprintf(text, sizeof text, input.microsteps ? "%.6f s" : "%.3f s", input.frame.time);
  ImGui::PushFont(input.fonts.bold);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
  tag_last_item(panel.tags, "toolbar/time", text);
  gap(panel, 14);
  const std::int64_t left = panel.state.steps_left, step = input.microsteps ? input.microsteps->step : input.frame.step;
  std::snprintf(text, sizeof text, left > 0 ? "step %lld of %lld" : "step %lld", static_cast<long long>(step),
                static_cast<long long>(step + left));
  ImGui::TextColored(as_vec4(palette::kTextDim), "%s", text);
  tag_last_item(panel.tags, "toolbar/step", text);
}

/// Draws text after the last item if it ends before `end`. True if it fits.
bool text_before(const Panel& panel, float end, ImU32 color, const char* text) {
  gap(panel, 14);
  const bool fits = ImGui::GetCursorPosX() + ImGui::CalcTextSize(text).x <= end;
  if (fits) ImGui::TextColored(as_vec4(color), "%s", text);
  return fits;
}

/// Shows the progress of a slow step. True if there is one.
bool long_step(const Panel& panel, float end) {
  constexpr double kLong = 0.5;  // [s]
  if (panel.input.step_in_progress < kLong) return false;
  char text[64];
  std::snprintf(text, sizeof text, "step %lld: %.1f s so far", static_cast<long long>(panel.input.frame.step + 1),
                panel.input.step_in_progress);
  text_before(panel, end, palette::kTextDim, text);
  tag_last_item(panel.tags, "toolbar/step_in_progress", text);
  return true;
}

void pace_warning(const Panel& panel, float end) {
  if (!panel.state.running || !panel.input.falling_behind || panel.input.reached_speed <= 0) return;
  char text[64];
  std::snprintf(text, sizeof text, "can't keep up: %.2g of %.3g %%", 100 * panel.input.reached_speed,
                100 * panel.state.speed);
  if (!text_before(panel, end, palette::kWarning, text)) return;
  tooltip("A step takes longer than the time it simulates. Results are not affected; the simulation only runs slower.");
}

void times(const Panel& panel, float end) {
  if (!panel.state.show_times) return;
  char text[64];
  const auto show = [&](const char* tag, const char* meaning) {
    if (!text_before(panel, end, palette::kTextDim, text)) return;
    tag_last_item(panel.tags, tag, text);
    tooltip(meaning);
  };
  if (panel.input.step_milliseconds > 0) {  // a step was made
    const double duration = panel.input.step_milliseconds;
    std::snprintf(text, sizeof text, duration < 0.1 ? "%.2g ms/step" : "%.1f ms/step", duration);
    show("toolbar/step_time", "Time that a step takes, smoothed. Its picture comes on top.");
  }
  if (!panel.state.running) return;  // the window draws only when something changes, so no time passes
  const double pictures = panel.input.frames_per_second;
  std::snprintf(text, sizeof text, pictures < 10 ? "%.2g fps" : "%.0f fps", pictures);
  show("toolbar/pictures", "Pictures drawn per second. While a step lasts, only its progress is drawn.");
  if (panel.input.reached_speed <= 0) return;
  std::snprintf(text, sizeof text, "%.2g × real time", panel.input.reached_speed);
  show("toolbar/speed_reached", "Simulated over real time, in the last two seconds.");
}

}  // namespace

void draw_toolbar(Panel& panel) {
  simulation_buttons(panel);
  gap(panel, 18);
  speed_field(panel);
  gap(panel, 22);
  clock(panel);
  const float button = 1.25f * ImGui::GetFrameHeight(), spacing = ImGui::GetStyle().ItemSpacing.x;
  const float right = ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - 5 * button - 4 * spacing;
  if (!long_step(panel, right - spacing)) pace_warning(panel, right - spacing);
  times(panel, right - spacing);
  ImGui::SameLine(right);
  const std::pair<std::string_view, Icon> tools[] = {{"edit.undo", Icon::undo},
                                                     {"edit.redo", Icon::redo},
                                                     {"view.frame_all", Icon::frame},
                                                     {"file.screenshot", Icon::camera},
                                                     {"help.show", Icon::help}};
  for (const auto& [id, icon] : tools) {
    command_button(panel, id, icon, false);
    ImGui::SameLine();
  }
  ImGui::NewLine();
}

}  // namespace griffith::ui
