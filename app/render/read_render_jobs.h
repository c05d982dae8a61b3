#pragma once

#include <filesystem>
#include <vector>

#include "app/render/render_job.h"

namespace griffith::app {

/// The jobs of a file: {"defaults": {job}, "pictures": [{job}, ...]}. A job's fields are "name" and "scene" (both
/// needed, the path from the file's folder on), "frames" (a number, a list of them or text as --frames has it),
/// "views", "cameras" (lists of names), "size" ([width, height], pixels), "samples", "node", "ui", "open_sections",
/// "commands", "legend" and "transparent". Throws InputError with the first problem, at file#/json/pointer; scenes are
/// not looked for.
std::vector<RenderJob> read_render_jobs(const std::filesystem::path& file);

/// A file that read_render_jobs() reads as these jobs, with scenes' paths from `folder` on.
std::string render_jobs_json(const std::vector<RenderJob>& jobs, const std::filesystem::path& folder);

}  // namespace griffith::app
