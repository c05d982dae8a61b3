#include "app/output/statistics.h"

#include <sys/resource.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string_view>

#include "app/shared/hash_text.h"
#include "app/shared/quantile.h"
#include "sim/world/output/scaled_breaks.h"
#include "sim/world/output/step_counters.h"

namespace griffith::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 7> kPhases = {"step",       "contact",  "elasticity", "explicit",
                                                "separation", "fracture", "processor"};

/// Returns the processor time of all threads so far [ms].
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

/// Returns the place of a key: "energy.gravity" is a member of a member, "momentum.0" an element of a list.
Json& place_of(Json& json, std::string_view key) {
  const std::size_t dot = std::min(key.find('.'), key.size());
  const std::string_view name = key.substr(0, dot);
  const bool is_number = name.find_first_not_of("0123456789") == std::string_view::npos;
  Json& place = is_number ? json[std::stoul(std::string(name))] : json[std::string(name)];
  return dot == key.size() ? place : place_of(place, key.substr(dot + 1));
}

/// Returns the counters that warn, "3 unfinished impacts, 12 unconverged contacts", or "none".
std::string trouble_text(const StepReport& total) {
  std::string text;
  for (const StepCounter& counter : step_counters()) {
    const int count = warnings_of(counter, total);
    if (count == 0) continue;
    std::string label(counter.label);
    label[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(label[0])));
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + label;
  }
  return text.empty() ? "none" : text;
}

/// Returns the stand-in material of a scene body and its reason.
Json scaled_json(int scene_body, const ScaledImpact& impact) {
  return {{"scene_body", scene_body},
          {"factor", impact.factor},
          {"young_modulus", impact.young_modulus},
          {"tensile_strength", impact.tensile_strength},
          {"reason", reason(impact)}};
}

/// Returns the elements of bodies whose scene leaves the choice.
Json element_choices_json(const Frame& frame) {
  Json list = Json::array();
  for (std::size_t i = 0; i < frame.element_choices.size(); ++i) {
    const ElementChoice& choice = frame.element_choices[i];
    if (!choice.automatic) continue;
    list.push_back({{"scene_body", i},
                    {"elements", choice.order == ElementOrder::quadratic ? "quadratic" : "linear"},
                    {"layers", choice.layers},
                    {"reason", choice.reason}});
  }
  return list;
}

/// Returns the number of nodes of a scene body that opened while it was scaled.
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

/// Returns counts as integers, and null for a time that never came.
Json number_of(const OutcomeKind& kind, double value) {
  if (!std::isfinite(value)) return nullptr;
  return kind.unit.empty() ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

void add_outcomes(Json& json, const Outcomes& outcomes) {
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    place_of(json, outcome_kinds()[i].key) = number_of(outcome_kinds()[i], outcomes[i]);
}

}  // namespace

RunStatistics::RunStatistics(const Frame& start, double time_step, int threads)
    : time_step_(time_step), threads_(threads), tally_(start), processor_(processor_milliseconds()) {}

void RunStatistics::add(const Frame& frame) {
  tally_.add(frame);
  for (const BodyView& body : frame.bodies) {
    if (!body.scaled) continue;
    ScaledBody& scaled = scaled_[body.scene_body];
    ++scaled.impacts;
    if (body.scaled->factor < scaled.slowest.factor) scaled = {frame.step, scaled.impacts, *body.scaled};
  }
  const double processor = processor_milliseconds();
  const StepTimings& t = frame.report.milliseconds;
  const std::array<double, 7> times = {t.step,       t.contact,  t.elasticity,          t.explicit_dynamics,
                                       t.separation, t.fracture, processor - processor_};
  for (std::size_t i = 0; i < times.size(); ++i) milliseconds_[i].push_back(times[i]);
  processor_ = processor;
}

std::string RunStatistics::json(const Frame& frame, std::uint64_t state_hash) const {
  Json json;
  json["frames"] = frame.step;
  json["dt"] = time_step_;
  add_outcomes(json, outcomes_of(frame, tally_));
  json["scaled_impacts"] = Json::array();
  for (const auto& [scene_body, scaled] : scaled_) {
    Json& impact = json["scaled_impacts"].emplace_back(scaled_json(scene_body, scaled.slowest));
    impact["impacts"] = scaled.impacts;
    impact["step"] = scaled.step;
  }
  json["broke_scaled"] = broke_scaled_json(frame);
  json["element_choices"] = element_choices_json(frame);
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
  const StepReport& t = tally_.total;
  char text[1024];
  std::snprintf(text, sizeof text,
                "%lld steps of %.4g ms: %zu tetrahedra, %zu nodes, %zu pieces (%d fragments), %zu crack events\n"
                "step time: median %.2f ms, 99 %% below %.2f ms, longest %.2f ms\n"
                "solver: at most %d iterations, relative residual at most %.1e, %d unconverged\n"
                "trouble: %s\n"
                "state hash %s\n",
                static_cast<long long>(frame.step), 1e3 * time_step_, frame.elements.tets.size(),
                frame.nodes.positions.size(), frame.bodies.size(), frame.fragments, frame.crack_events.size(),
                times.median, times.p99, times.max, t.solver_iterations, t.max_relative_residual, t.unconverged_solves,
                trouble_text(t).c_str(), hash_text(state_hash).c_str());
  std::string lines = text;
  for (const auto& [scene_body, scaled] : scaled_) {
    const ScaledImpact& slowest = scaled.slowest;
    std::snprintf(text, sizeof text, "scaled: body %d in %d impacts, down to %.3g Pa and a strength of %.3g Pa: %s\n",
                  scene_body, scaled.impacts, slowest.young_modulus, slowest.tensile_strength, reason(slowest).c_str());
    lines += text;
  }
  for (std::size_t i = 0; i < frame.element_choices.size(); ++i)
    if (frame.element_choices[i].automatic)
      lines += "elements: of body " + std::to_string(i) + " " + text_of(frame.element_choices[i]) + "\n";
  for (const ScaledBreak& broken : scaled_breaks(frame))
    lines += "broke scaled: " + std::to_string(broken.pieces) + " pieces of body " + std::to_string(broken.scene_body) +
             ", at " + scale_text(broken.least) + ": " + reason(broken.least) + "\n";
  return lines;
}

}  // namespace griffith::app
