#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/regress/picture_result.h"
#include "app/render/render_job.h"

namespace griffith::app {

/// How the pictures of a suite are drawn: each job by a process of its own, so that one that dies is one that failed.
struct SuiteRun {
  std::filesystem::path suite;
  std::filesystem::path drawn;  ///< folder for the pictures
  int processes = 1;            ///< at a time
  double time_limit = 600;      ///< of a job [s]
  std::optional<int> egl_device;
};

/// What became of a job.
struct JobOutcome {
  std::string error;  ///< what its process said; empty where it ended well
  double seconds = 0;
};

/// Draws the jobs' pictures with their records. `on_done` is called after each, from any thread but never twice at a
/// time; when `cancelled`, which any thread asks, says so, what is left is left.
std::vector<JobOutcome> draw_suite(const SuiteRun& run, const std::vector<RenderJob>& jobs,
                                   const std::function<void()>& on_done, const std::function<bool()>& cancelled);

/// A picture and its record as they lie in a folder. `stem`: their path without endings. Throws InputError or
/// RenderError where they cannot be read.
RegressionPicture read_picture(const std::filesystem::path& stem);

/// "llvmpipe (...)": what drew the picture, by its record; empty where that says nothing.
std::string renderer_of(const RegressionPicture& picture);

/// The name under which a result's metadata has the folder of golden pictures, where that is another renderer's.
inline constexpr char kGoldensOf[] = "golden pictures of";

/// Compares the pictures that a job has drawn with the golden ones.
std::vector<PictureResult> compare_job(const SuiteRun& run, const RenderJob& job, const JobOutcome& outcome);

}  // namespace griffith::app
