#include "app/shared/scene_world.h"

#include <algorithm>
#include <cstdio>

#include "app/shared/progress.h"

namespace griffith::app {

InputError in_file(const std::filesystem::path& scene_file, const InputError& error) {
  if (!error.where().starts_with("#")) return error;
  return InputError(scene_file.string() + error.where(), error.problem(), error.remedy());
}

World make_world(const Scene& scene, const std::filesystem::path& scene_file, const Monitor& monitor) {
  try {
    return World(scene, monitor);
  } catch (const InputError& error) {
    throw in_file(scene_file, error);
  }
}

World make_world(const Scene& scene, const std::filesystem::path& scene_file) {
  StageProgress progress;
  Monitor monitor;
  monitor.stage = [&](std::string_view stage) { progress.enter(stage); };
  return make_world(scene, scene_file, monitor);
}

void print_warnings(const std::filesystem::path& scene_file, std::span<const InputError> warnings) {
  constexpr std::size_t kMaximum = 20;
  for (const InputError& warning : warnings.first(std::min(warnings.size(), kMaximum)))
    std::fprintf(stderr, "warning: %s\n", in_file(scene_file, warning).what());
  if (warnings.size() > kMaximum) std::fprintf(stderr, "warning: and %zu more\n", warnings.size() - kMaximum);
}

World open_world(const Scene& scene, const std::filesystem::path& scene_file) {
  World world = make_world(scene, scene_file);
  print_warnings(scene_file, world.findings());
  return world;
}

}  // namespace griffith::app
