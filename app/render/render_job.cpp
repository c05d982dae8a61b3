#include "app/render/render_job.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <numbers>

#include "app/render/microstep_pictures.h"
#include "app/render/painter.h"
#include "app/shared/explanation.h"
#include "app/shared/progress.h"
#include "sim/core/error.h"
#include "sim/scene/scene_difference.h"
#include "sim/scene/view_names.h"

namespace griffith::app {
namespace {

/// Returns a suffix for names: "_front" for "front"; replaces characters that file names cannot contain.
std::string name_part(std::string text) {
  if (text.empty()) return "";
  std::ranges::replace_if(
      text, [](char c) { return c == '/' || c == ' ' || static_cast<unsigned char>(c) < ' '; }, '-');
  return "_" + text;
}

/// Returns the number of pictures of a camera with a view at a time.
int turns_of(const RenderJob& job) { return std::max(job.turntable, 1); }

/// Returns the angle of a picture of a turntable [rad].
double angle_of(const RenderJob& job, int turn) { return 2 * std::numbers::pi * turn / turns_of(job); }

void step_to(Painter& painter, int frame, Progress& progress) {
  for (std::int64_t step = painter.world().frame().step; step < frame; ++step) {
    painter.step();
    progress.update(static_cast<int>(step) + 1);
  }
}

}  // namespace

std::vector<std::string> quality_names() {
  const auto of_views = picture_quality_names();
  std::vector<std::string> names(of_views.begin(), of_views.end());
  names.push_back("poster");
  return names;
}

void set_quality(RenderJob& job, std::string_view name) {
  const auto names = picture_quality_names();
  const auto found = std::ranges::find(names, name);
  job.poster = found == names.end();
  job.quality = job.poster ? PictureQuality::high : static_cast<PictureQuality>(found - names.begin());
}

std::string picture_name(const RenderJob& job, const std::string& camera, const std::string& view, int frame,
                         bool always_numbered, int turn) {
  std::string name = job.name.empty() ? job.scene.stem().string() : job.name;
  if (job.cameras.size() > 1) name += name_part(camera);
  if (job.views.size() > 1) name += name_part(view.empty() ? "scene" : view);
  char number[16];
  std::snprintf(number, sizeof number, "_%04d", frame);
  if (job.frames.size() > 1 || always_numbered) name += number;
  std::snprintf(number, sizeof number, "_%03d", turn);
  return job.turntable > 0 || job.microsteps > 0 ? name + number : name;
}

std::size_t picture_count(const RenderJob& job) {
  return job.frames.size() * job.cameras.size() * job.views.size() * static_cast<std::size_t>(turns_of(job));
}

std::vector<std::string> picture_names(const RenderJob& job) {
  std::vector<std::string> names;
  for (const int frame : job.frames)
    for (const std::string& camera : job.cameras)
      for (const std::string& view : job.views)
        for (int turn = 0; turn < turns_of(job); ++turn)
          names.push_back(picture_name(job, camera, view, frame, false, turn));
  return names;
}

std::string render_job(const RenderJob& job, const Scene& authored, bool always_numbered,
                       const std::function<void(RenderedPicture)>& take) {
  Scene scene = authored;
  scene.view.quality = job.quality.value_or(scene.view.quality);
  if (job.microsteps > 0) return render_microsteps(job, scene, always_numbered, take), std::string();
  const std::string scene_text = full_scene_text(scene);
  const std::unique_ptr<Painter> painter =
      job.interface ? make_editor_painter(job, scene) : make_plain_painter(job, scene);
  {
    Progress progress("Rendering", std::max(job.frames.back(), 1));
    for (const int frame : job.frames) {
      step_to(*painter, frame, progress);
      for (const std::string& camera : job.cameras)
        for (const std::string& view : job.views)
          for (int turn = 0; turn < turns_of(job); ++turn) {
            RenderedPicture picture = painter->paint(camera, view, angle_of(job, turn));
            picture.name = picture_name(job, camera, view, frame, always_numbered, turn);
            picture.record.scene = scene_text;
            picture.record.view = view;
            picture.record.camera = camera;
            take(std::move(picture));
          }
    }
  }
  if (!job.node) return "";
  return explanation(painter->world().frame(), NodeId(*job.node), scene.simulation.fracture);
}

}  // namespace griffith::app
