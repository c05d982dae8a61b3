#pragma once

#include <memory>

#include "app/render/render_job.h"
#include "sim/world/world.h"

namespace griffith::app {

/// Steps a scene and draws it. Needs a current OpenGL context.
class Painter {
 public:
  virtual ~Painter() = default;

  virtual void step() = 0;
  virtual const World& world() const = 0;
  /// Draws a picture with a camera and view of the job. Its name is left empty. `turn`: rotation of the camera about
  /// its target [rad]; 0 with panels.
  virtual RenderedPicture paint(const std::string& camera, const std::string& view, double turn) = 0;
};

/// Returns a painter of pictures with legends. Throws InputError for a missing camera, view or node.
std::unique_ptr<Painter> make_plain_painter(const RenderJob& job, const Scene& scene);
/// Returns a painter of the editor with its panels. Throws as above.
std::unique_ptr<Painter> make_editor_painter(const RenderJob& job, const Scene& scene);

}  // namespace griffith::app
