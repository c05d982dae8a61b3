#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "app/cli/commands.h"
#include "app/output/output.h"
#include "app/shared/progress.h"
#include "app/shared/text_table.h"
#include "app/validate/scorecard.h"
#include "sim/core/error.h"
#include "sim/core/read_file.h"
#include "sim/core/replace_file.h"

namespace griffith::app {
namespace {

struct ValidateOptions {
  std::vector<std::string> names;
  bool list = false, quick = false, strict = false;
  int meshes = 0;             ///< number of meshes, the coarsest first; 0: all
  std::filesystem::path out;  ///< empty: stdout
};

/// Returns the chosen experiments. Throws InputError for an unknown name.
std::vector<Experiment> chosen_experiments(const ValidateOptions& options) {
  std::vector<Experiment> chosen;
  for (const std::string& name : options.names)
    if (std::ranges::find(experiments(), name, &Experiment::key) == experiments().end())
      throw InputError("validate", "there is no experiment \"" + name + "\"", "griffith validate --list shows all");
  for (const Experiment& experiment : experiments())
    if ((options.names.empty() || std::ranges::count(options.names, experiment.key) > 0) &&
        (!options.quick || experiment.quick))
      chosen.push_back(experiment);
  for (Experiment& experiment : chosen)
    if (options.meshes > 0) experiment.meshes.resize(std::min<std::size_t>(experiment.meshes.size(), options.meshes));
  return chosen;
}

void list_experiments(const std::vector<Experiment>& chosen) {
  std::vector<std::vector<std::string>> lines = {{"name", "quick", "experiment", "source"}};
  for (const Experiment& experiment : chosen)
    lines.push_back({experiment.key, experiment.quick ? "yes" : "", experiment.title, experiment.source});
  print("%s", text_table(lines).c_str());
}

/// Returns the entries of a page that exists already, so that other experiments keep their place.
Scorecard earlier_entries(const std::filesystem::path& out) {
  return !out.empty() && std::filesystem::exists(out) ? read_scorecard(read_file(out)) : Scorecard{};
}

/// Runs experiments and writes the page. Returns the number of those that fail.
int validate(const ValidateOptions& options, const std::vector<Experiment>& chosen) {
  Scorecard scorecard = earlier_entries(options.out);
  int failures = 0;
  StageProgress progress;
  for (const Experiment& experiment : chosen) {
    const Judgment judgment =
        judge(experiment, [&](const std::string& mesh) { progress.enter(experiment.key + ", " + mesh); });
    scorecard[experiment.key] = scorecard_entry(experiment, judgment);
    failures += judgment.passes() ? 0 : 1;
    progress.note(experiment.key + ": " + (judgment.passes() ? "passes" : "fails, " + judgment.worst));
    if (!options.out.empty()) replace_file(options.out, scorecard_page(scorecard));
  }
  if (options.out.empty()) print("%s", scorecard_page(scorecard).c_str());
  return failures;
}

ExitCode run_validate(const ValidateOptions& options) {
  const std::vector<Experiment> chosen = chosen_experiments(options);
  if (options.list) {
    list_experiments(chosen);
    return kDone;
  }
  if (!options.out.empty()) check_replaceable(options.out);
  return validate(options, chosen) > 0 && options.strict ? kFailed : kDone;
}

}  // namespace

Command add_validate(CLI::App& program) {
  CLI::App* command = program.add_subcommand("validate", "Repeat published experiments and write a scorecard");
  const auto options = std::make_shared<ValidateOptions>();
  command->add_option("NAME", options->names, "Experiments; default: all")->type_name("NAME");
  command->add_flag("--list", options->list, "List the experiments and run none");
  command->add_flag("--quick", options->quick, "Only those that take a few seconds");
  command->add_option("--meshes", options->meshes, "Only the N coarsest meshes of each")
      ->check(CLI::Range(1, 3))
      ->type_name("N");
  command->add_flag("--strict", options->strict, "Exit code 1 if an experiment fails");
  command->add_option("--out", options->out, "Write the page here; parts of other experiments in it stay")
      ->type_name("FILE");
  add_threads(*command);
  command->footer(
      "Examples:\n"
      "  griffith validate --list\n"
      "  griffith validate strip notched_beam --out docs/scorecard.md\n\n"
      "Exit code 0: all were run, pass or fail (docs/scorecard.md).");
  return {command, [options] { return run_validate(*options); }};
}

}  // namespace griffith::app
