#include "app/regress/run_suite.h"

#include <chrono>
#include <limits>
#include <mutex>
#include <nlohmann/json.hpp>

#include "app/output/id_picture.h"
#include "app/regress/suite.h"
#include "app/shared/hash_text.h"
#include "app/shared/processes.h"
#include "sim/core/error.h"
#include "sim/core/file_content.h"
#include "sim/core/read_file.h"
#include "sim/scene/json_document.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> render_arguments(const SuiteRun& run, const RenderJob& job) {
  std::vector<std::string> arguments = {this_program().string(),
                                        "render",
                                        "--job-file",
                                        (run.suite / kSuiteFile).string(),
                                        "--only",
                                        job.name,
                                        "-o",
                                        run.drawn.string(),
                                        "--records",
                                        "--threads",
                                        "1"};
  if (run.egl_device) arguments.insert(arguments.end(), {"--egl-device", std::to_string(*run.egl_device)});
  return arguments;
}

JobOutcome draw_job(const SuiteRun& run, const RenderJob& job, const std::function<bool()>& cancelled) {
  constexpr double kPlenty = 1e9;  // drivers use many threads' time, and address space that they never touch
  const auto start = std::chrono::steady_clock::now();
  const ProcessLimits limits = {.seconds = run.time_limit,
                                .memory_bytes = std::numeric_limits<std::int64_t>::max(),
                                .processor_seconds = kPlenty};
  const ProcessOutcome outcome = run_process(render_arguments(run, job), limits, {}, cancelled);
  return {outcome.succeeded() ? "" : failure_text(outcome, limits),
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
}

void read_record(const fs::path& path, RegressionPicture& picture) {
  constexpr std::int64_t kMaxBytes = 16 << 20;
  std::vector<InputError> problems;
  const Json json = parse_json(read_file(path, kMaxBytes), path.string(), problems);
  if (!problems.empty() || !json.is_object())
    throw InputError(path.string(), "is not the record of a picture", "--accept writes a new one");
  for (const auto& [name, value] : json.items()) {
    if (name == "state_hash" && value.is_string()) {
      picture.state_hash = hash_from_text(value.get<std::string>());
    } else if (name == "statistics" && value.is_object()) {
      for (const auto& [statistic, number] : value.items())
        if (number.is_number()) picture.statistics.emplace_back(statistic, number.get<double>());
    } else if (name == "scene" && value.is_object()) {
      picture.scene = value.dump();
    } else {
      picture.metadata.emplace_back(name, value.is_string() ? value.get<std::string>() : value.dump());
    }
  }
}

/// Compares with a golden picture; an unreadable one counts as missing.
PictureResult compare_with(const fs::path& golden, const std::string& name, const RegressionPicture& actual) try {
  return compare_pictures(name, read_picture(golden), actual);
} catch (const std::exception& error) {
  PictureResult result = without_golden(name, actual);
  result.reason = std::string("The golden picture cannot be read: ") + error.what() + ".";
  return result;
}

PictureResult compare_picture(const SuiteRun& run, const std::string& name) {
  const RegressionPicture actual = read_picture(run.drawn / name);
  const auto golden = find_golden(run.suite, renderer_of(actual), name);
  PictureResult result = golden ? compare_with(golden->stem, name, actual) : without_golden(name, actual);
  if (golden && golden->other_renderer)
    result.metadata.push_back({kGoldensOf, golden->stem.parent_path().filename().string(), std::nullopt});
  result.accept_command = shell_command({"griffith", "regress", run.suite.string(), "--accept", name});
  return result;
}

}  // namespace

std::vector<JobOutcome> draw_suite(const SuiteRun& run, const std::vector<RenderJob>& jobs,
                                   const std::function<void()>& on_done, const std::function<bool()>& cancelled) {
  std::vector<JobOutcome> outcomes(jobs.size());
  std::mutex reporting;
  const auto draw = [&](std::size_t i) {
    outcomes[i] = draw_job(run, jobs[i], cancelled);
    const std::lock_guard lock(reporting);
    on_done();
  };
  work_side_by_side(jobs.size(), run.processes, draw, cancelled);
  return outcomes;
}

RegressionPicture read_picture(const fs::path& stem) {
  RegressionPicture picture;
  require_expected_content(stem.string() + ".png");
  picture.image = render::load_png(stem.string() + ".png");
  std::error_code error;
  if (fs::exists(stem.string() + ".ids.png", error))
    picture.ids = ids_of_picture(render::load_png(stem.string() + ".ids.png"));
  picture.text = read_file(stem.string() + ".txt");
  read_record(stem.string() + ".json", picture);
  return picture;
}

std::string renderer_of(const RegressionPicture& picture) {
  for (const auto& [name, value] : picture.metadata)
    if (name == "renderer") return value;
  return "";
}

std::vector<PictureResult> compare_job(const SuiteRun& run, const RenderJob& job, const JobOutcome& outcome) {
  std::vector<PictureResult> results;
  const std::vector<std::string> names = picture_names(job);
  for (const std::string& name : names) {
    std::error_code error;
    if (!fs::exists(run.drawn / (name + ".json"), error)) {
      results.push_back(without_picture(name, outcome.error.empty() ? "was not drawn" : outcome.error));
    } else {
      try {
        results.push_back(compare_picture(run, name));
      } catch (const std::exception& problem) {
        results.push_back(without_picture(name, problem.what()));
      }
    }
    if (!outcome.error.empty() && results.back().status != PictureStatus::error)
      results.back() = without_picture(name, "was drawn, but its process failed: " + outcome.error);
    results.back().seconds = outcome.seconds / static_cast<double>(names.size());
  }
  return results;
}

}  // namespace griffith::app
