#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/picture/draw_scene_from_frame.h"
#include "renderer/camera.h"
#include "sim/timeline/timeline.h"

namespace griffith::app {

/// The recorded past of a branch on its way into a file, a little further in each drawn frame. Ends unfinished when it
/// is destroyed before.
class RunExport {
 public:
  virtual ~RunExport() = default;

  /// Goes on; what was written, once all is, as "pane.glb: 60 frames". Throws InputError, or std::runtime_error, when
  /// it cannot be written.
  virtual std::optional<std::string> go_on() = 0;
  /// What is being done: "Drawing step 12 of 60".
  virtual std::string stage() const = 0;
  /// Gives up, and tells what was written all the same, as go_on() does; empty: nothing.
  virtual std::string cancel() = 0;
};

/// How pictures of a run show it.
struct ExportedView {
  render::Camera camera;
  ViewSettings view;
  HiddenBodies hidden;
  int width = 1280, height = 720;  ///< [pixels]
};

/// Throws InputError unless the file's suffix names what start_export() writes, in a place where it can be written.
void check_export(const std::filesystem::path& path);

/// The first of the files to be written that is there already, else `path`.
std::filesystem::path file_in_the_way(const std::filesystem::path& path, const Timeline& timeline);

/// Writes all steps of the branch that the timeline is in: for other programs as export_bake(), as a video of the view,
/// or, where the file ends in .png, as numbered pictures of it. `display`: of the timeline's world. Needs a current
/// OpenGL context for pictures. Throws as check_export().
std::unique_ptr<RunExport> start_export(const std::filesystem::path& path, const Timeline& timeline,
                                        const EmbeddedDisplay& display, const ExportedView& view);

}  // namespace griffith::app
