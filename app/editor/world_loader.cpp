#include "app/editor/world_loader.h"

#include <chrono>
#include <limits>
#include <utility>

#include "app/shared/expected_mesh.h"
#include "app/shared/scene_warnings.h"
#include "app/shared/scene_world.h"
#include "sim/core/low_priority.h"

namespace griffith::app {

namespace {

BuiltWorld with_display(Scene scene, World world, std::filesystem::file_time_type started, const Monitor& monitor,
                        const KnownShards& known) {
  EmbeddedDisplay display = embedded_display(world.frame(), scene, monitor, known);
  std::vector<InputError> warnings = scene_warnings(scene, world);
  return {std::move(scene), std::move(world), std::move(display), std::move(warnings), started};
}

}  // namespace

BuiltWorld build_world(Scene scene, const std::filesystem::path& path) {
  const auto started = std::filesystem::file_time_type::clock::now();
  World world = make_world(scene, path);
  return with_display(std::move(scene), std::move(world), started, {}, {});
}

WorldLoader::Loaded WorldLoader::build(const Order& order, const std::shared_ptr<Shared>& shared) {
  const LowPriority background;
  const auto started = std::filesystem::file_time_type::clock::now();
  Monitor monitor;
  monitor.stage = [shared](std::string_view stage) {
    const std::lock_guard lock(shared->mutex);
    shared->stage = stage;
  };
  monitor.cancelled = [shared] {
    const std::lock_guard lock(shared->mutex);
    return shared->cancelled;
  };
  Scene scene = order.make_scene(monitor);
  if (const double tets = expected_tets(scene, monitor); tets > order.max_tets) throw LargeMesh(tets);
  World world = make_world(scene, order.path, monitor);
  return {with_display(std::move(scene), std::move(world), started, monitor, order.known), order.reason, order.path};
}

void WorldLoader::start(LoadReason reason, Scene scene, std::filesystem::path path, double max_tets) {
  start(
      reason, [scene = std::move(scene)](const Monitor&) { return scene; }, std::move(path), max_tets);
}

void WorldLoader::start(LoadReason reason, MakeScene make_scene, std::filesystem::path path, double max_tets) {
  cancel();
  order_ = {reason, std::move(make_scene), std::move(path), max_tets, std::move(order_.known)};
  shared_ = std::make_shared<Shared>();
  shared_->stage = "Building bodies";
  result_ = std::async(std::launch::async, build, order_, shared_);
}

void WorldLoader::start_again() {
  start(order_.reason, order_.make_scene, order_.path, std::numeric_limits<double>::infinity());
}

bool WorldLoader::wait(double seconds) const {
  return result_.valid() && result_.wait_for(std::chrono::duration<double>(seconds)) == std::future_status::ready;
}

std::optional<WorldLoader::Loaded> WorldLoader::take() {
  if (!wait(0)) return std::nullopt;
  Loaded loaded = std::exchange(result_, {}).get();
  order_.known = loaded.display.shards.bodies();
  return loaded;
}

std::string WorldLoader::stage() const {
  if (!result_.valid()) return {};
  const std::lock_guard lock(shared_->mutex);
  return shared_->stage;
}

void WorldLoader::cancel() {
  using std::chrono::seconds;
  std::erase_if(cancelled_, [](const auto& work) { return work.wait_for(seconds(0)) == std::future_status::ready; });
  if (!result_.valid()) return;
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->cancelled = true;
  }
  cancelled_.push_back(std::exchange(result_, {}));
}

}  // namespace griffith::app
