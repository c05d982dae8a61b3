#include "app/output/statistics.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/shared/components.h"
#include "app/shared/hash_text.h"
#include "app/shared/quantile.h"
#include "sim/world/scaled_breaks.h"
#include "sim/world/step_counters.h"

namespace griffith::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 7> kPhases = {"step",       "contact",  "elasticity", "shock",
                                                "separation", "fracture", "processor"};

/// Milliseconds of processor time that all threads have taken so far.
double processor_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct TimeSummary {
  double median = 0, p99 = 0, max = 0, total = 0;
};

TimeSummary summarize(const std::vector<double>& times) {
  return {quantile(times, 0.5), quantile(times, 0.99), quantile(times, 1),
          std::accumulate(times.begin(), times.end(), 0.0)};
}

std::int64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

/// Of one scene body: the material that stood in for its own, and why.
Json scaled_json(int scene_body, const ScaledImpact& impact) {
  return {{"scene_body", scene_body},
          {"factor", impact.factor},
          {"young_modulus", impact.young_modulus},
          {"tensile_strength", impact.tensile_strength},
          {"reason", reason(impact)}};
}

/// Nodes of a scene body that opened while it was scaled.
std::ptrdiff_t scaled_cracks(const Frame& frame, int scene_body) {
  return std::ranges::count_if(frame.crack_events, [&](const CrackEvent& event) {
    return event.scaled && frame.bodies[event.body].scene_body == scene_body;
  });
}

Json broke_scaled_json(const Frame& frame) {
  Json list = Json::array();
  for (const ScaledBreak& broken : scaled_breaks(frame)) {
    Json& json = list.emplace_back(scaled_json(broken.scene_body, broken.least));
    json["pieces"] = broken.pieces;
    json["cracks"] = scaled_cracks(frame, broken.scene_body);
  }
  return list;
}

void add_counters(Json& json, const StepReport& total) {
  for (const StepCounter& counter : step_counters())
    std::visit([&](auto value) { json[counter.key] = total.*value; }, counter.value);
}

/// Mass without the projectiles, so that it stays what it was [kg].
double mass_of_bodies(const Frame& frame) {
  return std::accumulate(frame.nodes.masses.begin(), frame.nodes.masses.end(), 0.0);
}

void add_totals(Json& json, const Totals& totals) {
  json["momentum"] = components(totals.momentum);
  json["angular_momentum"] = components(totals.angular_momentum);
  json["kinetic_energy"] = totals.kinetic_energy;
  json["elastic_energy"] = totals.elastic_energy;
}

/// Where the energy came from and went, as EnergyAccount says.
void add_energy(Json& json, const EnergyAccount& energy) {
  Json& account = json["energy"];
  for (const EnergyEntry& entry : energy_entries()) account[entry.key] = energy.*entry.value;
  account["unaccounted"] = energy.unaccounted();
  account["turned_over"] = energy.turned_over();
  account["crack_area"] = energy.crack_area;
}

}  // namespace

RunStatistics::RunStatistics(const Frame& start, double time_step, int threads)
    : time_step_(time_step),
      threads_(threads),
      initial_mass_(mass_of_bodies(start)),
      processor_(processor_milliseconds()) {
  total_.substeps = 0;
}

void RunStatistics::add(const Frame& frame) {
  add_step(frame.report, total_);
  for (const BodyView& body : frame.bodies) {
    if (!body.scaled) continue;
    ScaledBody& scaled = scaled_[body.scene_body];
    ++scaled.impacts;
    if (body.scaled->factor < scaled.slowest.factor) scaled = {frame.step, scaled.impacts, *body.scaled};
  }
  const double processor = processor_milliseconds();
  const StepTimings& t = frame.report.milliseconds;
  const std::array<double, 7> times = {t.step,       t.contact,  t.elasticity,          t.shock,
                                       t.separation, t.fracture, processor - processor_};
  for (std::size_t i = 0; i < times.size(); ++i) milliseconds_[i].push_back(times[i]);
  processor_ = processor;
}

std::string RunStatistics::json(const Frame& frame, std::uint64_t state_hash) const {
  Json json;
  json["frames"] = frame.step;
  json["dt"] = time_step_;
  json["tets"] = frame.elements.tets.size();
  json["nodes"] = frame.nodes.positions.size();
  json["bodies"] = frame.bodies.size();
  json["fragments"] = frame.fragments;
  json["crack_events"] = frame.crack_events.size();
  json["mass"] = mass_of_bodies(frame);
  json["initial_mass"] = initial_mass_;
  add_totals(json, frame.totals);
  add_energy(json, frame.energy);
  add_counters(json, total_);
  json["scaled_impacts"] = Json::array();
  for (const auto& [scene_body, scaled] : scaled_) {
    Json& impact = json["scaled_impacts"].emplace_back(scaled_json(scene_body, scaled.slowest));
    impact["impacts"] = scaled.impacts;
    impact["step"] = scaled.step;
  }
  json["broke_scaled"] = broke_scaled_json(frame);
  json["state_hash"] = hash_text(state_hash);
  json["threads"] = threads_;
  json["peak_memory_bytes"] = peak_memory_bytes();
  for (std::size_t i = 0; i < kPhases.size(); ++i) {
    const TimeSummary times = summarize(milliseconds_[i]);
    json["ms"][kPhases[i]] = {{"median", times.median}, {"p99", times.p99}, {"max", times.max}, {"total", times.total}};
  }
  return json.dump(2) + "\n";
}

std::string RunStatistics::summary(const Frame& frame, std::uint64_t state_hash) const {
  const TimeSummary times = summarize(milliseconds_[0]);
  const StepReport& t = total_;
  char text[1024];
  std::snprintf(text, sizeof text,
                "%lld steps of %.4g ms: %zu tetrahedra, %zu nodes, %zu pieces (%d fragments), %zu crack events\n"
                "step time: median %.2f ms, 99 %% below %.2f ms, longest %.2f ms\n"
                "solver: at most %d iterations, relative residual at most %.1e, %d unconverged\n"
                "trouble: %d cracks postponed, %d suppressed, %d unfinished equilibria, %d inverted tetrahedra, %d "
                "values not finite\n"
                "state hash %s\n",
                static_cast<long long>(frame.step), 1e3 * time_step_, frame.elements.tets.size(),
                frame.nodes.positions.size(), frame.bodies.size(), frame.fragments, frame.crack_events.size(),
                times.median, times.p99, times.max, t.solver_iterations, t.max_relative_residual, t.unconverged_solves,
                t.cracks_postponed, t.cracks_suppressed, t.unfinished_equilibria, t.inverted_tets, t.non_finite_values,
                hash_text(state_hash).c_str());
  std::string lines = text;
  for (const auto& [scene_body, scaled] : scaled_) {
    const ScaledImpact& slowest = scaled.slowest;
    std::snprintf(text, sizeof text, "scaled: body %d in %d impacts, down to %.3g Pa and a strength of %.3g Pa: %s\n",
                  scene_body, scaled.impacts, slowest.young_modulus, slowest.tensile_strength, reason(slowest).c_str());
    lines += text;
  }
  for (const ScaledBreak& broken : scaled_breaks(frame))
    lines += "broke scaled: " + std::to_string(broken.pieces) + " pieces of body " + std::to_string(broken.scene_body) +
             ", at " + scale_text(broken.least) + ": " + reason(broken.least) + "\n";
  return lines;
}

}  // namespace griffith::app
