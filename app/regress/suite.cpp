#include "app/regress/suite.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <set>

#include "app/output/output.h"
#include "app/render/read_render_jobs.h"
#include "app/shared/scene_files.h"
#include "sim/core/error.h"
#include "sim/core/read_file.h"
#include "sim/core/replace_file.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

bool is_golden(const fs::path& stem) {
  std::error_code error;
  return fs::exists(stem.string() + ".png", error);
}

/// Returns the folders in `folder`, sorted.
std::vector<fs::path> folders_in(const fs::path& folder) {
  std::vector<fs::path> folders = files_in(folder);
  std::error_code error;
  std::erase_if(folders, [&](const fs::path& path) { return !fs::is_directory(path, error); });
  return folders;
}

/// Returns a new name of a job: "wall", "wall_2", ...: the scene file's name, with a number if it is taken.
std::string job_name(const fs::path& scene, std::set<std::string>& taken) {
  std::string stem = scene.stem().string();
  stem.erase(0, std::min(stem.find_first_not_of('.'), stem.size()));
  if (stem.empty()) stem = "scene";
  std::string name = stem;
  for (int number = 2; !taken.insert(name).second; ++number) name = stem + "_" + std::to_string(number);
  return name;
}

}  // namespace

Shard shard_from_text(const std::string& text) {
  Shard shard;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%d/%d%c", &shard.index, &shard.count, &rest) != 2 || shard.index < 1 ||
      shard.index > shard.count)
    throw InputError("--shard", "\"" + text + "\" is not a shard", "write INDEX/COUNT, such as 1/3, 2/3 and 3/3");
  return shard;
}

std::vector<RenderJob> suite_jobs(const fs::path& suite, const Shard& shard) {
  std::error_code error;
  if (!fs::exists(suite / kSuiteFile, error))
    throw InputError(suite.string(), "contains no suite.json",
                     "name the folder of a suite, or make one with --init SCENE...");
  const std::vector<RenderJob> all = read_render_jobs(suite / kSuiteFile);
  std::vector<RenderJob> jobs;
  for (std::size_t i = static_cast<std::size_t>(shard.index - 1); i < all.size();
       i += static_cast<std::size_t>(shard.count))
    jobs.push_back(all[i]);
  return jobs;
}

std::string renderer_folder(const std::string& renderer) {
  std::string folder;
  for (const char c : renderer) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '_';
    if (plain) folder += c;
    if (!plain && !folder.empty() && folder.back() != '-') folder += '-';
  }
  while (!folder.empty() && folder.back() == '-') folder.pop_back();
  return folder.empty() ? "unknown" : folder;
}

std::optional<GoldenPlace> find_golden(const fs::path& suite, const std::string& renderer, const std::string& picture) {
  const fs::path own = suite / kGoldenFolder / renderer_folder(renderer) / picture;
  if (is_golden(own)) return GoldenPlace{own, false};
  for (const fs::path& folder : folders_in(suite / kGoldenFolder))
    if (is_golden(folder / picture)) return GoldenPlace{folder / picture, true};
  return std::nullopt;
}

void accept_picture(const fs::path& suite, const std::string& renderer, const std::string& picture,
                    const fs::path& drawn) {
  const fs::path folder = suite / kGoldenFolder / renderer_folder(renderer);
  check_folder(folder);
  fs::create_directories(folder);
  for (const char* ending : kPictureFiles) {
    const fs::path from = drawn / (picture + ending), to = folder / (picture + ending);
    std::error_code error;
    if (fs::exists(from, error)) {
      replace_file(to, read_file(from));
    } else {
      fs::remove(to, error);
    }
  }
}

std::vector<std::string> unused_goldens(const fs::path& suite, const std::string& renderer,
                                        const std::vector<RenderJob>& jobs) {
  std::set<std::string> used;
  for (const RenderJob& job : jobs)
    used.merge([&] {
      const std::vector<std::string> names = picture_names(job);
      return std::set<std::string>(names.begin(), names.end());
    }());
  std::vector<std::string> unused;
  for (const fs::path& file : files_in(suite / kGoldenFolder / renderer_folder(renderer))) {
    const std::string name = file.stem().string();
    if (file.extension() == ".json" && !used.contains(name)) unused.push_back(name);
  }
  return unused;
}

void make_suite(const fs::path& suite, const std::vector<fs::path>& scenes) {
  std::error_code error;
  if (fs::exists(suite / kSuiteFile, error))
    throw InputError((suite / kSuiteFile).string(), "already exists", "edit it, or name another folder");
  check_folder(suite);
  std::vector<RenderJob> jobs;
  std::set<std::string> names;
  for (const fs::path& scene : scenes) {
    read_scene(scene);
    RenderJob job;
    job.name = job_name(scene, names);
    job.scene = fs::absolute(scene).lexically_normal();
    job.frames = {0, 20, 40};
    job.views = {"material", "body"};
    job.width = 640;
    job.height = 360;
    job.samples = 1;
    jobs.push_back(job);
  }
  fs::create_directories(suite);
  replace_file(suite / kSuiteFile, render_jobs_json(jobs, fs::absolute(suite).lexically_normal()));
}

}  // namespace griffith::app
