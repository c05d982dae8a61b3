#pragma once

#include <memory>
#include <string>

#include "app/render/render_job.h"
#include "sim/world/world.h"
#include "ui/model/selection.h"

namespace griffith::app {

/// Draws pictures with legends of a world that the caller steps. Needs a current OpenGL context, the same for all
/// calls.
class PictureMaker {
 public:
  /// `start`: the world before any fracture. Throws InputError for a camera or view that the scene lacks.
  PictureMaker(const RenderJob& job, const Scene& scene, const World& start);
  ~PictureMaker();

  /// Follows a step; call it after each, so that color ranges change smoothly and shards lie around the first crack.
  void follow(const World& world);
  /// Returns a picture with a camera and view of the job. Its name is left empty. `turn`: rotation of the camera about
  /// its target [rad]. `caption`: text at the top.
  RenderedPicture paint(const World& world, const std::string& camera, const std::string& view, double turn = 0,
                        const std::string& caption = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns the job's node, if it exists. Throws InputError if the last frame lacks it.
ui::Selection selected_node(const RenderJob& job, const Frame& frame);

/// Returns the numbers of a world that are recorded with pictures.
PictureRecord world_record(const World& world);

}  // namespace griffith::app
