#include "ui/model/verdict.h"

#include <cmath>

#include "ui/model/units.h"

namespace griffith::ui {
namespace {

constexpr double kNear = 0.8;

std::string percent(double fraction) { return format_quantity(100 * fraction, "", 3) + " %"; }

Verdict overloaded(const NodeReport& report, const Frame& frame, bool fracture) {
  const std::string load =
      "Overloaded, at " + percent(report.separation.utilization) + " of its resistance, but whole: ";
  std::string why = "a crack that opened close by relieves it first, or all its elements lie on one side of the plane.";
  if (!fracture) {
    why = "the scene does not let bodies break.";
  } else if (frame.report.cracks_postponed > 0) {
    why = "the budget of cracks a step was used up. It breaks in the next step if the load stays.";
  } else if (frame.report.cracks_suppressed > 0) {
    why = "the fragment would have been smaller than the scene allows.";
  }
  return {Verdict::Kind::overloaded, load + why};
}

/// `what`: "Broke", "Its piece broke" or "Shown".
std::string scaled_text(const std::string& what, const ScaledImpact& impact) {
  return " " + what + " at " + scale_text(impact) + ", " + format_quantity(1 / impact.factor, "", 2) +
         " times slower: " + reason(impact) + ".";
}

/// What stood in for the material when the node broke, now, or when its piece broke; empty where nothing did.
std::string scaling_note(const NodeReport& report, const Frame& frame, bool broke) {
  const BodyView& body = frame.bodies[report.body];
  if (broke)
    if (const auto& scaled = frame.crack_events[report.events.back()].scaled) return scaled_text("Broke", *scaled);
  if (body.scaled) return scaled_text("Shown", *body.scaled);
  return body.broke_scaled ? scaled_text("Its piece broke", *body.broke_scaled) : "";
}

std::string breaking(const CrackEvent& event, const char* unit) {
  std::string text = "Broke at " + format_quantity(event.time, "s", 3) + " (step " + std::to_string(event.step) +
                     "): the load of " + format_quantity(event.load, unit, 3) + " was " +
                     percent(event.load / event.resistance) + " of the resistance.";
  if (event.torn_off) text += " A support lost its hold there.";
  return text;
}

/// `what`: "Holds" or "What is left holds".
std::string holding(const std::string& what, const NodeReport& report, const Material& material) {
  const NodeSeparation& separation = report.separation;
  if (!std::isfinite(separation.resistance)) return "No load has been measured here yet.";
  constexpr double kNoise = 1e-6;
  if (separation.utilization > 0 && separation.utilization < kNoise) return what + ": there is no load to speak of.";
  const char* unit = load_unit(material);
  std::string text = what + ": the load of " + format_quantity(load_of(separation, material), unit, 3) + " is " +
                     percent(separation.utilization) + " of the resistance.";
  if (report.at_crack_front) text += " A crack ends here, so the fracture toughness counts.";
  if (separation.eigenvalue <= 0 && separation.utilization <= 0)
    text += " Nothing pulls: the elements press on the node.";
  return text;
}

/// But for what stood in for the material.
Verdict bare_verdict(const NodeReport& report, const Frame& frame, bool fracture) {
  const BodyView& body = frame.bodies[report.body];
  const Material& material = frame.materials[body.scene_body];
  std::string past;
  if (!report.events.empty()) past = breaking(frame.crack_events[report.events.back()], load_unit(material));
  if (body.rigid) {
    const std::string text = body.tets == 1
                                 ? "A single element cannot break any further."
                                 : "Its piece moves as a rigid body: what little stress it was left with stays "
                                   "as it is until something strikes.";
    return {past.empty() ? Verdict::Kind::unknown : Verdict::Kind::broke, past + (past.empty() ? "" : " ") + text};
  }
  if (report.separation.utilization > 1) return overloaded(report, frame, fracture);
  if (!past.empty()) return {Verdict::Kind::broke, past + " " + holding("What is left holds", report, material)};
  return {report.separation.utilization > kNear ? Verdict::Kind::near : Verdict::Kind::holds,
          holding("Holds", report, material)};
}

}  // namespace

std::string stand_in_text(const ScaledImpact& impact) {
  return "As a material of " + format_quantity(impact.young_modulus, "Pa", 3) + " with a strength of " +
         format_quantity(impact.tensile_strength, "Pa", 3) + " it breaks at the speed at which it should, " +
         format_quantity(1 / impact.factor, "", 2) + " times slower: " + reason(impact) +
         ". A larger step_budget scales less.";
}

const char* load_unit(const Material& material) {
  return material.criterion == FractureCriterion::separation_force ? "N" : "Pa";
}

double load_of(const NodeSeparation& separation, const Material& material) {
  return material.criterion == FractureCriterion::separation_force ? separation.eigenvalue : separation.stress;
}

std::string resistance_text(const NodeSeparation& separation, const Material& material) {
  return std::isfinite(separation.resistance) ? format_quantity(separation.resistance, load_unit(material))
                                              : "not yet known";
}

const char* contribution_unit(const NodeReport& report) { return report.by_tension ? "Pa" : "N"; }

std::string origin_of_load(const NodeReport& report, const Material& material) {
  const double pull = report.plane.eigenvalue;
  if (report.by_tension) return "the mean tensile stress of its elements";
  if (pull <= 0 || report.load <= 0) return "nothing pulls";
  if (material.criterion == FractureCriterion::separation_force) return "what pulls across the plane";
  return format_quantity(pull, "N") + " over " + format_quantity(pull / report.load, "m²");
}

Verdict verdict_on(const NodeReport& report, const Frame& frame, bool fracture) {
  Verdict verdict = bare_verdict(report, frame, fracture);
  verdict.text += scaling_note(report, frame, verdict.kind == Verdict::Kind::broke);
  return verdict;
}

}  // namespace griffith::ui
