#pragma once

#include <filesystem>
#include <vector>

#include "app/render/render_job.h"

namespace griffith::app {

/// Reads the jobs of a file: {"defaults": {job}, "pictures": [{job}, ...]}. A job's fields are "name" and "scene" (both
/// required; the path is relative to the file's folder), "frames" (a number, a list or text as for --frames), "views",
/// "cameras" (lists of names), "size" ([width, height], pixels), "samples", "quality", "environment", "node", "ui",
/// "open_sections", "commands", "legend" and "transparent". Throws InputError with the first problem, at
/// file#/json/pointer; scenes need not exist.
std::vector<RenderJob> read_render_jobs(const std::filesystem::path& file);

/// Returns a file of these jobs for read_render_jobs(), with scenes' paths relative to `folder`.
std::string render_jobs_json(const std::vector<RenderJob>& jobs, const std::filesystem::path& folder);

}  // namespace griffith::app
