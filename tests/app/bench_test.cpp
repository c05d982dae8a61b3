// Timing scenes from the command line. Times themselves are no matter of tests.

#include "app/study/bench.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.h"
#include "sim/core/read_file.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;

TEST(Bench, ReportsTimesMemoryAndStateOfEachSceneAndNumberOfThreads) {
  const std::filesystem::path scene = small_wall_file(), file = test_folder() / "times.json";
  const Outcome outcome =
      run_program("bench --frames 12 --repeats 2 --thread-counts 1,2 " + scene.string() + " --json " + file.string());
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("bytes/tet"));
  const nlohmann::json json = nlohmann::json::parse(read_file(file));
  EXPECT_EQ(json.at("repeats"), 2);
  ASSERT_EQ(json.at("runs").size(), 2u);
  for (int i : {0, 1}) {
    const nlohmann::json& run = json["runs"][i];
    EXPECT_EQ(run.at("threads"), i + 1);
    EXPECT_GT(run.at("tets"), 10);
    EXPECT_GT(run.at("memory_bytes"), 0);
    EXPECT_EQ(run.at("state_hash"), json["runs"][0]["state_hash"]);
    const nlohmann::json& step = run.at("ms").at("step");
    EXPECT_GT(step.at("median"), 0);
    EXPECT_LE(step.at("median"), step.at("p99"));
    EXPECT_LE(step.at("p99"), step.at("max"));
    double phases = 0;
    for (const char* phase : {"contact", "elasticity", "explicit", "separation", "fracture"})
      phases += run["ms"].at(phase).at("mean").get<double>();
    EXPECT_LE(phases, step.at("mean").get<double>() * (1 + 1e-9)) << "phases do not overlap";
    for (const char* phase : {"contact", "elasticity", "separation", "processor"})
      EXPECT_GT(run["ms"].at(phase).at("mean"), 0) << phase;
  }
}

TEST(Bench, RefusesWhatItCannotTimeBeforeAnyRun) {
  const std::string scene = small_wall_file().string();
  const Outcome missing = run_program("bench " + scene + " none.json");
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.output, HasSubstr("none.json"));
  const Outcome setting = run_program("bench " + scene + " --set bodies/0/material/density=-1");
  EXPECT_EQ(setting.code, 2);
  EXPECT_THAT(setting.output, HasSubstr("#/bodies/0/material/density: is -1"));
  const Outcome output = run_program("bench " + scene + " --json /no/such/folder/times.json");
  EXPECT_EQ(output.code, 2);
  EXPECT_THAT(output.output, HasSubstr("/no/such/folder"));
}

}  // namespace
}  // namespace griffith::app
