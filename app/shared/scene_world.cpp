#include "app/shared/scene_world.h"

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

}  // namespace griffith::app
