#include <cstdio>

#include "app/command_options.h"
#include "sim/error.h"
#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"

namespace griffith::app {
namespace {

/// A world knows places as JSON pointers alone.
InputError in_file(const std::filesystem::path& path, const InputError& error) {
  return error.where().starts_with("#") ? InputError(path.string() + error.where(), error.problem(), error.remedy())
                                        : error;
}

/// All problems of the file, while its warnings are printed; where it reads well, the first one of its meshes.
std::vector<InputError> problems_of(const std::filesystem::path& path) {
  std::vector<InputError> problems = check_scene(path);
  if (!problems.empty()) return problems;
  try {
    const World world(read_scene(path));
    for (const InputError& finding : world.findings())
      std::fprintf(stderr, "warning: %s\n", in_file(path, finding).what());
  } catch (const InputError& error) {
    problems.push_back(in_file(path, error));
  }
  return problems;
}

}  // namespace

int check_command(const CheckOptions& options) {
  int count = 0;
  for (const std::filesystem::path& path : options.scenes) {
    const std::vector<InputError> problems = problems_of(path);
    for (const InputError& problem : problems) std::fprintf(stderr, "%s\n", problem.what());
    if (problems.empty()) std::printf("%s: good\n", path.c_str());
    count += static_cast<int>(problems.size());
  }
  if (count > 0) std::fprintf(stderr, "%d %s\n", count, count == 1 ? "problem" : "problems");
  return count;
}

}  // namespace griffith::app
