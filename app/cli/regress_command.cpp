#include <griffith/version.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <set>

#include "app/cli/commands.h"
#include "app/output/output.h"
#include "app/regress/report.h"
#include "app/regress/run_suite.h"
#include "app/regress/suite.h"
#include "app/shared/processes.h"
#include "app/shared/progress.h"
#include "sim/core/error.h"
#include "sim/core/parallel.h"
#include "sim/core/replace_file.h"
#include "sim/core/temporary_folder.h"

namespace griffith::app {
namespace {

struct RegressOptions {
  std::filesystem::path suite;
  std::vector<std::filesystem::path> init;         ///< scenes of a new suite; empty: the suite exists
  std::optional<std::vector<std::string>> accept;  ///< pictures or jobs; empty: all that fail
  std::vector<std::string> only;                   ///< pictures or jobs; empty: all
  Shard shard;
  int processes = 0;  ///< 0: number of cores
  double time_limit = 600;
  std::filesystem::path report, junit;
  std::optional<int> egl_device;
};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// Returns the jobs with or of the named pictures; all if `selected` is empty. Throws InputError for unknown names.
std::vector<RenderJob> selected_jobs(const std::vector<RenderJob>& jobs, const std::vector<std::string>& selected) {
  if (selected.empty()) return jobs;
  std::set<std::string> known;
  std::vector<RenderJob> result;
  for (const RenderJob& job : jobs) {
    std::vector<std::string> names = picture_names(job);
    names.push_back(job.name);
    known.insert(names.begin(), names.end());
    if (std::ranges::any_of(names, [&](const std::string& name) { return contains(selected, name); }))
      result.push_back(job);
  }
  for (const std::string& name : selected)
    if (!known.contains(name))
      throw InputError(name, "is neither a job nor a picture of the suite or shard", "its jobs are in suite.json");
  return result;
}

std::vector<PictureResult> compare_suite(const SuiteRun& run, const std::vector<RenderJob>& jobs,
                                         const std::function<bool()>& cancelled) {
  std::vector<JobOutcome> outcomes;
  {
    Progress progress("Drawing", std::max(static_cast<int>(jobs.size()), 1));
    int done = 0;
    outcomes = draw_suite(
        run, jobs, [&] { progress.update(++done); }, cancelled);
  }
  std::vector<PictureResult> results;
  for (std::size_t i = 0; i < jobs.size(); ++i)
    for (PictureResult& result : compare_job(run, jobs[i], outcomes[i])) results.push_back(std::move(result));
  return results;
}

int print_results(const std::filesystem::path& suite, const std::vector<PictureResult>& results) {
  int failed = 0;
  for (const PictureResult& result : results) {
    if (result.status == PictureStatus::passed) continue;
    ++failed;
    print("%s: %s: %s\n", status_name(result.status), result.name.c_str(), result.reason.c_str());
  }
  print("%zu pictures, %d differ from the accepted ones\n", results.size(), failed);
  if (failed > 0)
    print("to accept them: %s [NAME...]\n", shell_command({"griffith", "regress", suite.string(), "--accept"}).c_str());
  return failed;
}

/// Returns the pictures that are named or belong to named jobs; all if `selected` is empty.
std::set<std::string> selected_pictures(const std::vector<RenderJob>& jobs, const std::vector<std::string>& selected) {
  std::set<std::string> pictures(selected.begin(), selected.end());
  for (const RenderJob& job : jobs)
    if (selected.empty() || contains(selected, job.name))
      for (const std::string& name : picture_names(job)) pictures.insert(name);
  return pictures;
}

/// Returns the renderer of a drawn picture from its record; empty if it was not drawn.
std::string drawn_by(const PictureResult& result) {
  for (const PictureResult::Row& row : result.metadata)
    if (row.name == "renderer" && row.actual) return *row.actual;
  return "";
}

/// Accepts the new pictures that fail as golden ones. Returns the exit code.
ExitCode accept_results(const SuiteRun& run, const std::vector<PictureResult>& results) {
  int accepted = 0, errors = 0;
  for (const PictureResult& result : results) {
    if (result.status == PictureStatus::passed) continue;
    if (result.status == PictureStatus::error) {
      ++errors;
      print("not accepted: %s: %s\n", result.name.c_str(), result.reason.c_str());
      continue;
    }
    accept_picture(run.suite, drawn_by(result), result.name, run.drawn);
    print("accepted %s\n", result.name.c_str());
    ++accepted;
  }
  print("%d %s accepted into %s; look at them before you commit them\n", accepted,
        accepted == 1 ? "picture" : "pictures", (run.suite / kGoldenFolder).c_str());
  return errors == 0 ? kDone : kFailed;
}

void write_reports(const RegressOptions& options, const std::vector<PictureResult>& results, double seconds) {
  ReportHeading heading{options.suite.string(), "", "griffith " GRIFFITH_VERSION,
                        shell_command({"griffith", "regress", options.suite.string(), "--accept"}), seconds};
  std::string goldens_of;
  for (const PictureResult& result : results) {
    if (const std::string renderer = drawn_by(result); !renderer.empty()) heading.renderer = renderer;
    for (const PictureResult::Row& row : result.metadata)
      if (row.name == kGoldensOf) goldens_of = ", compared with golden pictures of " + *row.golden;
  }
  heading.renderer += goldens_of;
  if (!goldens_of.empty()) print("drawn by %s\n", heading.renderer.c_str());
  Outputs outputs;
  outputs.write([&] { replace_file(options.report, report_html(heading, results)); });
  if (!options.junit.empty())
    outputs.write([&] { replace_file(options.junit, junit_xml(options.suite.string(), results)); });
  outputs.finish();
  print("report: %s\n", options.report.c_str());
}

void report_unused(const SuiteRun& run, const std::vector<PictureResult>& results) {
  for (const PictureResult& result : results) {
    if (result.status == PictureStatus::error) continue;
    for (const std::string& name : unused_goldens(run.suite, drawn_by(result), suite_jobs(run.suite, {})))
      print_error("warning: no job draws the golden picture %s; remove its files\n", name.c_str());
    return;
  }
}

/// Checks that the report can be written; accepting writes none.
void check_regress_outputs(const RegressOptions& options) {
  if (options.accept) return check_folder(options.suite / kGoldenFolder);
  check_replaceable(options.report);
  if (!options.junit.empty()) check_replaceable(options.junit);
}

ExitCode regress(RegressOptions options) {
  const auto start = std::chrono::steady_clock::now();
  if (!options.init.empty()) make_suite(options.suite, options.init);
  if (!options.init.empty()) options.accept.emplace();
  const std::vector<std::string>& selected =
      options.accept && !options.accept->empty() ? *options.accept : options.only;
  const std::vector<RenderJob> jobs = selected_jobs(suite_jobs(options.suite, options.shard), selected);
  if (options.report.empty()) options.report = options.suite / "report.html";
  check_regress_outputs(options);
  const TemporaryFolder drawn;
  const SuiteRun run{options.suite, drawn.path(), options.processes > 0 ? options.processes : default_thread_count(),
                     options.time_limit, options.egl_device};
  std::vector<PictureResult> results = compare_suite(run, jobs, [&drawn] { return drawn.termination_requested(); });
  if (drawn.termination_requested()) return kFailed;
  const std::set<std::string> pictures = selected_pictures(jobs, selected);
  std::erase_if(results, [&](const PictureResult& result) { return !pictures.contains(result.name); });
  if (options.accept) return accept_results(run, results);
  const int failed = print_results(options.suite, results);
  write_reports(options, results, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  if (options.only.empty()) report_unused(run, results);
  return failed == 0 ? kDone : kFailed;
}

void add_options(CLI::App& command, RegressOptions& options) {
  command.add_option("DIR", options.suite, "Folder of the suite: suite.json and goldens")->required()->type_name("DIR");
  command.add_option("--init", options.init, "Make a suite of these scenes and accept its pictures")
      ->type_name("SCENE");
  command.add_option("--only", options.only, "Draw and compare only these jobs or pictures")->type_name("NAME");
  command
      .add_option_function<std::string>(
          "--shard", [&options](const std::string& text) { options.shard = shard_from_text(text); },
          "Draw and compare one of N equal shards, for several machines")
      ->type_name("I/N");
  command.add_option("--jobs", options.processes, "Number of parallel processes; default: number of cores")
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  command.add_option("--time-limit", options.time_limit, "Time limit of a job in seconds; default: 600")
      ->check(CLI::Range(1.0, 1e6))
      ->type_name("S");
  command.add_option("--report", options.report, "HTML file to write; default: report.html in the suite's folder")
      ->type_name("FILE");
  command.add_option("--junit", options.junit, "Write the results as JUnit XML, for continuous integration")
      ->type_name("FILE");
  add_egl_device(command, options.egl_device);
}

}  // namespace

Command add_regress(CLI::App& program) {
  CLI::App* command = program.add_subcommand("regress", "Draw a suite of pictures and compare them with accepted ones");
  const auto options = std::make_shared<RegressOptions>();
  add_options(*command, *options);
  const auto accepted = std::make_shared<std::vector<std::string>>();
  CLI::Option* accept =
      command
          ->add_option("--accept", *accepted,
                       "Accept these pictures, or those of these jobs, as golden; without names all that differ")
          ->expected(0, -1)
          ->type_name("[NAME...]");
  command->footer(
      "Examples:\n"
      "  griffith regress pictures --init scenes/wall_small.json scenes/arch.json\n"
      "  griffith regress pictures\n"
      "  griffith regress pictures --accept arch_body_0040\n"
      "  griffith regress pictures --shard 2/5 --junit results.xml --report report.html\n"
      "Exit code: 0 all pictures match, 1 some differ or could not be drawn, 2 bad usage or bad input.");
  return {command, [options, accepted, accept] {
            std::erase(*accepted, "");  // stands for an option without values
            if (*accept) options->accept = *accepted;
            return regress(*options);
          }};
}

}  // namespace griffith::app
