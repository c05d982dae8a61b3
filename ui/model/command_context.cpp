#include "ui/model/command_context.h"

#include <algorithm>

#include "ui/model/entry_choice.h"
#include "ui/model/entry_place.h"

namespace griffith::ui {
namespace {

std::string_view unless(bool possible, std::string_view reason) { return possible ? std::string_view() : reason; }

}  // namespace

std::string_view nothing_to_undo(const CommandContext& context) {
  return unless(context.history.can_undo(), "There is no edit to undo.");
}

std::string_view nothing_to_redo(const CommandContext& context) {
  return unless(context.history.can_redo(), "There is no edit to redo.");
}

std::string_view no_past(const CommandContext& context) {
  return unless(context.step > context.time.first_step, "This is the first recorded step.");
}

std::string_view no_future(const CommandContext& context) {
  return unless(context.step < context.time.last_step, "This is the last recorded step.");
}

std::string_view one_branch_alone(const CommandContext& context) {
  return unless(context.time.branches.size() > 1,
                "There is only one branch; go back and change something to start another.");
}

std::string_view not_stopped_before_a_crack(const CommandContext& context) {
  return unless(context.state.stop && context.state.stop->node.valid(),
                "The simulation has not stopped before a crack; use Stop before… first.");
}

std::string_view nothing_fired(const CommandContext& context) {
  return unless(context.state.last_shot.has_value(), "No shot has been fired since the last one was added.");
}

std::string_view no_body(const CommandContext& context) {
  return unless(!context.history.scene().bodies.empty(), "The scene has no body.");
}

std::string_view nothing_selected(const CommandContext& context) {
  return unless(active_entry(context.state, context.history.scene()).has_value(),
                "Nothing is selected in the outliner.");
}

std::string_view nothing_to_move_up(const CommandContext& context) {
  const Scene& scene = context.history.scene();
  return unless(can_move(scene, selected_entries(context.state, scene), -1), "No selected entry can move up.");
}

std::string_view nothing_to_move_down(const CommandContext& context) {
  const Scene& scene = context.history.scene();
  return unless(can_move(scene, selected_entries(context.state, scene), 1), "No selected entry can move down.");
}

std::string_view no_region_selected(const CommandContext& context) {
  const Scene& scene = context.history.scene();
  const std::optional<SceneEntry> entry = active_entry(context.state, scene);
  return unless(context.state.paint_regions || (entry && region_of(scene, *entry)),
                "No support, load or probe with a region is selected in the outliner.");
}

std::string_view nothing_with_a_name(const CommandContext& context) {
  const std::optional<SceneEntry> entry = active_entry(context.state, context.history.scene());
  return unless(entry && has_name(entry->kind), "No entry with a name is selected in the outliner.");
}

std::string_view no_body_selected(const CommandContext& context) {
  return unless(!selected_bodies(context.state, context.history.scene()).empty(),
                "No body is selected in the outliner.");
}

std::string_view no_camera_selected(const CommandContext& context) {
  const std::optional<SceneEntry> entry = active_entry(context.state, context.history.scene());
  return unless(entry && entry->kind == EntryKind::camera, "No camera is selected in the outliner.");
}

std::string_view no_recoverable_edits(const CommandContext& context) {
  return unless(!context.state.recoverable_edits.empty(), "There are no edits to recover.");
}

std::string_view no_surface_named(const CommandContext& context) {
  return unless(context.state.surface.path[0] != '\0', "No surface file has been chosen.");
}

std::string_view nothing_recorded(const CommandContext& context) {
  return unless(context.time.last_step > context.time.first_step, "No step has been simulated yet.");
}

std::string_view nothing_plotted(const CommandContext& context) {
  const auto is_taken = [](const std::string& key) { return !key.empty(); };
  return unless(std::ranges::any_of(context.state.preferences.plotted, is_taken), "No series is plotted.");
}

std::string_view no_color_range(const CommandContext& context) {
  return unless(context.state.view.range || context.has_legend, "The picture is not colored by a quantity.");
}

bool is_running(const CommandContext& context) { return context.state.running; }
bool shows_edges(const CommandContext& context) { return context.state.view.edges; }
bool locks_range(const CommandContext& context) { return context.state.view.range.has_value(); }
bool has_slice(const CommandContext& context) { return context.state.view.slice.has_value(); }
bool hides_body(const CommandContext& context) {
  const std::vector<std::string> bodies = selected_bodies(context.state, context.history.scene());
  const auto hidden = [&](const std::string& name) { return context.state.hidden_bodies.contains(name); };
  return !bodies.empty() && std::ranges::all_of(bodies, hidden);
}
bool compares(const CommandContext& context) { return context.state.comparison.branch.has_value(); }

bool shows_plots(const CommandContext& context) { return context.state.plots.shown; }
bool records_macro(const CommandContext& context) { return context.state.recording_macro; }
bool shows_problems(const CommandContext& context) { return context.state.problem_view.shown; }
bool shows_log(const CommandContext& context) { return context.state.log_view.shown; }
bool shows_gizmo(const CommandContext& context) { return context.state.show_gizmo; }
bool paints_regions(const CommandContext& context) { return context.state.paint_regions; }
bool shows_help(const CommandContext& context) { return context.state.show_help; }

}  // namespace griffith::ui
