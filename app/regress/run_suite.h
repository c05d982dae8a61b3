#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/regress/picture_result.h"
#include "app/render/render_job.h"

namespace griffith::app {

/// A run of a suite; each job is a process of its own, so that a crash counts as a failure.
struct SuiteRun {
  std::filesystem::path suite;
  std::filesystem::path drawn;  ///< folder for the pictures
  int processes = 1;            ///< number of simultaneous processes
  double time_limit = 600;      ///< limit of a job [s]
  std::optional<int> egl_device;
};

/// Result of a job.
struct JobOutcome {
  std::string error;  ///< message of its process; empty if it succeeded
  double seconds = 0;
};

/// Draws the jobs' pictures with their records. `on_done` is called after each, from any thread but one at a time. The
/// remaining jobs are skipped once `cancelled`, which any thread calls, returns true.
std::vector<JobOutcome> draw_suite(const SuiteRun& run, const std::vector<RenderJob>& jobs,
                                   const std::function<void()>& on_done, const std::function<bool()>& cancelled);

/// Reads a picture and its record. `stem`: their path without extensions. Throws InputError or RenderError if they
/// cannot be read.
RegressionPicture read_picture(const std::filesystem::path& stem);

/// Returns the renderer in the picture's record: "llvmpipe (...)"; empty if it is missing.
std::string renderer_of(const RegressionPicture& picture);

/// Key of a result's metadata with the folder of golden pictures, if it is another renderer's.
inline constexpr char kGoldensOf[] = "golden pictures of";

/// Compares the pictures drawn by a job with the golden ones.
std::vector<PictureResult> compare_job(const SuiteRun& run, const RenderJob& job, const JobOutcome& outcome);

}  // namespace griffith::app
