#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "sim/core/number_text.h"
#include "sim/world/output/scaled_breaks.h"
#include "sim/world/output/step_counters.h"
#include "ui/model/energy_share.h"
#include "ui/model/overlap.h"
#include "ui/model/units.h"
#include "ui/model/verdict.h"
#include "ui/panels/panels.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

void count_row(const Panel& panel, const char* label, std::size_t value) {
  value_row(panel, label, count_text(static_cast<long long>(value)), palette::kText);
}

/// Draws a counter that should be 0.
void trouble_row(const Panel& panel, const char* label, int value, ImU32 color, const char* cure) {
  value_row(panel, label, count_text(value), value > 0 ? color : palette::kTextDim);
  tooltip(cure);
}

/// Draws a row that is shown from the first crack of a scaled body on.
void broke_scaled_row(const Panel& panel) {
  const std::vector<ScaledBreak> breaks = scaled_breaks(panel.input.frame);
  if (breaks.empty()) return;
  int pieces = 0;
  for (const ScaledBreak& broken : breaks) pieces += broken.pieces;
  const auto least = std::ranges::min_element(breaks, {}, [](const ScaledBreak& one) { return one.least.factor; });
  value_row(panel, "Broke while scaled", count_text(pieces) + " pieces, " + scale_text(least->least),
            palette::kWarning);
  tooltip(stand_in_text(least->least));
}

void mesh_rows(const Panel& panel) {
  const Frame& frame = panel.input.frame;
  heading(panel, "Simulation");
  count_row(panel, "Tetrahedra", frame.elements.tets.size());
  count_row(panel, "Nodes", frame.nodes.positions.size());
  count_row(panel, "Pieces", frame.bodies.size());
  count_row(panel, "Fragments", static_cast<std::size_t>(std::max(frame.fragments, 0)));
  count_row(panel, "Crack events", frame.crack_events.size());
  broke_scaled_row(panel);
}

void scaled_row(const Panel& panel) {
  const std::span<const BodyView> bodies = panel.input.frame.bodies;
  const auto factor = [](const BodyView& body) { return body.scaled ? body.scaled->factor : 1; };
  const auto count = std::ranges::count_if(bodies, [](const BodyView& body) { return body.scaled.has_value(); });
  const auto slowest = std::ranges::min_element(bodies, {}, factor);
  trouble_row(panel, "Scaled bodies", static_cast<int>(count), palette::kWarning,
              count > 0 ? stand_in_text(*slowest->scaled).c_str()
                        : "Bodies whose waves would need more microsteps than step_budget allows.");
}

void counter_row(const Panel& panel, const StepCounter& counter, int value) {
  const ImU32 color = counter.concern == CounterConcern::error ? palette::kError : palette::kWarning;
  if (counter.concern != CounterConcern::none)
    return trouble_row(panel, counter.label.data(), value, color, counter.meaning.data());
  count_row(panel, counter.label.data(), static_cast<std::size_t>(std::max(value, 0)));
  tooltip(counter.meaning.data());
}

void counter_row(const Panel& panel, const StepCounter& counter, double value) {
  char ratio[32];
  std::snprintf(ratio, sizeof ratio, "%.1e", value);
  const std::string text = counter.unit == "-" ? ratio : format_quantity(value, counter.unit.data(), 3);
  value_row(panel, counter.label.data(), text, palette::kText);
  tooltip(counter.meaning.data());
}

/// Warns of deep penetration, with its remedy.
void overlap_warning(const Panel& panel) {
  const std::optional<DeepOverlap> overlap = deep_overlap(panel.input.frame);
  if (!overlap) return;
  const std::string text = text_of(*overlap);
  wrapped_text(text, palette::kWarning);
  tag_last_item(panel.tags, "statistics/overlap", text);
}

void step_rows(const Panel& panel) {
  heading(panel, "Last step");
  for (const StepCounter& counter : step_counters())
    std::visit([&](auto value) { counter_row(panel, counter, panel.input.frame.report.*value); }, counter.value);
  overlap_warning(panel);
  scaled_row(panel);
}

/// Draws a value with its fraction of a whole, 0..1, as a bar.
void share_row(const Panel& panel, const char* label, const std::string& text, double share) {
  value_row(panel, label, text, palette::kText);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float left = ImGui::GetWindowPos().x + ImGui::GetStyle().WindowPadding.x;
  const float fraction = static_cast<float>(share);
  const float thickness = 2 * ui_scale(panel);
  ImGui::GetWindowDrawList()->AddRectFilled({left, high.y}, {high.x, high.y + thickness}, palette::kField);
  ImGui::GetWindowDrawList()->AddRectFilled({left, high.y}, {left + fraction * (high.x - left), high.y + thickness},
                                            palette::kAccent);
  ImGui::Dummy({0, (low.y < high.y ? 1 : 0) * thickness / 2});
}

void time_bar(const Panel& panel, const char* label, double milliseconds, double whole) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f ms", milliseconds);
  share_row(panel, label, text, whole > 0 ? std::clamp(milliseconds / whole, 0.0, 1.0) : 0);
}

void energy_row(const Panel& panel, const char* label, const EnergyShare& share, const char* meaning) {
  share_row(panel, label, format_quantity(share.energy, "J", 3), share.fraction);
  tooltip(meaning);
}

/// Draws the entries of the energy account as fractions of all supplied energy.
void energy_rows(const Panel& panel) {
  const EnergyAccount& energy = panel.input.frame.energy;
  const double whole = energy.turned_over();
  const double noise =
      energy_noise(panel.input.frame, panel.history.scene().gravity, (panel.input.high - panel.input.low).norm());
  heading(panel, "Energy since the start");
  for (const EnergyEntry& entry : energy_entries())
    energy_row(panel, entry.label.data(), energy_share(energy.*entry.value, whole, noise), entry.meaning.data());
  energy_row(panel, "Unaccounted", energy_share(energy.unaccounted(), whole, noise),
             "Remainder that the entries above do not explain.");
}

void timing_rows(const Panel& panel) {
  const StepTimings& t = panel.input.frame.report.milliseconds;
  heading(panel, "Time of the last step");
  time_bar(panel, "Contact", t.contact, t.step);
  time_bar(panel, "Elasticity", t.elasticity, t.step);
  time_bar(panel, "Explicit dynamics", t.explicit_dynamics, t.step);
  time_bar(panel, "Separation", t.separation, t.step);
  time_bar(panel, "Fracture", t.fracture, t.step);
  time_bar(panel, "Step", t.step, t.step);
}

}  // namespace

void draw_statistics_panel(Panel& panel) {
  mesh_rows(panel);
  if (panel.input.microsteps) return hint(panel, "Energies, counters and times are those of whole steps.");
  energy_rows(panel);
  step_rows(panel);
  if (panel.state.show_times) timing_rows(panel);
}

}  // namespace griffith::ui
