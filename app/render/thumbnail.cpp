#include "app/render/thumbnail.h"

#include <algorithm>

#include "app/render/painter.h"

namespace griffith::app {
namespace {

constexpr int kStepsAfterCrack = 12, kMostSteps = 120;

/// Uses natural colors for scenes that move: small values would give dark colors.
Scene as_seen(Scene scene) {
  if (scene.analysis == Analysis::dynamic) {
    scene.view.quantity = "material";
    scene.view.edges = false;
  }
  return scene;
}

/// Steps until something can be seen.
void step_until_visible(Painter& painter, Analysis analysis) {
  if (analysis == Analysis::static_) return painter.step();
  for (int steps = 0, after_crack = 0; steps < kMostSteps && after_crack < kStepsAfterCrack; ++steps) {
    painter.step();
    if (after_crack > 0 || !painter.world().frame().crack_events.empty()) ++after_crack;
  }
}

/// Returns the camera of the scene's page in the gallery; empty, for the first camera, if it has none.
std::string telling_camera(const Scene& scene) {
  constexpr char kGallery[] = "gallery";
  return std::ranges::find(scene.cameras, kGallery, &Camera::name) != scene.cameras.end() ? kGallery : "";
}

}  // namespace

render::Image thumbnail(const Scene& scene, const std::filesystem::path& file) {
  RenderJob job;
  job.scene = file;
  job.width = kThumbnailWidth;
  job.height = kThumbnailHeight;
  job.legend = false;
  job.cameras = {telling_camera(scene)};
  const std::unique_ptr<Painter> painter = make_plain_painter(job, as_seen(scene));
  step_until_visible(*painter, scene.analysis);
  return painter->paint(job.cameras[0], "", 0).image;
}

}  // namespace griffith::app
