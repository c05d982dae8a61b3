#include "app/editor/scene_gallery.h"

#include <algorithm>
#include <cstdint>

#include "sim/core/error.h"
#include "sim/core/read_file.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

/// Larger files are not scenes that a user would look for.
constexpr std::int64_t kMaxBytes = 64 << 20;

std::string topic_of(const Scene& scene) {
  if (scene.analysis == Analysis::static_) return "In equilibrium";
  const auto filled = [](const BodyDescription& body) { return std::holds_alternative<SurfaceShape>(body.shape); };
  if (std::ranges::any_of(scene.bodies, filled)) return "Filled surfaces";
  const auto splinters = [](const BodyDescription& body) { return body.splinters.has_value(); };
  if (std::ranges::any_of(scene.bodies, splinters)) return "Splinters";
  const auto held = [](const BodyDescription& body) { return !body.supports.empty(); };
  if (!scene.projectiles.empty())
    return std::ranges::any_of(scene.bodies, held) ? "Impact on supported bodies" : "Impact on loose bodies";
  const auto loaded = [](const BodyDescription& body) { return !body.loads.empty(); };
  return std::ranges::any_of(scene.bodies, loaded) ? "Loaded" : "Self-weight";
}

}  // namespace

ui::SceneCard scene_card(const fs::path& file) {
  try {
    const Scene scene = scene_from_json_alone(read_file(file, kMaxBytes), file.string());
    return {file, scene.name, topic_of(scene), scene.description};
  } catch (const InputError& error) {
    return {file, file.stem().string(), "Not a scene", error.where() + ": " + error.problem(), false};
  }
}

SceneGallery::SceneGallery(const std::vector<fs::path>& files, const ThumbnailSource& source) : maker_(files, source) {
  std::ranges::transform(files, std::back_inserter(cards_), scene_card);
}

void SceneGallery::follow() {
  while (const std::optional<ThumbnailMaker::Made> made = maker_.take()) {
    thumbnails_.emplace_back(made->picture);
    cards_[made->scene].thumbnail = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(thumbnails_.back().id()));
  }
}

}  // namespace griffith::app
