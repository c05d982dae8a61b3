#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/draw_scene_from_frame.h"
#include "renderer/camera.h"
#include "sim/timeline/timeline.h"

namespace griffith::app {

/// Export of the recorded past of a branch, which advances a little in each drawn frame. The destructor cancels it.
class RunExport {
 public:
  virtual ~RunExport() = default;

  /// Continues. Returns the result when finished, as "pane.glb: 60 frames". Throws InputError or std::runtime_error if
  /// it cannot be written.
  virtual std::optional<std::string> advance() = 0;
  /// Describes the progress: "Drawing step 12 of 60".
  virtual std::string stage() const = 0;
  /// Cancels. Returns the completed part in the form of advance(); empty: nothing.
  virtual std::string cancel() = 0;
  /// True if the work is done beside the drawn frames, which take processors from it.
  virtual bool in_background() const { return false; }
};

/// View of the pictures of a run.
struct ExportedView {
  render::Camera camera;
  ViewSettings view;
  HiddenBodies hidden;
  int width = 1280, height = 720;  ///< [pixels]
};

/// Lists the formats of start_export(), one line for each purpose.
std::vector<std::string> export_hints();

/// Throws InputError unless the file's extension names a format of start_export() and the file can be written.
void check_export(const std::filesystem::path& path);

/// Returns the first existing file that would be overwritten, else `path`.
std::filesystem::path file_in_the_way(const std::filesystem::path& path, const Timeline& timeline);

/// Begins to write all steps of the timeline's branch: for other programs as export_bake(), as a video of the view, or
/// as numbered pictures if the file ends in .png. `display`: of the timeline's world. Needs a current OpenGL context
/// for pictures. Throws as check_export().
std::unique_ptr<RunExport> start_export(const std::filesystem::path& path, const Timeline& timeline,
                                        const EmbeddedDisplay& display, const ExportedView& view);

}  // namespace griffith::app
