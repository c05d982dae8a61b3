#include "app/editor/editor.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/editor/editor_commands.h"
#include "app/editor/frame_schedule.h"
#include "app/editor/messages.h"
#include "app/picture/bounds_of.h"
#include "sim/core/replace_file.h"

namespace griffith::app {
namespace {

// Intervals at which an idle window redraws the progress of work, of a step, arriving pictures and the text cursor [s].
// Frames take time from work in the background, most of all without graphics hardware.
constexpr double kWorkPause = 0.1, kStepPause = 0.1, kPicturePause = 0.1, kCursorPause = 0.4;

ui::EditorState state_for(const Scene& scene) {
  ui::EditorState state;
  begin_scene(state, scene);
  return state;
}

/// Sets the bounding box of the deformable bodies, however they are drawn.
void set_bounds(ui::EditorInput& input) {
  const Eigen::AlignedBox3d box = bounds_of(input.frame);
  if (box.isEmpty()) return;
  input.low = box.min();
  input.high = box.max();
}

/// Lists the problems of the scene from which the world was built, and of its file.
std::vector<ui::SceneProblem> scene_problems(const std::vector<InputError>& outdated,
                                             const std::vector<InputError>& warnings) {
  std::vector<ui::SceneProblem> problems;
  for (const std::vector<InputError>* found : {&outdated, &warnings})
    for (const InputError& problem : *found)
      problems.push_back({problem.where().substr(problem.where().find('#') + 1), problem.problem(), problem.remedy()});
  return problems;
}

}  // namespace

Editor::Editor(Scene scene, std::filesystem::path path, const Scene* edited)
    : state_(state_for(edited ? *edited : scene)),
      document_(std::move(scene), std::move(path), edited),
      run_(state_, document_, viewport_, build_world(document_.scene(), document_.path())) {
  scenes_.list(document_.path());
  viewport_.use_camera(document_.scene(), "");
  log_opened(state_, document_.scene());
}

void Editor::draw_picture(std::optional<int> samples) {
  constexpr double kMegabyte = 1 << 20;
  run_.limit_memory(static_cast<std::size_t>(state_.preferences.past_memory * kMegabyte));
  go_on_with_work();  // before the picture, which would otherwise show another world than the panels
  viewport_.frame_for_layout(document_.scene());
  analysis_.follow_comparison();
  if (viewport_.draw(run_.shown(), samples)) analysis_.draw_comparison(samples);
}

void Editor::go_on_with_work() {
  if (state_.cancel_work) discard_queued_commands(state_);
  constexpr double kTravelTime = 0.03;  // fraction of a drawn frame [s]
  run_.continue_travel(kTravelTime);
  run_.continue_recording();
  files_.go_on();
  analysis_.go_on();
  if (builder_.receive()) scripting_.skip();
  for (const std::string& stage :
       {run_.travel_stage(), run_.recording_stage(), files_.stage(), analysis_.stage(), builder_.stage()})
    if (state_.work = stage; !stage.empty()) break;
}

ui::EditorInput Editor::panel_input(const ui::Fonts& fonts) {
  ui::EditorInput input;
  input.commands = command_registry();
  input.frame = run_.frame();
  input.fonts = fonts;
  set_bounds(input);
  viewport_.describe(input, document_.scene());
  run_.describe(input);
  scenes_.follow_browser();
  input.scene_files = scenes_.files();
  input.scene_cards = scenes_.cards();
  input.recent_files = scenes_.recent();
  input.macros = scripting_.macros();
  input.scene_path = document_.path();
  input.comparison = analysis_.comparison_view();
  if (state_.plots.shown) input.curves = analysis_.plotted_curves();
  return input;
}

void Editor::draw_panels(const ui::Fonts& fonts) {
  ui::EditorInput input = panel_input(fonts);
  static const std::vector<std::string> kExportHints = export_hints();
  input.export_hints = kExportHints;
  const std::vector<ui::UtilizationSample> utilizations = run_.utilizations();
  input.utilizations = utilizations;
  const std::vector<ui::SceneProblem> problems = scene_problems(document_.outdated(), run_.warnings());
  input.problems = problems;
  for (const ui::Command& command : ui::draw_editor(input, state_, document_.history(), tags_)) execute(command);
  scripting_.note();
  if (builder_.follow_edits()) scripting_.skip();
  viewport_.follow_mouse(run_.lags());
}

double Editor::seconds_to_next_frame() const {
  const bool works = !run_.travel_stage().empty() || files_.draws() || analysis_.computes_comparison();
  const bool plays = state_.running || (state_.microsteps && state_.microsteps->playing);
  if (!works && state_.waiting.empty() && run_.waits_for_step()) return kStepPause;
  if (plays || works || viewport_.draws_draft() || !state_.waiting.empty()) return kDrawAtOnce;
  if (!state_.work.empty()) return kWorkPause;
  if (scenes_.awaits_thumbnails()) return kPicturePause;
  return ImGui::GetIO().WantTextInput ? kCursorPause : kDrawNever;
}

void Editor::execute(const ui::Command& command) {
  const ui::CommandInfo& info = command_info(command.name);
  if (const std::string_view reason = disabled_reason(info.name); !reason.empty()) return refuse(info, reason);
  if (!info.leaves.empty() && document_.history().modified() && !command.discard_edits) {
    state_.unsaved = command;
    return;
  }
  scripting_.note();
  try {
    carry_out(*this, command);
    scripting_.add(command);
  } catch (const InputError& error) {
    show_error(state_, error);
  } catch (const std::filesystem::filesystem_error& error) {  // such as a working folder that was removed
    show_error(state_, {error.path1().string(), error.code().message(), "choose another folder, by its whole path"});
  }
}

std::string_view Editor::disabled_reason(std::string_view command) const {
  const ui::CommandInfo& info = command_info(command);
  if (!info.disabled_reason) return {};
  const ui::TimeView time = run_.time_view();
  const Frame frame = run_.frame();
  return info.disabled_reason(
      {state_, document_.history(), time, frame.step, viewport_.has_legend(), ui::microsteps_of(frame, run_.built())});
}

void Editor::refuse(const ui::CommandInfo& info, std::string_view reason) {
  const std::string text = std::string(info.label) + ": " + std::string(reason);
  const bool said = !state_.log.empty() && state_.log.back().text == text;
  if (said) state_.log_seen = std::min(state_.log_seen, state_.log.size() - 1);
  if (!said) log_message(state_, ui::LogLevel::warning, text, ui::LogSpan::action);
}

void Editor::enable_autosave(const std::filesystem::path& states) {
  remove_stale_files(states);
  scenes_.keep_recent(states);
  scenes_.remember(document_.absolute_path());
  recovery_.enable(states);
}

}  // namespace griffith::app
