#include "app/world_loader.h"

#include <chrono>
#include <utility>

#include "app/scene_world.h"

namespace griffith::app {

void WorldLoader::start(Work work, Scene scene, std::filesystem::path path) {
  start(
      work, [scene = std::move(scene)](const Monitor&) { return scene; }, std::move(path));
}

void WorldLoader::start(Work work, MakeScene make_scene, std::filesystem::path path) {
  cancel();
  work_ = work;
  shared_ = std::make_shared<Shared>();
  shared_->stage = "Building the bodies";
  auto build = [work, shared = shared_, make_scene = std::move(make_scene),
                path = std::move(path)]() mutable -> Loaded {
    Monitor monitor;
    monitor.stage = [shared](std::string_view stage) {
      const std::lock_guard lock(shared->mutex);
      shared->stage = stage;
    };
    monitor.cancelled = [shared] {
      const std::lock_guard lock(shared->mutex);
      return shared->cancelled;
    };
    Scene scene = make_scene(monitor);
    World world = make_world(scene, path, monitor);
    EmbeddedDisplay display = embedded_display(world.frame(), scene);
    return {work, std::move(scene), std::move(path), std::move(world), std::move(display)};
  };
  result_ = std::async(std::launch::async, std::move(build));
}

bool WorldLoader::wait(double seconds) const {
  return result_.valid() && result_.wait_for(std::chrono::duration<double>(seconds)) == std::future_status::ready;
}

std::optional<WorldLoader::Loaded> WorldLoader::take() {
  if (!wait(0)) return std::nullopt;
  return std::exchange(result_, {}).get();
}

std::string WorldLoader::stage() const {
  if (!result_.valid()) return {};
  const std::lock_guard lock(shared_->mutex);
  return shared_->stage;
}

void WorldLoader::cancel() {
  if (!result_.valid()) return;
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->cancelled = true;
  }
  std::exchange(result_, {}).wait();
}

}  // namespace griffith::app
