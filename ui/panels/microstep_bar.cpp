#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "sim/core/number_text.h"
#include "ui/panels/panels.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

/// Returns the horizontal place of a moment in the bar.
float place_of(const MicrostepView& view, ImVec2 low, ImVec2 high, double moment) {
  const double last = std::max<double>(1, static_cast<double>(view.moments.size()) - 1);
  return low.x + (high.x - low.x) * static_cast<float>(moment / last);
}

/// Draws ticks where cracks opened, taller for more of them.
void draw_crack_ticks(const Panel& panel, const MicrostepView& view, ImVec2 low, ImVec2 high) {
  const float scale = ui_scale(panel), height = high.y - low.y;
  for (std::size_t i = 0; i < view.moments.size(); ++i) {
    const int before = i > 0 ? view.moments[i - 1].cracks : view.is_part() ? view.moments[0].cracks : 0;
    const int cracks = view.moments[i].cracks - before;
    if (cracks <= 0) continue;
    const float length = height * std::min(1.0f, 0.35f + 0.15f * std::log2(1.0f + static_cast<float>(cracks)));
    const float x = place_of(view, low, high, static_cast<double>(i));
    ImGui::GetWindowDrawList()->AddLine({x, high.y - length}, {x, high.y}, palette::kError, 1.5f * scale);
  }
}

/// Describes a moment under the cursor.
std::string tooltip_text(const MicrostepView& view, int moment) {
  const int cracks = view.moments[static_cast<std::size_t>(moment)].cracks;
  return moment_text(view, moment) + ", " + microstep_text(view, moment) +
         (cracks > 0 ? ", " + count_text(cracks) + (cracks == 1 ? " crack so far" : " cracks so far") : "");
}

/// Draws the recorded moments: a click or a drag goes there.
void draw_moments(Panel& panel, const MicrostepView& view, float width) {
  ImGui::InvisibleButton("##moments", {width, ImGui::GetFrameHeight()});
  const int shown = panel.state.microsteps->moment();
  tag_last_item(panel.tags, "microsteps/bar", std::to_string(shown) + " of " + std::to_string(view.moments.size() - 1));
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float scale = ui_scale(panel);
  list->AddRectFilled(low, high, palette::kField, 3 * scale);
  draw_crack_ticks(panel, view, low, high);
  const float x = place_of(view, low, high, panel.state.microsteps->place);
  list->AddLine({x, low.y}, {x, high.y}, palette::kText, 2 * scale);
  const float fraction = std::clamp((ImGui::GetIO().MousePos.x - low.x) / (high.x - low.x), 0.0f, 1.0f);
  const int pointed = static_cast<int>(std::lround(fraction * static_cast<float>(view.moments.size() - 1)));
  if (ImGui::IsItemActive() && pointed != shown) issue(panel, {.name = "time.moment", .step = pointed});
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetTooltip("%s", tooltip_text(view, pointed).c_str());
}

void dim_text(const Panel& panel, const char* tag, const std::string& text) {
  ImGui::SameLine(0, 14 * ui_scale(panel));
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(as_vec4(palette::kTextDim), "%s", text.c_str());
  tag_last_item(panel.tags, tag, text);
}

/// Draws the duration of playback, with the factor of slow motion.
void duration_field(Panel& panel, const MicrostepView& view) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(as_vec4(palette::kTextDim), "Plays in");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(80 * ui_scale(panel));
  number_field(panel,
               {.tag = "microsteps/seconds",
                .label = {},
                .numbers = between(0.5, 600, "s"),
                .tooltip = "Time in which all recorded microsteps are played."},
               panel.state.microstep_seconds);
  const double span = view.moments.back().time - view.moments.front().time;
  if (span <= 0) return;
  dim_text(panel, "microsteps/slower",
           count_text(std::llround(panel.state.microstep_seconds / span)) + " times slower than real");
}

void recording_buttons(Panel& panel, const MicrostepView& view) {
  const float width = 80 * ui_scale(panel), spacing = ImGui::GetStyle().ItemSpacing.x;
  const int buttons = view.is_part() ? 3 : 2;
  ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x -
                  static_cast<float>(buttons) * (width + spacing) + spacing);
  if (text_button(panel, "microsteps/finer", "Finer", width)) issue(panel, {.name = "time.finer"});
  tooltip(view.interval == 1 ? "Record the microsteps around the shown one."
                             : "Record around the shown microstep, at an eighth of the interval.");
  ImGui::SameLine();
  if (view.is_part()) {
    if (text_button(panel, "microsteps/whole", "Whole step", width)) issue(panel, {.name = "time.whole"});
    ImGui::SameLine();
  }
  if (text_button(panel, "microsteps/close", "Close", width)) issue(panel, {.name = "time.microsteps"});
}

}  // namespace

void draw_microstep_bar(Panel& panel) {
  const MicrostepView& view = *panel.input.microsteps;
  const MicrostepPlayback& playback = *panel.state.microsteps;
  const float scale = ui_scale(panel);
  if (text_button(panel, "microsteps/play", playback.playing ? "Pause" : "Play", 70 * scale))
    issue(panel, {.name = "simulation.run"});
  ImGui::SameLine();
  const float time_width = 110 * scale;
  draw_moments(panel, view, std::max(40 * scale, ImGui::GetContentRegionAvail().x - time_width));
  ImGui::SameLine();
  ImGui::PushFont(panel.input.fonts.bold);
  ImGui::AlignTextToFramePadding();
  const std::string time = moment_text(view, playback.moment());
  ImGui::TextUnformatted(time.c_str());
  ImGui::PopFont();
  tag_last_item(panel.tags, "microsteps/time", time);
  duration_field(panel, view);
  dim_text(panel, "microsteps/shown", microstep_text(view, playback.moment()));
  dim_text(panel, "microsteps/recording", recording_text(view));
  recording_buttons(panel, view);
}

}  // namespace griffith::ui
