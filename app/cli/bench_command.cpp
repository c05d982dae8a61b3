#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/cli/commands.h"
#include "app/output/output.h"
#include "app/shared/scene_files.h"
#include "app/study/bench.h"
#include "sim/core/error.h"
#include "sim/core/replace_file.h"
#include "sim/core/termination_hold.h"

namespace griffith::app {
namespace {

struct BenchOptions {
  BenchDefinition definition;
  std::vector<std::string> set;  ///< "POINTER=VALUE"
  std::filesystem::path json;    ///< empty: prints only the table
};

void bench(BenchOptions options) {
  BenchDefinition& definition = options.definition;
  if (!options.json.empty()) check_replaceable(options.json);
  definition.settings = settings(options.set);
  if (definition.scenes.empty()) definition.scenes = scene_files({});
  if (definition.scenes.empty())
    throw InputError("bench", "there is no folder of scenes here or above the program", "name the scenes to time");
  const TerminationHold hold;
  const std::vector<BenchResult> results = run_bench(definition, [&hold] { return hold.requested(); });
  print("%s", bench_table(results).c_str());
  std::fflush(stdout);  // a pending signal ends the program below
  if (!options.json.empty()) replace_file(options.json, bench_json(definition, results));
}

}  // namespace

Command add_bench(CLI::App& program) {
  CLI::App* command = program.add_subcommand("bench", "Measure the step times of scenes");
  const auto options = std::make_shared<BenchOptions>();
  BenchDefinition& definition = options->definition;
  command->add_option("SCENE", definition.scenes, "Scene files; default: all sample scenes")->type_name("FILE");
  add_settings(*command, options->set);
  command->add_option("--frames", definition.frames, "Time steps of each run; default: 120")
      ->check(CLI::Range(1, kMaxFrames))
      ->type_name("N");
  command
      ->add_option("--repeats", definition.repeats,
                   "Repeats of each measurement, of which the minimum counts; default: 3")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  command->add_option("--thread-counts", definition.threads, "Thread counts to compare; default: 1,2")
      ->delimiter(',')
      ->allow_extra_args(false)  // what follows is a scene
      ->check(CLI::Range(1, 1024))
      ->type_name("LIST");
  command->add_option("--json", options->json, "Also write all measurements as JSON")->type_name("FILE");
  command->footer(
      "Examples:\n"
      "  griffith bench scenes/wall_large.json scenes/glass_pane.json\n"
      "  griffith bench --frames 60 --repeats 5 --thread-counts 1 --json times.json\n\n"
      "Every run is a separate process. The minimum of several is reported, since other load only adds to it. A scene\n"
      "whose final state depends on the number of threads or differs between runs is an error: results are "
      "reproducible\nto the bit.");
  return {command, [options] {
            bench(*options);
            return kDone;
          }};
}

}  // namespace griffith::app
