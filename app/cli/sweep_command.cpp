#include <CLI/CLI.hpp>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>

#include "app/cli/commands.h"
#include "app/cli/help_formatter.h"
#include "app/output/output.h"
#include "app/study/outcome_table.h"
#include "app/study/sweep_folder.h"
#include "app/study/sweep_page.h"
#include "app/study/sweep_runs.h"
#include "sim/core/parallel.h"
#include "sim/core/replace_file.h"
#include "sim/core/termination_hold.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

struct SweepOptions {
  SweepDefinition definition;
  fs::path folder;
  fs::path job_list;  ///< empty: runs the jobs itself
  bool collect = false, retry = false;
  std::optional<int> picture_frame;
  JobLimits job_limits;
};

void write_job_list(const Sweep& sweep, const SweepOptions& options) {
  replace_file(options.job_list, job_list(sweep));
  if (sweep.picture_frame) fs::create_directories(sweep.picture_file(0).parent_path());
  print("%s: %zu jobs, one per line\n  here: parallel < %s\n", options.job_list.c_str(), sweep.size(),
        options.job_list.c_str());
  print("  Slurm: sbatch --array=1-%zu --wrap 'sed -n \"${SLURM_ARRAY_TASK_ID}p\" %s | sh'\n", sweep.size(),
        options.job_list.c_str());
  print("then the same command without --list-jobs makes missing runs, the table and the page\n");
}

void say_where_it_stands(const Sweep& sweep, const std::vector<std::optional<RunRecord>>& records) {
  std::size_t made = 0, failed = 0;
  for (const std::optional<RunRecord>& record : records) {
    made += record ? 1 : 0;
    failed += record && !record->error.empty() ? 1 : 0;
  }
  print("%zu of %zu runs are finished", made, sweep.size());
  if (failed > 0) print(", %zu of them failed (--retry repeats them)", failed);
  print("\n%s\n%s\n", (sweep.folder / "outcomes.csv").c_str(), (sweep.folder / "index.html").c_str());
}

/// Makes the missing runs, then the table and the page of all.
void carry_out(const Sweep& sweep, const SweepOptions& options) {
  const TerminationHold hold;
  const auto cancelled = [&hold] { return hold.requested(); };
  if (!options.collect) make_missing_runs(sweep, options.job_limits, cancelled);
  const std::vector<std::optional<RunRecord>> records = read_records(sweep);
  std::string note;
  if (sweep.picture_frame && !options.collect)
    note = make_missing_pictures(sweep, records, options.job_limits, cancelled);
  if (hold.requested()) {
    print_error("interrupted: %zu of %zu runs remain; repeat the command to continue\n", missing_runs(sweep).size(),
                sweep.size());
    return;
  }
  if (!note.empty()) note = "Pictures are missing: " + note;
  if (!note.empty()) print_error("%s\n", note.c_str());
  replace_file(sweep.folder / "outcomes.csv", outcome_csv(sweep, records));
  replace_file(sweep.folder / "index.html", sweep_page(sweep, records, note));
  say_where_it_stands(sweep, records);
}

void run_sweep(const SweepOptions& options) {
  check_folder(options.folder);
  if (!options.job_list.empty()) check_replaceable(options.job_list);
  Sweep sweep = make_sweep(options.definition, options.folder);
  sweep.picture_frame = options.picture_frame;
  const FolderLock lock(sweep.folder);
  prepare_folder(sweep);
  if (options.retry) remove_failed_records(sweep);
  if (options.job_list.empty()) {
    carry_out(sweep, options);
  } else {
    write_job_list(sweep, options);
  }
}

std::string outcome_help() {
  std::string text = "Outcomes:\n";
  for (const OutcomeKind& kind : outcome_kinds()) {
    const std::string unit = kind.unit.empty() || kind.unit == "-" ? "" : " [" + std::string(kind.unit) + "]";
    text += "  " + wrapped(kind.key + unit + ": " + kind.meaning, 118, "      ") + "\n";
  }
  return text;
}

void add_what_varies(CLI::App& command, SweepDefinition& sweep) {
  command
      .add_option("--vary", sweep.vary,
                  "A field and its values: a list (2,4,8), evenly spaced (1:10:4), logarithmically spaced "
                  "(1e9:1e11:5log), or a range (1:10, 1:10:log) for --latin-hypercube. Several are combined")
      ->allow_extra_args(false)
      ->type_name("POINTER=VALUES");
  add_settings(command, sweep.set);
  command.add_option("--latin-hypercube", sweep.samples, "Sample N points of all ranges together in a Latin hypercube")
      ->check(CLI::Range(1, 100'000))
      ->type_name("N");
  command.add_option("--seed", sweep.seed, "Random seed of those points; default: 1")->type_name("S");
  command.add_option("--seeds", sweep.seeds, "Repeat each run with N seeds of the bodies' random strength")
      ->check(CLI::Range(1, 100'000))
      ->type_name("N");
  command.add_option("--frames", sweep.frames, "Time steps of each run")
      ->required()
      ->check(CLI::Range(0, kMaxFrames))
      ->type_name("N");
}

}  // namespace

void add_job_limits(CLI::App& command, JobLimits& job_limits) {
  job_limits.jobs = default_thread_count();
  job_limits.limits = {1e9, std::numeric_limits<std::int64_t>::max()};
  command.add_option("--jobs", job_limits.jobs, "Number of parallel runs; default: number of processors")
      ->check(CLI::Range(1, 1024))
      ->type_name("J");
  command.add_option("--time-limit", job_limits.limits.seconds, "Time limit of a run in seconds")
      ->check(CLI::Range(0.01, 1e9))
      ->type_name("S");
  command
      .add_option_function<std::int64_t>(
          "--memory-limit",
          [&job_limits](const std::int64_t& megabytes) { job_limits.limits.memory_bytes = megabytes << 20; },
          "Limit of a run's address space in megabytes")
      ->check(CLI::Range(16, 1 << 30))
      ->type_name("MB");
}

Command add_sweep(CLI::App& program) {
  CLI::App* command = program.add_subcommand("sweep", "Run a scene with many values of its fields");
  const auto options = std::make_shared<SweepOptions>();
  command->add_option("SCENE", options->definition.scene, "Scene file")->required()->type_name("FILE");
  add_what_varies(*command, options->definition);
  command->add_option("-o,--output", options->folder, "Folder of the results; a sweep in it is continued")
      ->required()
      ->type_name("DIR");
  command->add_option("--picture-frame", options->picture_frame, "Picture of each run after K steps, for the page")
      ->check(CLI::Range(0, kMaxFrames))
      ->type_name("K");
  add_job_limits(*command, options->job_limits);
  CLI::Option* jobs =
      command->add_option("--list-jobs", options->job_list,
                          "Write a shell command for each run instead of running it: for GNU parallel, Slurm");
  jobs->type_name("FILE");
  command->add_flag("--collect", options->collect, "Make only the table and the page of finished runs")->excludes(jobs);
  command->add_flag("--retry", options->retry, "Repeat failed runs");
  command->footer(
      "Examples:\n"
      "  griffith sweep scenes/glass_pane.json --frames 60 --vary projectiles/0/speed=5:40:8 -o speeds\n"
      "  griffith sweep scenes/glass_pane.json --frames 60 --vary projectiles/0/speed=5:40:4 \\\n"
      "    --vary bodies/0/material/tensile_strength=1e6:1e7:5log --picture-frame 60 -o strengths\n"
      "  griffith sweep scenes/wall_small.json --frames 90 --vary projectiles/0/speed=5:40 \\\n"
      "    --vary bodies/0/material/density=1500:2500 --latin-hypercube 50 -o cube --list-jobs jobs.txt\n\n" +
      outcome_help());
  return {command, [options] {
            run_sweep(*options);
            return kDone;
          }};
}

}  // namespace griffith::app
