#pragma once

#include <memory>
#include <string>

#include "app/render/render_job.h"
#include "sim/world/world.h"
#include "ui/model/selection.h"

namespace griffith::app {

/// Draws pictures of a world that somebody else steps, with their legends. Needs a current OpenGL context, the same for
/// all calls.
class PictureMaker {
 public:
  /// `start`: the world before anything broke. Throws InputError for a camera or view that the scene lacks.
  PictureMaker(const RenderJob& job, const Scene& scene, const World& start);
  ~PictureMaker();

  /// To be called after each step, so that ranges of colors change smoothly and shards lie round the first crack.
  void follow(const World& world);
  /// Returns a picture through one of the job's cameras in one of its views. Its name is left empty.
  RenderedPicture paint(const World& world, const std::string& camera, const std::string& view);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns the job's node, while there is one of that number. Throws InputError where the last frame has none.
ui::Selection selected_node(const RenderJob& job, const Frame& frame);

/// Returns numbers of a world that pictures are recorded with.
PictureRecord world_record(const World& world);

}  // namespace griffith::app
