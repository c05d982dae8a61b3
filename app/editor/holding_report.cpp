#include "app/editor/holding_report.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/editor/thickness.h"
#include "ui/model/units.h"

namespace griffith::app {
namespace {

using ui::format_quantity;

std::string times(double factor) { return format_quantity(factor, "", 3) + " times"; }

/// Compares values: "4.1 MPa instead of 3 MPa".
std::string instead_of(double now, double factor, const char* unit) {
  return format_quantity(factor * now, unit, 3) + " instead of " + format_quantity(now, unit, 3);
}

/// Explains why the critical strength is not that of the utilization at the crack; empty if it is.
std::string of_utilization(const HoldingAnswer& answer) {
  constexpr double kEqual = 0.02;  // the factor is known to within 1 %
  const double factor = answer.strength.holds, utilization = answer.broken.utilization.value_or(factor);
  if (std::abs(factor - utilization) <= kEqual * utilization) return "";
  const std::string text = " It cracked at " + format_quantity(100 * utilization, "", 3) + " % of its resistance";
  if (factor > utilization) return text + " while its load was rising: without that crack it has to bear more.";
  if (answer.broken.before == 0)
    return text + ", but was above " + format_quantity(100 * factor, "", 3) +
           " % for less time than a crack takes to open.";
  return text + " after " + std::to_string(answer.broken.before) +
         " other cracks of that step had moved load to it; with the higher strength the step has " +
         std::to_string(answer.held.all) + ".";
}

std::string strength_fact(const HoldingAnswer& answer, const Material& material) {
  const CriticalFactor& strength = answer.strength;
  if (!strength.breaks_at_one)
    return "Strength: the node holds when the step is repeated, so there is no critical value.";
  if (!strength.found) return "Strength: in the next step it cracks at any strength.";
  return "Strength: in the next step it holds with " + times(strength.holds) + " the strength, " +
         instead_of(material.tensile_strength, strength.holds, "Pa") +
         (material.compressive_strength ? ", " + instead_of(*material.compressive_strength, strength.holds, "Pa")
                                        : "") +
         " and " + instead_of(material.fracture_toughness, strength.holds, "Pa·√m") + "." + of_utilization(answer);
}

/// Returns the common speed of all shots of a run; 0 if they differ or bodies have initial velocities.
double common_speed(const RunToCrack& run) {
  const std::vector<ProjectileBurst> shots = shots_of(run);
  const bool equal =
      std::ranges::all_of(shots, [&](const ProjectileBurst& shot) { return shot.speed == shots.front().speed; });
  return shots.empty() || bodies_fly(run) || !equal ? 0 : shots.front().speed;
}

std::string speed_fact(const std::optional<CriticalFactor>& speed, const RunToCrack& run) {
  if (!speed) return "Speed: nothing moves at the start.";
  if (!speed->breaks_at_one) return "Speed: the node holds when the run is repeated, so there is no critical value.";
  if (!speed->found) return "Speed: it cracks at " + times(1 / kLargestFactor) + " the speed, too.";
  const double fraction = 1 / speed->holds, now = common_speed(run);
  return "Speed: it holds at " + times(fraction) + " the speed" +
         (now > 0 ? ", " + instead_of(now, fraction, "m/s") : "") + ".";
}

std::string thickness_fact(const std::optional<CriticalFactor>& factor, const RunToCrack& run) {
  const std::optional<Thickness> now = thickness_of(run.scene.bodies[run.scene_body].shape);
  if (!now || !factor) return "Thickness: a mesh from a file has no thickness to change.";
  if (!factor->breaks_at_one)
    return "Thickness: the node holds when the run is repeated, so there is no critical value.";
  if (!factor->found) return "Thickness: it cracks at " + times(kLargestFactor) + " the thickness, too.";
  return "Thickness: it holds at " + times(factor->holds) + " the thickness, " +
         instead_of(now->length, factor->holds, "m") + ".";
}

/// Summarizes the trials.
std::string trial_summary(const HoldingAnswer& answer) {
  const int runs = (answer.speed ? answer.speed->runs : 0) + (answer.thickness ? answer.thickness->runs : 0);
  return "Tried, each to within 1 %: the step " + std::to_string(answer.strength.runs) +
         " times, the run from its start " + std::to_string(runs) + " times, up to " +
         format_quantity(kTimeToHold, "s", 2) + " after the crack.";
}

bool is_critical(const std::optional<CriticalFactor>& factor) {
  return factor && factor->found && factor->breaks_at_one && factor->runs > 0;
}

std::vector<ui::WorkReport::Action> ways_to_apply(const HoldingAnswer& answer, const RunToCrack& run) {
  std::vector<ui::WorkReport::Action> actions;
  const std::string& body = run.scene.bodies[static_cast<std::size_t>(run.scene_body)].name;
  if (is_critical(answer.strength))
    actions.push_back({"time.apply_strength", "Apply: " + times(answer.strength.holds) + " the strength of " + body});
  if (is_critical(answer.speed))
    actions.push_back({"time.apply_speed", "Apply: " + times(1 / answer.speed->holds) + " the speed"});
  if (is_critical(answer.thickness))
    actions.push_back(
        {"time.apply_thickness", "Apply: " + times(answer.thickness->holds) + " the thickness of " + body});
  return actions;
}

}  // namespace

ui::WorkReport holding_report(const HoldingAnswer& answer, const RunToCrack& run) {
  ui::WorkReport report;
  const std::string& body = run.scene.bodies[static_cast<std::size_t>(run.scene_body)].name;
  report.title = "What would have held node " + std::to_string(run.node.index()) + " of " + body + ":";
  const bool ended_early = answer.cancelled || !answer.problem.empty();
  if (answer.strength.runs > 0) report.facts.push_back(strength_fact(answer, run.material));
  if (answer.speed || !ended_early) report.facts.push_back(speed_fact(answer.speed, run));
  if (answer.thickness || !ended_early) report.facts.push_back(thickness_fact(answer.thickness, run));
  report.facts.push_back("Only this node is examined: others may crack all the same.");
  report.facts.push_back(trial_summary(answer));
  report.actions = ways_to_apply(answer, run);
  if (answer.cancelled) report.warnings.push_back("Cancelled before the search was complete.");
  if (!answer.problem.empty()) report.warnings.push_back("The search ended early: " + answer.problem);
  return report;
}

}  // namespace griffith::app
