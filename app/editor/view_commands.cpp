#include <algorithm>

#include "app/editor/editor.h"
#include "app/editor/editor_commands.h"
#include "app/editor/entry_edits.h"
#include "app/editor/picking.h"
#include "app/editor/script.h"
#include "app/editor/starting_scene.h"
#include "ui/model/entry_choice.h"

namespace griffith::app {
using ui::CommandArgument;
using ui::CommandContext;
using ui::Menu;
namespace key = ui::key;

namespace {

std::string_view no_body_selected(const CommandContext& context) {
  return unless(!ui::selected_bodies(context.state, context.history.scene()).empty(),
                "No body is selected in the outliner.");
}

std::string_view no_camera_selected(const CommandContext& context) {
  const std::optional<ui::SceneEntry> entry = ui::active_entry(context.state, context.history.scene());
  return unless(entry && entry->kind == ui::EntryKind::camera, "No camera is selected in the outliner.");
}

std::string_view no_color_range(const CommandContext& context) {
  return unless(context.state.view.range || context.has_legend, "The picture is not colored by a quantity.");
}

bool hides_body(const CommandContext& context) {
  const std::vector<std::string> bodies = ui::selected_bodies(context.state, context.history.scene());
  const auto hidden = [&](const std::string& name) { return context.state.hidden_bodies.contains(name); };
  return !bodies.empty() && std::ranges::all_of(bodies, hidden);
}

void look_through(Editor& e) {
  const Scene& scene = e.document().scene();
  const std::optional<ui::SceneEntry> entry = ui::active_entry(e.state(), scene);
  if (entry && entry->kind == ui::EntryKind::camera) e.viewport().use_camera(scene, ui::entry_name(scene, *entry));
}

/// Looks at the same point from the same distance, against `toward_eye` of length 1.
void look_along(Editor& e, const Vec3& toward_eye) {
  const render::Camera& camera = e.viewport().camera();
  const Vec3 target = camera.target.cast<double>();
  e.viewport().look_from(target + (camera.position - camera.target).cast<double>().norm() * toward_eye, target);
}

const EditorCommand kViewCommands[] = {
    {{.name = "view.frame_all",
      .label = "Frame all",
      .hint = "Fit everything into the view except distant shards",
      .menu = Menu::view,
      .shortcut = {key::kHome}},
     [](Editor& e, const ui::Command&) { e.viewport().frame_all(e.run().shown()); }},
    {{.name = "view.front",
      .label = "Front view",
      .hint = "Look at the same place from the front, along -z",
      .menu = Menu::view,
      .shortcut = {'1'}},
     [](Editor& e, const ui::Command&) { look_along(e, Vec3::UnitZ()); }},
    {{.name = "view.back",
      .label = "Back view",
      .hint = "Look at the same place from the back, along z",
      .menu = Menu::view,
      .shortcut = {'1', true}},
     [](Editor& e, const ui::Command&) { look_along(e, -Vec3::UnitZ()); }},
    {{.name = "view.right",
      .label = "Right view",
      .hint = "Look at the same place from the right, along -x",
      .menu = Menu::view,
      .shortcut = {'3'}},
     [](Editor& e, const ui::Command&) { look_along(e, Vec3::UnitX()); }},
    {{.name = "view.left",
      .label = "Left view",
      .hint = "Look at the same place from the left, along x",
      .menu = Menu::view,
      .shortcut = {'3', true}},
     [](Editor& e, const ui::Command&) { look_along(e, -Vec3::UnitX()); }},
    {{.name = "view.top",
      .label = "Top view",
      .hint = "Look at the same place from above, along -y",
      .menu = Menu::view,
      .shortcut = {'7'}},
     [](Editor& e, const ui::Command&) { look_along(e, Vec3::UnitY()); }},
    {{.name = "view.four",
      .label = "Four views",
      .hint = "Show the scene also from above, from the front and from the side; drags there pan",
      .menu = Menu::view,
      .shortcut = {'Q', true, false, true},
      .is_on = [](const CommandContext& context) { return context.state.four_views.shown; }},
     [](Editor& e, const ui::Command&) { toggle(e.state().four_views.shown); }},
    {{.name = "view.edges",
      .label = "Element edges",
      .hint = "Show or hide the edges of the elements",
      .menu = Menu::view,
      .shortcut = {'E'},
      .is_on = [](const CommandContext& context) { return context.state.view.edges; }},
     [](Editor& e, const ui::Command&) { toggle(e.state().view.edges); }},
    {{.name = "view.hide",
      .label = "Hide",
      .hint = "Hide or show the selected bodies; hidden ones are still simulated",
      .menu = Menu::view,
      .shortcut = {'H'},
      .disabled_reason = no_body_selected,
      .is_on = hides_body},
     [](Editor& e, const ui::Command&) { toggle_hidden(e.state(), e.document().scene()); }},
    {{.name = "view.look_through",
      .label = "Look through camera",
      .hint = "Look through the camera selected in the outliner",
      .menu = Menu::view,
      .group = 1,
      .disabled_reason = no_camera_selected},
     [](Editor& e, const ui::Command&) { look_through(e); }},
    {{.name = "view.set_camera",
      .label = "Set camera to view",
      .hint = "Set the camera selected in the outliner to the current view",
      .menu = Menu::view,
      .group = 1,
      .disabled_reason = no_camera_selected},
     [](Editor& e, const ui::Command&) { set_camera(e.document().history(), e.state(), e.viewport().camera()); }},
    {{.name = "view.lock_range",
      .label = "Lock color range",
      .hint = "Lock the color range, or let it follow the values",
      .menu = Menu::view,
      .shortcut = {'L'},
      .disabled_reason = no_color_range,
      .is_on = [](const CommandContext& context) { return context.state.view.range.has_value(); }},
     [](Editor& e, const ui::Command&) { e.viewport().toggle_range_lock(); }},
    {{.name = "view.slice",
      .label = "Slice",
      .hint = "Slice the bodies perpendicular to the line of sight; Ctrl+drag moves the slice",
      .menu = Menu::view,
      .shortcut = {'X'},
      .is_on = [](const CommandContext& context) { return context.state.view.slice.has_value(); }},
     [](Editor& e, const ui::Command&) { e.viewport().toggle_slice(e.run().frame()); }},
    {{.name = "view.select_most_loaded",
      .label = "Most loaded node",
      .hint = "Inspect the node with the highest utilization, or that of the last crack if all pieces are rigid",
      .menu = Menu::view,
      .shortcut = {'M'}},
     [](Editor& e, const ui::Command&) { select_most_loaded(e.state(), e.run().frame()); }},
    {{.name = "view.left_panel",
      .label = "Left panel",
      .hint = "Show or hide the panel with the scene",
      .menu = Menu::view,
      .group = 1,
      .shortcut = {'T', false, false, true},
      .is_on = [](const CommandContext& context) { return context.state.preferences.show_left; }},
     [](Editor& e, const ui::Command&) { toggle(e.state().preferences.show_left); }},
    {{.name = "view.right_panel",
      .label = "Right panel",
      .hint = "Show or hide the panel with the view and the results",
      .menu = Menu::view,
      .group = 1,
      .shortcut = {'N', false, false, true},
      .is_on = [](const CommandContext& context) { return context.state.preferences.show_right; }},
     [](Editor& e, const ui::Command&) { toggle(e.state().preferences.show_right); }},
    {{.name = "view.reset_layout",
      .label = "Reset layout",
      .hint = "Show one view and all sections of the side panels in their usual places and sizes",
      .menu = Menu::view,
      .group = 1},
     [](Editor& e, const ui::Command&) { ui::reset_layout(e.state()); }},
    {{.name = "view.plots",
      .label = "Plots",
      .hint = "Show or hide plots of energies, counters and probes over time",
      .menu = Menu::view,
      .group = 1,
      .shortcut = {'P'},
      .is_on = [](const CommandContext& context) { return context.state.plots.shown; }},
     [](Editor& e, const ui::Command&) { toggle(e.state().plots.shown); }},
    {{.name = "view.log",
      .label = "Log",
      .hint = "Show or hide all messages of this run",
      .menu = Menu::view,
      .group = 1,
      .shortcut = {'L', true},
      .is_on = [](const CommandContext& context) { return context.state.log_view.shown; }},
     [](Editor& e, const ui::Command&) { toggle(e.state().log_view.shown); }},
    {{.name = "view.problems",
      .label = "Problems",
      .hint = "Show or hide the problems that griffith check finds in the edited scene",
      .menu = Menu::view,
      .group = 1,
      .is_on = [](const CommandContext& context) { return context.state.problem_view.shown; }},
     [](Editor& e, const ui::Command&) { toggle(e.state().problem_view.shown); }},
    {{.name = "help.palette",
      .label = "Find a command…",
      .hint = "Search all commands by a few letters of their names",
      .menu = Menu::help,
      .shortcut = {'P', true}},
     [](Editor& e, const ui::Command&) { e.state().palette.shown = true; }},
    {{.name = "help.show",
      .label = "Help",
      .hint = "Show or hide mouse and keyboard help",
      .menu = Menu::help,
      .shortcut = {key::kF1},
      .is_on = [](const CommandContext& context) { return context.state.show_help; }},
     [](Editor& e, const ui::Command&) { toggle(e.state().show_help); }},
    {{.name = "help.tour",
      .label = "Tour",
      .hint = "Break a wall and see why it broke, in a few minutes",
      .menu = Menu::help,
      .leaves = "The tour, which opens a scene of its own,",
      .recorded = false},
     [](Editor& e, const ui::Command&) {
       e.builder().open_without_file(starting_scene());
       e.scripting().play(tour());
     }},
    {{.name = "help.report",
      .label = "Save bug report…",
      .hint = "Save a recording with the log, versions and a picture of the window, for others to replay",
      .menu = Menu::help,
      .argument = CommandArgument::path,
      .with_path = "help.write_report"},
     [](Editor& e, const ui::Command& c) { e.files().ask_where_to_save(ui::SavedKind::bug_report, c.path); }},
    {{.name = "view.pick",
      .label = "Inspect",
      .hint = "Inspect the element under the cursor; left click in the view",
      .argument = CommandArgument::cursor},
     [](Editor& e, const ui::Command& c) { e.viewport().pick(e.run().shown(), c.cursor); }},
};

}  // namespace

std::span<const EditorCommand> view_commands() { return kViewCommands; }

}  // namespace griffith::app
