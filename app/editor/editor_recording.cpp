#include <algorithm>
#include <utility>

#include "app/editor/curve_table.h"
#include "app/editor/editor.h"
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
  if (kind == ui::SavedKind::plots) return name + ".csv";
  if (kind == ui::SavedKind::exported) return name + ".glb";
  return name + (kind == ui::SavedKind::recording ? "" : " report") + ".tar.zst";
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

void Editor::ask_where_to_save_run(ui::SavedKind kind, fs::path proposed) {
  if (proposed.empty()) proposed = own_file().parent_path() / file_of_run(history_.scene().name, kind);
  state_.save_as = ui::save_target(proposed, kind);
}

Recording Editor::recorded_run() const {
  Scene scene = world().scene();
  for (const fs::path* path : paths_in(scene)) {
    const fs::path file = file_path(scene.folder, *path);
    if (newest_time(file) > built_at_)
      throw InputError(file.string(), "has changed since the run began",
                       "Reset restarts with the current file; its earlier content is unknown");
  }
  return record(timeline_);
}

void Editor::save_run(const ui::Command& command) {
  const bool is_export = command.id == ui::CommandId::export_run;
  const fs::path old = is_export ? file_in_the_way(command.path, timeline_) : command.path;
  if (!command.replace && is_taken(old)) {
    state_.replacement = ui::Replacement{command, old.string() + " already exists."};
    return;
  }
  check_replaceable(command.path);
  switch (command.id) {
    case ui::CommandId::save_report:
      requested_picture_ = {ui::SavedKind::bug_report, command.path};
      return;
    case ui::CommandId::save_plots:
      return write_plots(command.path);
    case ui::CommandId::save_macro:
      return write_macro(command.path);
    case ui::CommandId::export_run:
      return export_run(command.path);
    default:
      return write_recorded_run(command.path);
  }
}

void Editor::write_recorded_run(const fs::path& path) {
  const Recording recording = recorded_run();
  write_recording(recording, path);
  log(ui::LogLevel::info, "Recorded " + std::to_string(recording.steps()) + " steps in " + path.string());
}

void Editor::write_plots(const fs::path& path) {
  if (path.extension() == ".png") {
    state_.plots.shown = state_.plots.for_picture = true;
    requested_picture_ = {ui::SavedKind::plots, path};
    return;
  }
  const ui::RunCurves curves = plotted_curves();
  replace_file(path, curve_table(curves));
  log(ui::LogLevel::info, "Wrote " + std::to_string(curves.steps.size()) + " steps to " + path.string());
}

std::vector<ui::UtilizationSample> Editor::utilizations_of_node() const {
  if (!state_.selection.valid()) return {};
  return history_of_utilizations_.samples(frame(), state_.selection.node);
}

ui::RunCurves Editor::plotted_curves() const {
  ui::RunCurves curves = run_history_.curves(timeline_, state_.preferences.plotted);
  fill_utilization(curves, utilizations_of_node());
  return curves;
}

std::optional<PictureRequest> Editor::take_picture_request() { return std::exchange(requested_picture_, std::nullopt); }

void Editor::save_window_picture(const PictureRequest& request, const render::Image& window,
                                 const std::string& graphics) {
  state_.plots.for_picture = false;
  try {
    if (request.kind == ui::SavedKind::plots) return save_plots_picture(request.file, window);
    save_report(request.file, window, graphics);
  } catch (const InputError& problem) {
    show_error(problem);
  }
}

void Editor::save_plots_picture(const fs::path& path, const render::Image& window) {
  const ui::WidgetTag* plots = ui::find_tag(tags_, "plots/strips");
  if (!plots)
    throw InputError(path.string(), "cannot be drawn: no series is plotted", "select some in the plots' list");
  const auto [left, top] =
      std::pair(std::max(0, static_cast<int>(plots->minimum.x)), std::max(0, static_cast<int>(plots->minimum.y)));
  const int right = std::min(window.width, static_cast<int>(plots->maximum.x));
  const int bottom = std::min(window.height, static_cast<int>(plots->maximum.y));
  replace_file(path, render::encode_png(render::part_of(window, left, top, right - left, bottom - top)));
  log(ui::LogLevel::info, "Saved the plots as " + path.string());
}

void Editor::save_report(const fs::path& path, const render::Image& window, const std::string& graphics) {
  Recording recording = recorded_run();
  recording.versions.emplace_back("graphics", graphics);
  add_report(recording, {log_text(state_.log), window});
  write_recording(recording, path);
  log(ui::LogLevel::info, "Saved the bug report " + path.string() + "; griffith replay repeats the run");
}

}  // namespace griffith::app
