#include "app/output/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/output/outcome.h"
#include "app/shared/hash_text.h"
#include "program.h"
#include "sim/core/replace_file.h"
#include "sim/world/output/step_counters.h"
#include "sim/world/world.h"

namespace griffith::app {
namespace {

using Json = nlohmann::json;

Json stats_of(const std::string& arguments) {
  const std::filesystem::path path = test_folder() / "stats.json";
  const Outcome outcome =
      run_program("simulate " + small_wall_file().string() + " --stats " + path.string() + " " + arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  std::ifstream file(path);
  return Json::parse(file);
}

/// Totals of the counters of a run.
StepReport run_to(World& world, int steps) {
  StepReport total;
  total.substeps = 0;
  for (int i = 0; i < steps; ++i) {
    world.step();
    add_step(world.frame().report, total);
  }
  return total;
}

double mass_of_nodes(const Frame& frame) {
  return std::accumulate(frame.nodes.masses.begin(), frame.nodes.masses.end(), 0.0);
}

TEST(Statistics, AreThoseOfTheRun) {
  const Json stats = stats_of("--frames 25 --threads 1");
  World world(small_wall());
  const double initial_mass = mass_of_nodes(world.frame());
  const StepReport total = run_to(world, 25);
  const Frame frame = world.frame();
  EXPECT_EQ(stats["frames"], 25);
  EXPECT_EQ(stats["threads"], 1);
  EXPECT_EQ(stats["dt"], small_wall().simulation.time_step);
  EXPECT_EQ(stats["tets"], frame.elements.tets.size());
  EXPECT_EQ(stats["nodes"], frame.nodes.positions.size());
  EXPECT_EQ(stats["bodies"], frame.bodies.size());
  EXPECT_EQ(stats["fragments"], frame.fragments);
  EXPECT_EQ(stats["crack_events"], frame.crack_events.size());
  EXPECT_EQ(stats["initial_mass"], initial_mass);
  EXPECT_EQ(stats["mass"], mass_of_nodes(frame));
  EXPECT_EQ(stats["kinetic_energy"], frame.totals.kinetic_energy);
  EXPECT_EQ(stats["elastic_energy"], frame.totals.elastic_energy);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(stats["momentum"][axis], frame.totals.momentum[axis]);
    EXPECT_EQ(stats["angular_momentum"][axis], frame.totals.angular_momentum[axis]);
  }
  for (const StepCounter& counter : step_counters())
    std::visit([&](auto value) { EXPECT_EQ(stats[counter.key], total.*value) << counter.key; }, counter.value);
  for (const EnergyEntry& entry : energy_entries())
    EXPECT_EQ(stats["energy"][entry.key], frame.energy.*entry.value) << entry.key;
  EXPECT_LT(std::abs(stats["energy"]["unaccounted"].get<double>()), 0.01 * frame.energy.turned_over());
  EXPECT_EQ(stats["state_hash"], hash_text(world.state_hash()));
  EXPECT_GT(frame.crack_events.size(), 0u) << "or the run tests little";
}

TEST(Statistics, TimesOfPhasesAreOrderedPartsOfTheStep) {
  const Json stats = stats_of("--frames 25 --threads 1");
  EXPECT_GT(stats["peak_memory_bytes"], 1'000'000);
  double phases = 0;
  for (const char* phase : {"step", "contact", "elasticity", "explicit", "separation", "fracture"}) {
    const Json& times = stats["ms"][phase];
    EXPECT_LE(times["median"].get<double>(), times["p99"].get<double>()) << phase;
    EXPECT_LE(times["p99"].get<double>(), times["max"].get<double>()) << phase;
    EXPECT_LE(times["max"].get<double>(), times["total"].get<double>() * (1 + 1e-12)) << phase;
    if (phase != std::string_view("step")) phases += times["total"].get<double>();
  }
  EXPECT_GT(phases, 0);
  EXPECT_LE(phases, stats["ms"]["step"]["total"].get<double>() * (1 + 1e-9));
}

/// The numbers of a document by their places: "energy.gravity", "momentum.0".
void collect_numbers(const Json& json, const std::string& place, std::map<std::string, double>& numbers) {
  if (json.is_number()) numbers[place] = json.get<double>();
  if (!json.is_structured()) return;
  for (const auto& [name, value] : json.items())
    collect_numbers(value, place.empty() ? name : place + "." + name, numbers);
}

/// One table has them: what statistics tell can be looked for and swept over, but for what no two runs share.
TEST(Statistics, EachQuantityIsAnOutcome) {
  const auto outcomes_file = test_folder() / "outcomes.json";
  Json stats = stats_of("--frames 12 --outcomes " + outcomes_file.string());
  for (const char* name : {"frames", "dt", "threads", "peak_memory_bytes", "ms", "scaled_impacts", "element_choices"})
    stats.erase(name);
  std::ifstream file(outcomes_file);
  const Json outcomes = Json::parse(file)["outcomes"];
  std::map<std::string, double> numbers;
  collect_numbers(stats, "", numbers);
  EXPECT_GT(numbers.size(), 60u);
  for (const auto& [place, number] : numbers) {
    ASSERT_TRUE(outcomes.contains(place)) << place;
    EXPECT_EQ(outcomes[place].get<double>(), number) << place;
    EXPECT_EQ(outcome_kinds()[outcome_index(place, "")].key, place);
  }
}

TEST(Statistics, NumberOfThreadsChangesNothingButItself) {
  Json one = stats_of("--frames 25 --threads 1"), two = stats_of("--frames 25 --threads 2");
  for (Json* stats : {&one, &two}) {
    for (const char* name : {"threads", "ms", "peak_memory_bytes"}) stats->erase(name);
  }
  EXPECT_EQ(one, two);
}

TEST(Statistics, SumsAndLargestValuesOverSteps) {
  Frame frame;
  RunStatistics statistics(frame, 0.01, 3);
  for (int step = 1; step <= 100; ++step) {
    frame.step = step;
    frame.report = {};
    frame.report.substeps = 2;
    frame.report.solver_iterations = step == 40 ? 77 : 5;
    frame.report.cracks_postponed = 1;
    frame.report.milliseconds.step = step;
    statistics.add(frame);
  }
  const Json stats = Json::parse(statistics.json(frame, 0xabcdef));
  EXPECT_EQ(stats["substeps"], 200);
  EXPECT_EQ(stats["solver_iterations"], 77);
  EXPECT_EQ(stats["cracks_postponed"], 100);
  EXPECT_EQ(stats["state_hash"], "0000000000abcdef");
  EXPECT_EQ(stats["ms"]["step"]["max"], 100);
  EXPECT_EQ(stats["ms"]["step"]["total"], 5050);
  EXPECT_NEAR(stats["ms"]["step"]["median"].get<double>(), 50.5, 0.51);
  EXPECT_NEAR(stats["ms"]["step"]["p99"].get<double>(), 99, 0.51);
}

/// Pieces broke scaled long before the last step.
TEST(Statistics, WhatBrokeScaledIsCountedAtTheEnd) {
  ScaledImpact slow, slower;
  slow.factor = 0.5;
  slower.factor = 0.25;
  std::vector<BodyView> bodies(4);
  for (BodyView& body : bodies) body.tets = 1;
  for (int i = 0; i < 4; ++i) bodies[static_cast<std::size_t>(i)].id = BodyId(i);
  bodies[1].broke_scaled = slow;
  bodies[2].broke_scaled = slower;
  bodies[3].scene_body = 1;
  std::vector<CrackEvent> events(3);
  for (CrackEvent& event : events) event.body = BodyId(1);
  events[0].scaled = slow;
  events[1].scaled = slower;
  Frame frame;
  frame.bodies = bodies;
  frame.crack_events = events;
  const RunStatistics statistics(Frame(), 0.01, 1);
  const Json stats = Json::parse(statistics.json(frame, 0));
  ASSERT_EQ(stats["broke_scaled"].size(), 1u);
  const Json& broken = stats["broke_scaled"][0];
  EXPECT_EQ(broken["scene_body"], 0);
  EXPECT_EQ(broken["pieces"], 2);
  EXPECT_EQ(broken["cracks"], 2);
  EXPECT_EQ(broken["factor"], 0.25);
  EXPECT_TRUE(stats["scaled_impacts"].empty());
  EXPECT_NE(statistics.summary(frame, 0).find("broke scaled: 2 pieces of body 0, at E/16, σ/4"), std::string::npos);
}

TEST(Statistics, FileIsReplacedAsAWhole) {
  const std::filesystem::path path = test_file("out.json", "old");
  replace_file(path, "new");
  std::ifstream file(path);
  std::string text;
  file >> text;
  EXPECT_EQ(text, "new");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path.parent_path()), {}), 1);
}

}  // namespace
}  // namespace griffith::app
