#include "app/study/sweep_runs.h"

#include <mutex>

#include "app/shared/processes.h"
#include "app/shared/progress.h"
#include "app/study/sweep_folder.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

/// Progress reported by several threads.
class SharedProgress {
 public:
  SharedProgress(const char* label, std::size_t total) : progress_(label, static_cast<int>(total)) {}

  void add_one() {
    const std::lock_guard lock(mutex_);
    progress_.update(++done_);
  }

 private:
  std::mutex mutex_;
  Progress progress_;
  int done_ = 0;
};

std::vector<std::size_t> without_picture(const Sweep& sweep, const std::vector<std::optional<RunRecord>>& records) {
  std::vector<std::size_t> runs;
  std::error_code error;
  for (std::size_t run = 0; run < records.size(); ++run) {
    const bool succeeded = records[run] && records[run]->error.empty();
    if (succeeded && !fs::exists(sweep.picture_file(run), error)) runs.push_back(run);
  }
  return runs;
}

}  // namespace

void make_missing_runs(const Sweep& sweep, const JobLimits& job_limits, const std::function<bool()>& cancelled) {
  const std::vector<std::size_t> missing = missing_runs(sweep);
  if (missing.empty()) return;
  SharedProgress progress("Sweeping", missing.size());
  const auto work = [&](std::size_t i) {
    if (make_run(sweep.request(missing[i]), sweep.record_file(missing[i]), job_limits.limits, cancelled))
      progress.add_one();
  };
  work_side_by_side(missing.size(), job_limits.jobs, work, cancelled);
}

std::string make_missing_pictures(const Sweep& sweep, const std::vector<std::optional<RunRecord>>& records,
                                  const JobLimits& job_limits, const std::function<bool()>& cancelled) {
  const std::vector<std::size_t> runs = without_picture(sweep, records);
  if (runs.empty()) return {};
  fs::create_directories(sweep.picture_file(0).parent_path());
  SharedProgress progress("Drawing", runs.size());
  std::mutex mutex;
  std::string problem;  // under `mutex`, like the following
  bool any_drawn = false;
  const auto stop = [&] {
    const std::lock_guard lock(mutex);
    return (!problem.empty() && !any_drawn) || cancelled();  // if none can be drawn, no other will be
  };
  const auto work = [&](std::size_t i) {
    const std::vector<std::string> words =
        render_words(sweep.request(runs[i]), *sweep.picture_frame, sweep.picture_file(runs[i]));
    const ProcessOutcome outcome = run_process(words, job_limits.limits, {}, cancelled);
    progress.add_one();
    const std::lock_guard lock(mutex);
    any_drawn |= outcome.succeeded();
    if (!outcome.succeeded() && outcome.end != ProcessOutcome::End::cancelled && problem.empty())
      problem = "run " + std::to_string(runs[i] + 1) + ": " + failure_text(outcome, job_limits.limits);
  };
  work_side_by_side(runs.size(), job_limits.jobs, work, stop);
  std::error_code ignored;
  fs::remove(sweep.picture_file(0).parent_path(), ignored);  // if it is empty
  return problem;
}

}  // namespace griffith::app
