#include "app/study/outcome.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/shared/quantile.h"
#include "sim/core/error.h"
#include "sim/scene/field.h"

namespace griffith::app {
namespace {

double largest_fraction(const EndOfRun& run) {
  const double mass = std::accumulate(run.masses.begin(), run.masses.end(), 0.0);
  return mass > 0 ? run.masses.back() / mass : 0;
}

double first_crack_time(const EndOfRun& run) {
  return run.frame.crack_events.empty() ? kNever : run.frame.crack_events.front().time;
}

using Run = EndOfRun;
constexpr OutcomeKind kKinds[] = {
    {"pieces", "", "Connected pieces at the end, bodies that never broke among them",
     [](const Run& run) { return static_cast<double>(run.frame.bodies.size()); }},
    {"fragments", "", "Pieces beyond the scene's own bodies",
     [](const Run& run) { return static_cast<double>(run.frame.fragments); }},
    {"largest_piece", "-", "Mass of the heaviest piece over that of all", largest_fraction},
    {"mass_p10", "kg", "Mass below which a tenth of the pieces lie",
     [](const Run& run) { return quantile(run.masses, 0.1); }},
    {"mass_p50", "kg", "Mass of the median piece", [](const Run& run) { return quantile(run.masses, 0.5); }},
    {"mass_p90", "kg", "Mass below which nine tenths of the pieces lie",
     [](const Run& run) { return quantile(run.masses, 0.9); }},
    {"crack_events", "", "Nodes at which the mesh parted",
     [](const Run& run) { return static_cast<double>(run.frame.crack_events.size()); }},
    {"crack_area", "m²", "Area that cracks opened, one side of each",
     [](const Run& run) { return run.frame.energy.crack_area; }},
    {"first_crack_time", "s", "When the first node parted; infinite, in tables empty, where none did",
     first_crack_time},
    {"breaking_time", "s", "End of the step in which the first fragment came off; infinite, in tables empty, without",
     [](const Run& run) { return run.tally.breaking_time; }},
    {"peak_utilization", "-", "Highest load over resistance of any node in any step",
     [](const Run& run) { return run.tally.peak_utilization; }},
    {"torn_supports", "", "Cracks at which a support lost its hold",
     [](const Run& run) {
       return static_cast<double>(std::ranges::count(run.frame.crack_events, true, &CrackEvent::torn_off));
     }},
    {"kinetic_energy", "J", "Kinetic energy at the end, projectiles included",
     [](const Run& run) { return run.frame.energy.kinetic; }},
    {"elastic_energy", "J", "Elastic energy at the end", [](const Run& run) { return run.frame.energy.elastic; }},
    {"fracture_energy", "J", "What opening the cracks would take, by toughness and area",
     [](const Run& run) { return run.frame.energy.fracture_energy; }},
    {"energy_put_in", "J", "What projectiles, gravity, loads and supports put in",
     [](const Run& run) { return run.frame.energy.put_in(); }},
    {"energy_lost", "J", "What contacts, damping and plastic flow took",
     [](const Run& run) { return run.frame.energy.lost(); }},
    {"energy_unaccounted", "J", "What the account of energy lacks: an error of the numbers",
     [](const Run& run) { return run.frame.energy.unaccounted(); }},
    {"least_scaling", "-", "Least factor by which an impact was scaled for the step budget; 1: none was",
     [](const Run& run) { return run.tally.least_scaling; }},
    {"trouble", "", "Unconverged solves, inverted tetrahedra and values that are not finite",
     [](const Run& run) { return static_cast<double>(run.tally.trouble); }},
};

}  // namespace

void RunTally::add(const Frame& frame) {
  if (frame.fragments > 0) breaking_time = std::min(breaking_time, frame.time);
  peak_utilization = std::max(peak_utilization, frame.report.peak_utilization);
  for (const BodyView& body : frame.bodies)
    if (body.scaled) least_scaling = std::min(least_scaling, body.scaled->factor);
  trouble += frame.report.unconverged_solves + frame.report.inverted_tets + frame.report.non_finite_values;
}

std::span<const OutcomeKind> outcome_kinds() { return kKinds; }

std::size_t outcome_index(std::string_view key, const std::string& where) {
  const auto* found = std::ranges::find(kKinds, key, &OutcomeKind::key);
  if (found != std::end(kKinds)) return static_cast<std::size_t>(found - kKinds);
  std::vector<std::string_view> known;
  for (const OutcomeKind& kind : kKinds) known.push_back(kind.key);
  throw InputError(where, "\"" + std::string(key) + "\" is no outcome", suggestion(key, known));
}

Outcomes outcomes_of(const Frame& frame, const RunTally& tally) {
  EndOfRun run{frame, tally, {}};
  for (const BodyView& body : frame.bodies) run.masses.push_back(body.mass);
  std::ranges::sort(run.masses);
  Outcomes outcomes;
  for (const OutcomeKind& kind : kKinds) outcomes.push_back(kind.value(run));
  return outcomes;
}

}  // namespace griffith::app
