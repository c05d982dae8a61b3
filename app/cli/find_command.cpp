#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "app/cli/commands.h"
#include "app/output/output.h"
#include "app/study/find_report.h"
#include "sim/core/replace_file.h"

namespace griffith::app {
namespace {

struct FindOptions {
  FindDefinition definition;
  std::filesystem::path report;  ///< JSON; empty: none
  JobLimits job_limits;
};

/// Parses "1%" or "0.01" into a fraction. Returns an error text for CLI11, or an empty one.
std::string read_tolerance(const std::string& text, double& tolerance) {
  char* end = nullptr;
  tolerance = std::strtod(text.c_str(), &end);
  const bool percent = *end == '%';
  if (percent) tolerance /= 100;
  if (end != text.c_str() && end[percent ? 1 : 0] == 0 && tolerance >= 1e-6 && tolerance <= 0.5) return {};
  return "--tolerance: \"" + text + "\" is not a tolerance: write 1% or 0.01, from 0.0001% to 50%";
}

/// Runs the search. True if all conditions hold at some value.
bool run_find(const FindOptions& options) {
  if (!options.report.empty()) check_replaceable(options.report);
  const Find search = make_find(options.definition, options.job_limits);
  const Trials trials = find(search, options.job_limits);
  print("%s", find_text(search, trials).c_str());
  if (!options.report.empty()) replace_file(options.report, find_json(search, trials));
  return !holding_intervals(trials).empty();
}

void add_search(CLI::App& command, FindDefinition& find) {
  command
      .add_option("--parameter", find.parameter,
                  "The field to change: alone (the search widens from its value), with a range (1:40, 1:40:9) or with "
                  "the only values to try (2,3,4)")
      ->required()
      ->type_name("POINTER[=VALUES]");
  command
      .add_option(
          "--outcome,--condition", find.conditions,
          "Condition that must hold, such as \"pieces > 1\" or \"projectiles/0/speed=3: pieces in 15:25\"; may be "
          "repeated. "
          "griffith sweep --help lists the outcomes: cracks, pieces, crack_area and every quantity of simulate --stats")
      ->required()
      ->allow_extra_args(false)
      ->type_name("EXPRESSION");
  command.add_option("--frames", find.frames, "Time steps of each run")
      ->required()
      ->check(CLI::Range(0, kMaxFrames))
      ->type_name("N");
  command
      .add_option_function<std::string>(
          "--tolerance",
          [&find](const std::string& text) {
            const std::string problem = read_tolerance(text, find.tolerance);
            if (!problem.empty()) throw CLI::ValidationError(problem);
          },
          "Relative width of a threshold's bracket; default: 1%")
      ->type_name("T");
  command.add_option("--points", find.points, "Values over a range before bisection; default: 5")
      ->check(CLI::Range(2, 1000))
      ->type_name("N");
}

}  // namespace

Command add_find(CLI::App& program) {
  CLI::App* command = program.add_subcommand("find", "Find the values of a field for which conditions on a run hold");
  const auto options = std::make_shared<FindOptions>();
  command->add_option("SCENE", options->definition.scene, "Scene file")->required()->type_name("FILE");
  add_search(*command, options->definition);
  add_settings(*command, options->definition.set);
  command
      ->add_option(
          "--vary", options->definition.vary,
          "Try each value with all of these, such as projectiles/0/position/0=-0.1:0.1:5, and report the probability")
      ->allow_extra_args(false)
      ->type_name("POINTER=VALUES");
  command
      ->add_option("--seeds", options->definition.seeds,
                   "Try each value with N seeds of the bodies' random strength, and report the probability")
      ->check(CLI::Range(1, 100'000))
      ->type_name("N");
  command->add_option("--report", options->report, "Also write the result as JSON")->type_name("FILE");
  add_job_limits(*command, options->job_limits);
  command->footer(
      "Examples:\n"
      "  griffith find scenes/glass_pane.json --frames 30 --parameter projectiles/0/speed --outcome \"pieces > 1\"\n"
      "  griffith find scenes/glass_pane.json --frames 30 --parameter bodies/0/material/tensile_strength=1e6:1e8 \\\n"
      "    --outcome \"projectiles/0/speed=2: pieces == 1\" --outcome \"projectiles/0/speed=8: pieces in "
      "15:60\"\n\n"
      "Exit code 1: no value holds.");
  return {command, [options] { return run_find(*options) ? kDone : kFailed; }};
}

}  // namespace griffith::app
