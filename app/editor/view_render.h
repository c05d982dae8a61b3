#pragma once

#include <filesystem>
#include <memory>

#include "app/editor/run_export.h"
#include "ui/model/render_request.h"

namespace griffith::app {

/// Step that is drawn, with its view.
struct RenderedStep {
  const World& world;
  const Scene& scene;
  const EmbeddedDisplay& display;
  std::optional<Vec2> range;  ///< range of the colors
  render::Camera camera;      ///< camera of the view's picture
  float aspect = 1;           ///< width over height of that picture; all of it is in the drawn one
  ViewSettings view;
  HiddenBodies hidden;
};

/// Begins to draw a still or a turntable of the step. Throws InputError unless the file is one of a picture, or for
/// turntables of a video, and can be written. Needs a current OpenGL context.
std::unique_ptr<RunExport> start_render(const std::filesystem::path& path, const ui::RenderRequest& request,
                                        const RenderedStep& step);

/// Begins to draw all scenes of a folder into another one by the program's own command `render`.
std::unique_ptr<RunExport> start_batch(const std::filesystem::path& scenes, const std::filesystem::path& pictures,
                                       const ui::RenderRequest& request);

/// Returns the first existing file that would be overwritten, else `path`.
std::filesystem::path file_in_the_way(const std::filesystem::path& path, const ui::RenderRequest& request);

}  // namespace griffith::app
