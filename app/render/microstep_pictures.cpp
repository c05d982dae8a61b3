#include "app/render/microstep_pictures.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <utility>

#include "app/output/open_world.h"
#include "app/render/picture_maker.h"
#include "app/shared/progress.h"
#include "sim/scene/scene_difference.h"
#include "sim/timeline/microstep_recording.h"

namespace griffith::app {
namespace {

class MicrostepPictures {
 public:
  MicrostepPictures(const RenderJob& job, const Scene& scene, const std::function<void(RenderedPicture)>& take)
      : job_(job),
        take_(take),
        scene_text_(full_scene_text(scene)),
        world_(open_world(scene, job.scene)),
        pictures_(job, scene, world_) {}

  /// Draws the microsteps of each step that ends at a frame of the job.
  void draw(bool always_numbered) {
    Progress progress("Rendering", std::max(job_.frames.back(), 1));
    for (const int frame : job_.frames) {
      while (world_.frame().step + 1 < frame) make_step();
      draw_step(frame, record_step(frame), always_numbered);
      progress.update(frame);
    }
  }

 private:
  void make_step() {
    world_.step();
    const Frame frame = world_.frame();
    if (frame.report.microsteps > 0) steps_with_microsteps_ += " " + std::to_string(frame.step);
    pictures_.follow(world_);
  }

  /// Makes the step and records its microsteps.
  MicrostepRecording record_step(int frame) {
    if (frame == 0) throw InputError("--frame", "0 has no step before it, so no microsteps", "use 1 or more");
    const std::int64_t microsteps = count_microsteps(world_);
    if (microsteps == 0)
      throw InputError(
          "--frame", "step " + std::to_string(frame) + " has no microsteps: nothing strikes or cracks",
          steps_with_microsteps_.empty() ? "use a later step" : "use another step, such as" + steps_with_microsteps_);
    MicrostepRecording recording({.interval = (microsteps + job_.microsteps - 1) / job_.microsteps},
                                 std::numeric_limits<std::size_t>::max());
    world_.step(recording.observer());
    return recording;
  }

  void draw_step(int frame, const MicrostepRecording& recording, bool always_numbered) {
    const double start = recording.moments().front().world.frame().time;
    int number = 0;
    for (const MicrostepRecording::Moment& moment : recording.moments()) {
      pictures_.follow(moment.world);
      for (const std::string& camera : job_.cameras)
        for (const std::string& view : job_.views)
          take_(picture(frame, moment, start, camera, view,
                        picture_name(job_, camera, view, frame, always_numbered, number)));
      ++number;
    }
    pictures_.follow(world_);
  }

  RenderedPicture picture(int frame, const MicrostepRecording::Moment& moment, double start, const std::string& camera,
                          const std::string& view, std::string name) {
    const double time = moment.world.frame().time;
    char text[32];
    std::snprintf(text, sizeof text, "%+.2f µs", 1e6 * (time - start));
    RenderedPicture picture = pictures_.paint(moment.world, camera, view, 0, text);
    picture.name = std::move(name);
    picture.record.frame = frame;
    picture.record.statistics.emplace_back("microstep", static_cast<double>(moment.microstep));
    picture.record.statistics.emplace_back("time", time);
    picture.record.scene = scene_text_;
    picture.record.view = view;
    picture.record.camera = camera;
    return picture;
  }

  const RenderJob& job_;
  const std::function<void(RenderedPicture)>& take_;
  std::string scene_text_;
  World world_;
  PictureMaker pictures_;
  std::string steps_with_microsteps_;  ///< " 12 13", before the first frame
};

}  // namespace

void render_microsteps(const RenderJob& job, const Scene& scene, bool always_numbered,
                       const std::function<void(RenderedPicture)>& take) {
  MicrostepPictures(job, scene, take).draw(always_numbered);
}

}  // namespace griffith::app
