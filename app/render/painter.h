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
  /// A picture through that camera in that view, which the job has. Its name is left empty.
  virtual RenderedPicture paint(const std::string& camera, const std::string& view) = 0;
};

/// Draws pictures alone, with their legends. Throws InputError for what the scene lacks.
std::unique_ptr<Painter> make_plain_painter(const RenderJob& job, const Scene& scene);
/// Draws the editor, with its panels. As above.
std::unique_ptr<Painter> make_editor_painter(const RenderJob& job, const Scene& scene);

}  // namespace griffith::app
