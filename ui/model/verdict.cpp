#include "ui/model/verdict.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/fracture/fracture_law.h"
#include "ui/model/units.h"

namespace griffith::ui {
namespace {

// Utilizations: a node is close to fracture above the first; values below the second are rounding errors.
constexpr double kNear = 0.8, kNoise = 1e-6;

/// Duration of an overload in microsteps after which a crack opens.
constexpr char kOverloadTime[] = "for most of the time in which a wave crosses an element";

std::string percent(double fraction) { return format_quantity(100 * fraction, "", 3) + " %"; }

/// Explains why overloaded material has not separated.
std::string reason_unbroken(const Frame& frame, bool fracture) {
  if (!fracture) return "the scene does not let bodies break.";
  if (frame.report.cracks_postponed > 0)
    return "the limit of cracks per step was reached. It breaks in the next step if the load persists.";
  if (frame.report.cracks_suppressed > 0) return "the fragment would have been smaller than the scene allows.";
  const std::string others = "a crack nearby relieved it first, or all its elements lie on one side of the plane.";
  return frame.report.microsteps > 0 ? std::string("the overload has not lasted ") + kOverloadTime + ", " + others
                                     : others;
}

/// Describes a scaled impact. `what`: "Broke", "Its piece broke" or "Shown".
std::string scaled_text(const std::string& what, const ScaledImpact& impact) {
  return " " + what + " at " + scale_text(impact) + ", " + format_quantity(1 / impact.factor, "", 2) +
         " times slower: " + reason(impact) + ".";
}

/// Describes the stand-in material when the node broke, now, or when its piece broke; empty if there was none.
std::string scaling_note(const NodeReport& report, const Frame& frame) {
  const BodyView& body = frame.bodies[report.body];
  if (!report.events.empty())
    if (const auto& scaled = frame.crack_events[report.events.back()].scaled) return scaled_text("Broke", *scaled);
  if (body.scaled) return scaled_text("Shown", *body.scaled);
  return body.broke_scaled ? scaled_text("Its piece broke", *body.broke_scaled) : "";
}

std::string breaking(const CrackEvent& event, std::string_view unit) {
  std::string text = "Broke at " + format_quantity(event.time, "s", 3) + " (step " + std::to_string(step_of(event)) +
                     "): the load of " + format_quantity(event.load, unit, 3) + " was " +
                     percent(event.load / event.resistance) + " of the resistance.";
  if (event.torn_off) text += " A support detached there.";
  return text;
}

/// Explains why an overloaded node that cracks later has not cracked yet; empty if it is not, or other reasons may
/// hold.
std::string wait_for_crack(const Frame& frame, const NodeSeparation& separation) {
  const bool waits = separation.utilization > 1 && frame.report.microsteps > 0 && frame.report.cracks_postponed == 0;
  return waits ? std::string(": a crack opens once that has lasted ") + kOverloadTime : "";
}

/// Predicts the next step, or the rest of one that has `begun`.
std::string about_to_crack(const ComingCrack& coming, bool begun, const Frame& frame, const NodeReport& report,
                           std::string_view unit) {
  std::string text = std::string("Cracks ") + (begun ? "later in this step" : "in the next step") + ", at " +
                     format_quantity(coming.time, "s", begun ? 6 : 3) + " (step " + std::to_string(frame.step + 1) +
                     "): a load of " + format_quantity(coming.load, unit, 3) + " will be " +
                     percent(coming.utilization()) + " of the resistance.";
  if (std::isfinite(report.separation.resistance))
    text += std::string(begun ? " At this moment" : " In this step") + " the load is " +
            percent(report.separation.utilization) + " of it" + wait_for_crack(frame, report.separation) + ".";
  return text;
}

/// Explains what holds a crack that ends at a node.
std::string of_crack_front(const NodeSeparation& separation) {
  if (!std::isfinite(separation.fracture_energy)) return "A crack ends here.";
  const double released = separation.energy_release / separation.fracture_energy;
  const bool by_energy = std::sqrt(released) >= separation.utilization;
  return "A crack ends here. To advance it would release " + format_quantity(separation.energy_release, "J/m²", 3) +
         " of the " + format_quantity(separation.fracture_energy, "J/m²", 3) +
         " that it takes: " + (by_energy ? "energy decides." : "the strength decides.");
}

/// Explains that a peak smaller than a crack needs does not decide alone; empty where it does.
std::string of_average(const NodeSeparation& separation) {
  if (separation.averaging_radius == 0) return "";
  return " A crack needs tension over a distance: within " + format_quantity(separation.averaging_radius, "m", 3) +
         " it is " + format_quantity(separation.mean_tension, "Pa", 3) + " on average.";
}

/// Describes the origin of the tension across the plane at the frame's time.
std::string origin_of_tension(const NodeReport& report) {
  const double pull = report.plane.eigenvalue, stress = report.plane.stress;
  if (report.by_tension) return "the mean tensile stress of its elements";
  if (pull <= 0 || stress <= 0) return "no tension";
  return format_quantity(pull, "N") + " over " + format_quantity(pull / stress, "m²");
}

/// Fills in a sentence of a fracture law, with so many digits.
std::string filled_in(std::string_view sentence, const NodeReport& report, const Material& material, int digits = 4) {
  const FractureLaw& law = fracture_law(material);
  const std::optional<double> property = law.property ? material.*law.property : std::nullopt;
  const std::pair<std::string_view, std::string> values[] = {
      {"{tension}", origin_of_tension(report)},
      {"{stress}", format_quantity(report.plane.stress, "Pa", digits)},
      {"{load}", format_quantity(report.load, law.unit, digits)},
      {"{property}", property ? format_quantity(*property, "Pa", digits) : ""}};
  std::string text(sentence);
  for (const auto& [name, value] : values)
    if (const std::size_t at = text.find(name); at != std::string::npos) text.replace(at, name.size(), value);
  return text;
}

/// Compares the load with the tension across the plane now, which differ by a strength surface; empty if they do not.
std::string of_stress_state(const NodeReport& report, const Material& material) {
  constexpr double kEqual = 0.01;
  const FractureLaw& law = fracture_law(material);
  const double tension = report.plane.stress;
  if (law.difference.empty() || !report.strained ||
      std::abs(report.load - tension) <= kEqual * std::max(report.load, tension))
    return "";
  return " " + filled_in(law.difference, report, material, 3);
}

/// Describes the load on existing material. `whole`: the node has not cracked before.
std::string under_load(const NodeState& state, const NodeReport& report, const Frame& frame, bool fracture) {
  const Material& material = frame.materials[frame.bodies[report.body].scene_body];
  const NodeSeparation& separation = report.separation;
  const std::string what = state.crack ? "The rest holds" : "Holds", share = percent(separation.utilization);
  switch (state.load) {
    case NodeState::Load::unmeasured:
      return state.crack ? "The load on the rest has not been computed yet." : "No load has been computed here yet.";
    case NodeState::Load::none:
      return what + ": there is practically no load.";
    case NodeState::Load::above:
      return state.crack
                 ? "The rest is overloaded, at " + share +
                       " of its resistance, but has not separated: " + reason_unbroken(frame, fracture) +
                       of_stress_state(report, material)
                 : "Overloaded, at " + share + " of its resistance, but intact: " + reason_unbroken(frame, fracture) +
                       of_stress_state(report, material);
    case NodeState::Load::below:
    case NodeState::Load::near:
      break;
  }
  std::string text = what + ": the load of " +
                     format_quantity(load_of(separation, material), fracture_law(material).unit, 3) + " is " + share +
                     " of the resistance.";
  text += of_average(separation);
  text += of_stress_state(report, material);
  if (report.at_crack_front) text += " " + of_crack_front(separation);
  if (separation.eigenvalue <= 0 && separation.utilization <= 0)
    text += " There is no tension: the elements compress the node.";
  return text;
}

/// Explains the effect of the piece's motion on the node; empty: none.
std::string of_piece(NodeState::Piece piece) {
  switch (piece) {
    case NodeState::Piece::elastic:
      return "";
    case NodeState::Piece::asleep:
      return "Its piece is asleep: it stays at rest under its present load until an impact.";
    case NodeState::Piece::rigid:
      return "Its piece moves as a rigid body: its stress stays as it was until an impact.";
    case NodeState::Piece::rigid_asleep:
      return "Its piece is asleep as a rigid body: its stress stays as it was until an impact.";
    case NodeState::Piece::single_element:
      return "A single element cannot break any further.";
  }
  return "";
}

NodeState::Piece piece_state(const BodyView& body) {
  if (body.rigid && body.tets == 1) return NodeState::Piece::single_element;
  if (body.rigid) return body.asleep ? NodeState::Piece::rigid_asleep : NodeState::Piece::rigid;
  return body.asleep ? NodeState::Piece::asleep : NodeState::Piece::elastic;
}

NodeState::Load load_state(const NodeSeparation& separation) {
  if (!std::isfinite(separation.resistance)) return NodeState::Load::unmeasured;
  if (separation.utilization > 1) return NodeState::Load::above;
  if (separation.utilization > kNear) return NodeState::Load::near;
  return separation.utilization > 0 && separation.utilization < kNoise ? NodeState::Load::none : NodeState::Load::below;
}

/// True if the measured load is the one under which the node cracked, not one on the remaining material.
bool is_load_of(const CrackEvent& crack, const NodeSeparation& separation) {
  constexpr double kRoundOff = 1e-9;
  return std::isfinite(separation.resistance) &&
         std::abs(separation.utilization * crack.resistance - crack.load) <= kRoundOff * std::abs(crack.load);
}

Verdict::Kind kind_of(const NodeState& state) {
  const bool measured = state.piece == NodeState::Piece::elastic || state.piece == NodeState::Piece::asleep;
  if (state.coming) return Verdict::Kind::about_to_crack;
  if (measured && state.load == NodeState::Load::above) return Verdict::Kind::overloaded;
  if (state.crack) return Verdict::Kind::broke;
  if (!measured || state.load == NodeState::Load::unmeasured) return Verdict::Kind::unknown;
  return state.load == NodeState::Load::near ? Verdict::Kind::near : Verdict::Kind::holds;
}

/// Returns the verdict without the note on stand-in materials. `begun`: the frame is within a step.
Verdict bare_verdict(const NodeState& state, const NodeReport& report, const Frame& frame, bool fracture, bool begun) {
  const std::string_view unit = fracture_law(frame.materials[frame.bodies[report.body].scene_body]).unit;
  const bool rigid = state.piece != NodeState::Piece::elastic && state.piece != NodeState::Piece::asleep;
  std::vector<std::string> sentences;
  if (state.coming) sentences.push_back(about_to_crack(*state.coming, begun, frame, report, unit));
  if (state.crack) sentences.push_back(breaking(*state.crack, unit));
  if (!rigid && !state.coming) sentences.push_back(under_load(state, report, frame, fracture));
  sentences.push_back(of_piece(state.piece));
  Verdict verdict{kind_of(state), {}};
  for (const std::string& sentence : sentences)
    if (!sentence.empty()) verdict.text += (verdict.text.empty() ? "" : " ") + sentence;
  return verdict;
}

}  // namespace

std::string stand_in_text(const ScaledImpact& impact) {
  return "As a material of " + format_quantity(impact.young_modulus, "Pa", 3) + " with a strength of " +
         format_quantity(impact.tensile_strength, "Pa", 3) + " it breaks at the correct impact speed, " +
         format_quantity(1 / impact.factor, "", 2) + " times slower: " + reason(impact) +
         ". A larger step_budget scales less.";
}

double load_of(const NodeSeparation& separation, const Material& material) {
  return fracture_law(material).is_stress() ? separation.stress : separation.eigenvalue;
}

std::string resistance_text(const NodeSeparation& separation, const Material& material) {
  return std::isfinite(separation.resistance) ? format_quantity(separation.resistance, fracture_law(material).unit)
                                              : "not yet known";
}

const char* contribution_unit(const NodeReport& report) { return report.by_tension ? "Pa" : "N"; }

std::string origin_of_load(const NodeReport& report, const Material& material) {
  const FractureLaw& law = fracture_law(material);
  return law.is_stress() || report.load > 0 ? filled_in(law.origin, report, material) : "no tension";
}

std::optional<ComingCrack> coming_crack(const std::optional<Stop>& stop, NodeId node, const Frame& frame) {
  if (!stop) return {};
  const auto coming = std::ranges::find(stop->cracks, node, &ComingCrack::node);
  if (coming == stop->cracks.end()) return {};
  const bool has_come = std::ranges::any_of(
      frame.crack_events, [&](const CrackEvent& event) { return event.node == node && event.time >= coming->time; });
  return has_come ? std::nullopt : std::optional(*coming);
}

NodeState node_state(const NodeReport& report, const Frame& frame, const std::optional<Stop>& stop) {
  NodeState state;
  state.load = load_state(report.separation);
  state.piece = piece_state(frame.bodies[report.body]);
  if (!report.events.empty()) state.crack = &frame.crack_events[report.events.back()];
  state.cracked_now = state.crack && step_of(*state.crack) == frame.step;
  if (state.cracked_now && is_load_of(*state.crack, report.separation)) state.load = NodeState::Load::unmeasured;
  state.coming = coming_crack(stop, report.node, frame);
  return state;
}

Verdict verdict_on(const NodeReport& report, const Frame& frame, bool fracture, const std::optional<Stop>& stop,
                   bool in_step) {
  const NodeState state = node_state(report, frame, stop);
  Verdict verdict = bare_verdict(state, report, frame, fracture, in_step);
  verdict.text += scaling_note(report, frame);
  return verdict;
}

}  // namespace griffith::ui
