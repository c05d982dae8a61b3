#include "app/output/outcome.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/shared/quantile.h"
#include "sim/core/error.h"
#include "sim/scene/field.h"
#include "sim/world/output/step_counters.h"

namespace griffith::app {
namespace {

double largest_fraction(const EndOfRun& run) {
  const double mass = std::accumulate(run.masses.begin(), run.masses.end(), 0.0);
  return mass > 0 ? run.masses.back() / mass : 0;
}

double first_crack_time(const EndOfRun& run) {
  return run.frame.crack_events.empty() ? kNever : run.frame.crack_events.front().time;
}

/// Returns the mass without projectiles, which stays constant [kg].
double mass_of_bodies(const Frame& frame) {
  return std::accumulate(frame.nodes.masses.begin(), frame.nodes.masses.end(), 0.0);
}

using Run = EndOfRun;
using enum OutcomeListing;

/// Returns the outcomes with a column in every comparison of runs.
std::vector<OutcomeKind> main_outcomes() {
  return {
      {"pieces", "", "Connected pieces at the end, including unbroken bodies", main,
       [](const Run& run) { return static_cast<double>(run.frame.bodies.size()); }},
      {"fragments", "", "Pieces beyond the scene's own bodies", main,
       [](const Run& run) { return static_cast<double>(run.frame.fragments); }},
      {"largest_piece", "-", "Mass of the heaviest piece over the total mass", main, largest_fraction},
      {"mass_p10", "kg", "10th percentile of the masses of pieces", main,
       [](const Run& run) { return quantile(run.masses, 0.1); }},
      {"mass_p50", "kg", "Mass of the median piece", main, [](const Run& run) { return quantile(run.masses, 0.5); }},
      {"mass_p90", "kg", "90th percentile of the masses of pieces", main,
       [](const Run& run) { return quantile(run.masses, 0.9); }},
      {"crack_events", "", "Nodes at which the mesh separated", main,
       [](const Run& run) { return static_cast<double>(run.frame.crack_events.size()); }},
      {"crack_area", "m²", "Area of cracks, counting one side", main,
       [](const Run& run) { return run.frame.energy.crack_area; }},
      {"first_crack_time", "s", "Time of the first crack; infinite, or empty in tables, if there is none", main,
       first_crack_time},
      {"breaking_time", "s", "End of the step with the first fragment; infinite, or empty in tables, without", main,
       [](const Run& run) { return run.tally.breaking_time; }},
      {"peak_utilization", "-", "Highest load over resistance of any node in any step", main,
       [](const Run& run) { return run.tally.peak_utilization; }},
      {"torn_supports", "", "Cracks at which a support detached", main,
       [](const Run& run) {
         return static_cast<double>(std::ranges::count(run.frame.crack_events, true, &CrackEvent::torn_off));
       }},
      {"kinetic_energy", "J", "Kinetic energy at the end, projectiles included", main,
       [](const Run& run) { return run.frame.totals.kinetic_energy; }},
      {"elastic_energy", "J", "Elastic energy at the end", main,
       [](const Run& run) { return run.frame.totals.elastic_energy; }},
      {"fracture_energy", "J", "Energy of the crack surfaces, from toughness and area", main,
       [](const Run& run) { return run.frame.energy.fracture_energy; }},
      {"energy_put_in", "J", "Energy supplied by projectiles, gravity, loads and supports", main,
       [](const Run& run) { return run.frame.energy.put_in(); }},
      {"energy_lost", "J", "Energy dissipated by contacts, damping and plastic flow", main,
       [](const Run& run) { return run.frame.energy.lost(); }},
      {"energy_unaccounted", "J", "Energy that the account does not explain: the numerical error", main,
       [](const Run& run) { return run.frame.energy.unaccounted(); }},
      {"least_scaling", "-", "Smallest factor of an impact scaled for the step budget; 1: none", main,
       [](const Run& run) { return run.tally.least_scaling; }},
      {"trouble", "", "Sum of all counters that warn: of what did not converge or end, was postponed or omitted", main,
       [](const Run& run) { return static_cast<double>(run.tally.trouble); }},
  };
}

/// Returns the other outcomes of statistics, except counters and energies.
std::vector<OutcomeKind> other_outcomes() {
  std::vector<OutcomeKind> kinds = {
      {"tets", "", "Tetrahedra", more,
       [](const Run& run) { return static_cast<double>(run.frame.elements.tets.size()); }},
      {"nodes", "", "Nodes at the end", more,
       [](const Run& run) { return static_cast<double>(run.frame.nodes.positions.size()); }},
      {"mass", "kg", "Mass of the bodies at the end", more, [](const Run& run) { return mass_of_bodies(run.frame); }},
      {"initial_mass", "kg", "Mass of the bodies before the first step", more,
       [](const Run& run) { return run.tally.initial_mass; }},
      {"cracks", "", "Same as crack_events", other_name,
       [](const Run& run) { return static_cast<double>(run.frame.crack_events.size()); }},
      {"bodies", "", "Same as pieces", other_name,
       [](const Run& run) { return static_cast<double>(run.frame.bodies.size()); }}};
  for (int i = 0; i < 3; ++i) {
    const std::string axis(1, "xyz"[i]), component = "." + std::to_string(i);
    kinds.push_back({"momentum" + component, "kg m/s", "Momentum at the end along " + axis, more,
                     [i](const Run& run) { return run.frame.totals.momentum[i]; }});
    kinds.push_back({"angular_momentum" + component, "kg m²/s", "Angular momentum at the end about " + axis, more,
                     [i](const Run& run) { return run.frame.totals.angular_momentum[i]; }});
  }
  return kinds;
}

OutcomeKind counter_outcome(const StepCounter& counter) {
  const auto value = [counter](const Run& run) {
    return std::visit([&](auto member) { return static_cast<double>(run.tally.total.*member); }, counter.value);
  };
  return {std::string(counter.key), std::string(counter.unit), std::string(counter.meaning), more, value};
}

/// Returns the entries of the energy account.
std::vector<OutcomeKind> energy_outcomes() {
  std::vector<OutcomeKind> kinds;
  for (const EnergyEntry& entry : energy_entries()) {
    const bool known = entry.value == &EnergyAccount::fracture_energy;
    kinds.push_back({"energy." + std::string(entry.key), "J", std::string(entry.meaning), known ? other_name : more,
                     [entry](const Run& run) { return run.frame.energy.*entry.value; }});
  }
  kinds.push_back({"energy.unaccounted", "J", "Same as energy_unaccounted", other_name,
                   [](const Run& run) { return run.frame.energy.unaccounted(); }});
  kinds.push_back({"energy.turned_over", "J", "The sum of all sources of energy", more,
                   [](const Run& run) { return run.frame.energy.turned_over(); }});
  kinds.push_back({"energy.crack_area", "m²", "Same as crack_area", other_name,
                   [](const Run& run) { return run.frame.energy.crack_area; }});
  return kinds;
}

std::vector<OutcomeKind> all_outcomes() {
  std::vector<OutcomeKind> kinds = main_outcomes();
  for (const std::vector<OutcomeKind>& further : {other_outcomes(), energy_outcomes()})
    kinds.insert(kinds.end(), further.begin(), further.end());
  for (const StepCounter& counter : step_counters()) kinds.push_back(counter_outcome(counter));
  return kinds;
}

}  // namespace

RunTally::RunTally(const Frame& start) : initial_mass(mass_of_bodies(start)) { total.substeps = 0; }

void RunTally::add(const Frame& frame) {
  add_step(frame.report, total);
  if (frame.fragments > 0) breaking_time = std::min(breaking_time, frame.time);
  peak_utilization = std::max(peak_utilization, frame.report.peak_utilization);
  for (const BodyView& body : frame.bodies)
    if (body.scaled) least_scaling = std::min(least_scaling, body.scaled->factor);
  trouble += warnings_of(frame.report);
}

std::span<const OutcomeKind> outcome_kinds() {
  static const std::vector<OutcomeKind> kinds = all_outcomes();
  return kinds;
}

std::size_t outcome_index(std::string_view key, const std::string& where) {
  const auto found = std::ranges::find(outcome_kinds(), key, &OutcomeKind::key);
  if (found != outcome_kinds().end()) return static_cast<std::size_t>(found - outcome_kinds().begin());
  std::vector<std::string_view> known;
  for (const OutcomeKind& kind : outcome_kinds()) known.emplace_back(kind.key);
  throw InputError(where, "\"" + std::string(key) + "\" is not an outcome", suggestion(key, known));
}

Outcomes outcomes_of(const Frame& frame, const RunTally& tally) {
  EndOfRun run{frame, tally, {}};
  for (const BodyView& body : frame.bodies) run.masses.push_back(body.mass);
  std::ranges::sort(run.masses);
  Outcomes outcomes;
  for (const OutcomeKind& kind : outcome_kinds()) outcomes.push_back(kind.value(run));
  return outcomes;
}

}  // namespace griffith::app
