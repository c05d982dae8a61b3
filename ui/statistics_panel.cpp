#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>

#include "sim/mesh/number_text.h"
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/units.h"
#include "ui/widgets.h"

namespace griffith::ui {
namespace {

void count_row(const Panel& panel, const char* label, std::size_t value) {
  value_row(panel, label, count_text(static_cast<long long>(value)), palette::kText);
}

/// A counter that ought to be 0.
void trouble_row(const Panel& panel, const char* label, int value, ImU32 color, const char* cure) {
  value_row(panel, label, count_text(value), value > 0 ? color : palette::kTextDim);
  tooltip(cure);
}

void mesh_rows(const Panel& panel) {
  const Frame& frame = panel.input.frame;
  heading(panel, "Simulation");
  count_row(panel, "Tetrahedra", frame.tets.size());
  count_row(panel, "Nodes", frame.positions.size());
  count_row(panel, "Pieces", frame.bodies.size());
  count_row(panel, "Fragments", static_cast<std::size_t>(std::max(frame.fragments, 0)));
  count_row(panel, "Crack events", frame.crack_events.size());
  count_row(panel, "Contacts", static_cast<std::size_t>(std::max(frame.report.contacts, 0)));
  count_row(panel, "Substeps", static_cast<std::size_t>(std::max(frame.report.substeps, 0)));
}

/// What stood in for the material of the slowest body, and why.
std::string scaled_text(const ScaledImpact& impact) {
  return "As a material of " + format_quantity(impact.young_modulus, "Pa", 3) + " with a strength of " +
         format_quantity(impact.tensile_strength, "Pa", 3) +
         " the struck body breaks at the speed at which it should: " + reason(impact) + ".";
}

void scaled_row(const Panel& panel) {
  const std::span<const BodyView> bodies = panel.input.frame.bodies;
  const auto factor = [](const BodyView& body) { return body.scaled ? body.scaled->factor : 1; };
  const auto count = std::ranges::count_if(bodies, [](const BodyView& body) { return body.scaled.has_value(); });
  const auto slowest = std::ranges::min_element(bodies, {}, factor);
  trouble_row(panel, "Scaled bodies", static_cast<int>(count), palette::kWarning,
              count > 0 ? scaled_text(*slowest->scaled).c_str()
                        : "Their waves would have taken more microsteps than step_budget leaves.");
}

void solver_rows(const Panel& panel) {
  const StepReport& report = panel.input.frame.report;
  heading(panel, "Solver");
  count_row(panel, "Iterations", static_cast<std::size_t>(std::max(report.solver_iterations, 0)));
  char residual[32];
  std::snprintf(residual, sizeof residual, "%.1e", report.max_relative_residual);
  value_row(panel, "Relative residual", residual, palette::kText);
  trouble_row(panel, "Unconverged solves", report.unconverged_solves, palette::kWarning,
              "Solves stopped by the iteration limit: allow more iterations or a larger residual.");
  trouble_row(panel, "Inverted tetrahedra", report.inverted_tets, palette::kWarning,
              "Elements turned inside out: use more substeps or stiffer material.");
  trouble_row(panel, "Values not finite", report.non_finite_values, palette::kError,
              "Bodies frozen because a value was not finite, or because they would take more than 100,000 explicit "
              "substeps a step: reset, and use a smaller time step.");
  trouble_row(panel, "Cracks postponed", report.cracks_postponed, palette::kWarning,
              "Over the budget of cracks a step; they follow in the next steps.");
  trouble_row(panel, "Cracks suppressed", report.cracks_suppressed, palette::kWarning,
              "Not made because the fragment would be too small.");
  trouble_row(panel, "Cuts refused", report.remeshing_refused, palette::kWarning,
              "Edges that remeshing left whole, or the tetrahedra would have become too small or too flat.");
  trouble_row(panel, "Unfinished equilibria", report.unfinished_equilibria, palette::kWarning,
              "Cracks were still opening at the limit of substeps: raise impact_substeps of the scene.");
  scaled_row(panel);
  trouble_row(panel, "Shortened motions", report.shortened_motions, palette::kWarning,
              "Deformations cut short, whose linearised step would have added energy: use more substeps.");
  trouble_row(panel, "Limited impulses", report.limited_impulses, palette::kWarning,
              "Bodies whose contact impulses were cut, which would have added energy.");
  count_row(panel, "Sleeping bodies", static_cast<std::size_t>(report.sleeping_bodies));
  value_row(panel, "Penetration", format_quantity(report.max_penetration, "m", 3), palette::kText);
}

/// A value and, as a bar below it, its share of a whole.
void share_row(const Panel& panel, const char* label, const std::string& text, double value, double whole) {
  value_row(panel, label, text, palette::kText);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float left = ImGui::GetWindowPos().x + ImGui::GetStyle().WindowPadding.x;
  const float share = static_cast<float>(std::clamp(whole > 0 ? value / whole : 0, 0.0, 1.0));
  const float thickness = 2 * ui_scale(panel);
  ImGui::GetWindowDrawList()->AddRectFilled({left, high.y}, {high.x, high.y + thickness}, palette::kField);
  ImGui::GetWindowDrawList()->AddRectFilled({left, high.y}, {left + share * (high.x - left), high.y + thickness},
                                            palette::kAccent);
  ImGui::Dummy({0, (low.y < high.y ? 1 : 0) * thickness / 2});
}

void time_bar(const Panel& panel, const char* label, double milliseconds, double whole) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f ms", milliseconds);
  share_row(panel, label, text, milliseconds, whole);
}

void energy_row(const Panel& panel, const char* label, double energy, double whole, const char* meaning) {
  constexpr double kRounding = 1e-12;
  if (std::abs(energy) < kRounding * whole) energy = 0;
  share_row(panel, label, format_quantity(energy, "J", 3), energy, whole);
  tooltip(meaning);
}

/// Where the energy came from, and where it is or went: shares of all that came in.
void energy_rows(const Panel& panel) {
  const EnergyAccount& energy = panel.input.frame.energy;
  const double whole = energy.turned_over();
  heading(panel, "Energy since the start");
  for (const EnergyEntry& entry : energy_entries())
    energy_row(panel, entry.label.data(), energy.*entry.value, whole, entry.meaning.data());
  energy_row(panel, "Unaccounted", energy.unaccounted(), whole, "What the entries above do not explain.");
}

void timing_rows(const Panel& panel) {
  const StepTimings& t = panel.input.frame.report.milliseconds;
  heading(panel, "Time of the last step");
  time_bar(panel, "Contact", t.contact, t.step);
  time_bar(panel, "Elasticity", t.elasticity, t.step);
  time_bar(panel, "Microsteps", t.shock, t.step);
  time_bar(panel, "Separation", t.separation, t.step);
  time_bar(panel, "Fracture", t.fracture, t.step);
  time_bar(panel, "Step", t.step, t.step);
}

}  // namespace

void draw_statistics_panel(Panel& panel) {
  mesh_rows(panel);
  energy_rows(panel);
  solver_rows(panel);
  if (panel.state.show_times) timing_rows(panel);
}

}  // namespace griffith::ui
