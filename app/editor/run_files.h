#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/editor/run_analysis.h"
#include "app/editor/run_export.h"
#include "renderer/image.h"
#include "sim/recording/recording.h"

namespace griffith::app {

/// A file made from a picture of the window: a bug report or the plots.
struct PictureRequest {
  ui::SavedKind kind = ui::SavedKind::bug_report;
  std::filesystem::path file;
  OutsideFiles outside = OutsideFiles::refuse;  ///< for a bug report
};

/// Files made from the run: recordings, bug reports, series and exports.
class RunFiles {
 public:
  RunFiles(ui::EditorState& state, const SceneDocument& document, const RunController& run, const Viewport& viewport,
           const RunAnalysis& analysis)
      : state_(state), document_(document), run_(run), viewport_(viewport), analysis_(analysis) {}

  /// Opens the dialog that asks for a file. `proposed`: empty for a name made from the scene's.
  void ask_where_to_save(ui::SavedKind kind, std::filesystem::path proposed);

  // Each writes to the file of the command; what exists there is replaced after a question. Each throws InputError.
  void save_recording(const ui::Command& command);
  /// Requests a picture of the window for the report.
  void save_report(const ui::Command& command);
  /// Writes CSV at once; for a PNG, requests a picture of the window.
  void save_plots(const ui::Command& command);
  /// Begins to export the current branch for other programs, as a video or as pictures of the view.
  void begin_export(const ui::Command& command);

  /// Begins to draw what state.render asks for into the file, or folder, of the command.
  void begin_render(const ui::Command& command);

  /// Continues an export; call it in every drawn frame.
  void go_on();
  /// Describes the progress of an export; empty if there is none.
  std::string stage() const { return export_ ? export_->stage() : std::string(); }
  /// True if the drawn frames continue an export.
  bool draws() const { return export_ && !export_->in_background(); }

  /// Returns a pending request for a picture of the window, once; save it with one of the next drawn frame.
  std::optional<PictureRequest> take_picture_request();
  /// Saves a bug report with run, log, versions and picture, or the plots in the picture; shows problems. `tags`:
  /// widgets of the picture, `graphics`: name of the renderer.
  void save_window_picture(const PictureRequest& request, const render::Image& window, const ui::WidgetTags& tags,
                           const std::string& graphics);

 private:
  /// Returns a recording of the current branch. Throws InputError if files of its scene have changed since the world
  /// was built.
  Recording recorded_run(OutsideFiles outside) const;
  /// Throws InputError.
  void save_plots_picture(const std::filesystem::path& path, const render::Image& window, const ui::WidgetTags& tags);
  void save_report_picture(const PictureRequest& request, const render::Image& window, const std::string& graphics);
  void log(ui::LogLevel level, std::string text);

  ui::EditorState& state_;
  const SceneDocument& document_;
  const RunController& run_;
  const Viewport& viewport_;
  const RunAnalysis& analysis_;
  std::unique_ptr<RunExport> export_;
  std::optional<PictureRequest> requested_picture_;
};

}  // namespace griffith::app
