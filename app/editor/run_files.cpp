#include "app/editor/run_files.h"

#include <algorithm>
#include <utility>

#include "app/editor/curve_table.h"
#include "app/editor/messages.h"
#include "app/editor/view_render.h"
#include "app/output/bug_report.h"
#include "app/output/output.h"
#include "app/shared/scene_files.h"
#include "sim/core/file_path.h"
#include "sim/core/replace_file.h"
#include "sim/scene/scene_paths.h"

namespace griffith::app {

namespace fs = std::filesystem;

namespace {

/// Proposes a file name for a run.
fs::path file_of_run(const std::string& scene, ui::SavedKind kind) {
  std::string name = scene.empty() ? "run" : scene;
  std::ranges::replace(name, '/', '-');
  return name.append(kind == ui::SavedKind::bug_report ? " report" : "").append(ui::extension_of(kind));
}

/// Returns the latest modification time of the file, its second file (TetGen's) or the content of the folder; the
/// earliest time if there is none.
fs::file_time_type newest_time(const fs::path& path) {
  fs::file_time_type newest = time_of_file(path);
  if (path.extension() == ".node") newest = std::max(newest, time_of_file(fs::path(path).replace_extension(".ele")));
  for (const fs::path& file : files_in(path)) newest = std::max(newest, time_of_file(file));
  return newest;
}

std::string log_text(const std::vector<ui::LogLine>& lines) {
  std::string text;
  for (const ui::LogLine& line : lines) {
    const char* level = line.level == ui::LogLevel::info      ? ""
                        : line.level == ui::LogLevel::warning ? "warning: "
                                                              : "error: ";
    text += level + printable(line.text) + "\n";
  }
  return text;
}

}  // namespace

void RunFiles::ask_where_to_save(ui::SavedKind kind, fs::path proposed) {
  if (proposed.empty()) proposed = document_.absolute_path().parent_path() / file_of_run(document_.scene().name, kind);
  state_.save_as = ui::save_target(proposed, kind);
}

Recording RunFiles::recorded_run(OutsideFiles outside) const {
  Scene scene = run_.world().scene();
  for (const fs::path* path : paths_in(scene)) {
    const fs::path file = file_path(scene.folder, *path);
    if (newest_time(file) > run_.built_at())
      throw InputError(file.string(), "has changed since the run began",
                       "Reset restarts with the current file; its earlier content is unknown");
  }
  return record(run_.timeline(), outside);
}

void RunFiles::save_recording(const ui::Command& command) {
  if (!may_replace(state_, command, command.path)) return;
  const Recording recording = recorded_run(outside_files(command.pack_outside));
  write_recording(recording, command.path);
  log(ui::LogLevel::info, "Recorded " + std::to_string(recording.steps()) + " steps in " + command.path.string());
}

void RunFiles::save_report(const ui::Command& command) {
  if (may_replace(state_, command, command.path))
    requested_picture_ = {ui::SavedKind::bug_report, command.path, outside_files(command.pack_outside)};
}

void RunFiles::save_plots(const ui::Command& command) {
  if (!may_replace(state_, command, command.path)) return;
  if (command.path.extension() == ".png") {
    state_.plots.shown = state_.plots.for_picture = true;
    requested_picture_ = PictureRequest{.kind = ui::SavedKind::plots, .file = command.path};
    return;
  }
  const ui::RunCurves curves = analysis_.plotted_curves();
  replace_file(command.path, curve_table(curves));
  log(ui::LogLevel::info, "Wrote " + std::to_string(curves.steps.size()) + " steps to " + command.path.string());
}

void RunFiles::begin_export(const ui::Command& command) {
  if (!may_replace(state_, command, file_in_the_way(command.path, run_.timeline()))) return;
  state_.running = false;
  export_ = start_export(command.path, run_.timeline(), viewport_.display(), viewport_.exported_view(run_.built()));
  state_.work = export_->stage();
}

void RunFiles::begin_render(const ui::Command& command) {
  const ui::RenderRequest& request = state_.render;
  const bool is_batch = request.subject == ui::RenderedSubject::scenes;
  if (!is_batch && !may_replace(state_, command, file_in_the_way(command.path, request))) return;
  state_.running = false;
  const ExportedView view = viewport_.exported_view(run_.built());
  export_ = is_batch ? start_batch(document_.absolute_path().parent_path(), command.path, request)
                     : start_render(
                           command.path, request,
                           {run_.world(), run_.built(), viewport_.display(), viewport_.range(), view.camera,
                            static_cast<float>(view.width) / static_cast<float>(view.height), view.view, view.hidden});
  state_.work = export_->stage();
}

void RunFiles::go_on() {
  if (!export_) return;
  try {
    if (std::exchange(state_.cancel_work, false)) {
      const std::string written = export_->cancel();
      log(ui::LogLevel::warning,
          "The export was cancelled: " + (written.empty() ? "nothing was written." : "wrote " + written + " before."));
      export_.reset();
    } else if (const std::optional<std::string> written = export_->advance()) {
      log(ui::LogLevel::info, "Wrote " + *written);
      export_.reset();
    }
  } catch (const InputError& error) {
    export_.reset();
    show_error(state_, error);
  } catch (const std::exception& error) {
    export_.reset();
    show_error(state_, InputError("the export", std::string("failed: ") + error.what(), ""));
  }
}

std::optional<PictureRequest> RunFiles::take_picture_request() {
  return std::exchange(requested_picture_, std::nullopt);
}

void RunFiles::save_window_picture(const PictureRequest& request, const render::Image& window,
                                   const ui::WidgetTags& tags, const std::string& graphics) {
  state_.plots.for_picture = false;
  try {
    if (request.kind == ui::SavedKind::plots) return save_plots_picture(request.file, window, tags);
    save_report_picture(request, window, graphics);
  } catch (const InputError& problem) {
    show_error(state_, problem);
  }
}

void RunFiles::save_plots_picture(const fs::path& path, const render::Image& window, const ui::WidgetTags& tags) {
  const ui::WidgetTag* plots = ui::find_tag(tags, "plots/strips");
  if (!plots)
    throw InputError(path.string(), "cannot be drawn: no series is plotted", "select some in the plots' list");
  const auto [left, top] =
      std::pair(std::max(0, static_cast<int>(plots->minimum.x)), std::max(0, static_cast<int>(plots->minimum.y)));
  const int right = std::min(window.width, static_cast<int>(plots->maximum.x));
  const int bottom = std::min(window.height, static_cast<int>(plots->maximum.y));
  replace_file(path, render::encode_png(render::part_of(window, left, top, right - left, bottom - top)));
  log(ui::LogLevel::info, "Saved the plots as " + path.string());
}

void RunFiles::save_report_picture(const PictureRequest& request, const render::Image& window,
                                   const std::string& graphics) {
  Recording recording = recorded_run(request.outside);
  recording.versions.emplace_back("graphics", graphics);
  add_report(recording, {log_text(state_.log), window});
  write_recording(recording, request.file);
  log(ui::LogLevel::info, "Saved the bug report " + request.file.string() + "; griffith replay repeats the run");
}

void RunFiles::log(ui::LogLevel level, std::string text) { log_message(state_, level, std::move(text)); }

}  // namespace griffith::app
