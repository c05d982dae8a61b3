#include <algorithm>
#include <cassert>

#include "app/editor/editor.h"
#include "ui/model/command_context.h"

namespace griffith::app {
using ui::CommandId;

namespace {

void toggle(bool& value) { value = !value; }

/// Action that calls a member without, or with the command.
template <auto Member>
constexpr auto kCall = [](Editor& editor, const ui::Command&) { (editor.*Member)(); };
template <auto Member>
constexpr auto kPass = [](Editor& editor, const ui::Command& command) { (editor.*Member)(command); };

}  // namespace

/// One entry for each command of the registry.
std::span<const CommandAction> Editor::command_actions() {
  static constexpr CommandAction kActions[] = {
      {CommandId::toggle_run, kCall<&Editor::toggle_run>},
      {CommandId::step, kCall<&Editor::pause_and_step>},
      {CommandId::ask_steps, [](Editor& editor, const ui::Command&) { editor.state_.asked_steps = 10; }},
      {CommandId::make_steps, [](Editor& editor, const ui::Command& command) { editor.make_steps(command.step); }},
      {CommandId::step_back, kPass<&Editor::carry_out_in_time>},
      {CommandId::go_to_start, kPass<&Editor::carry_out_in_time>},
      {CommandId::go_to_end, kPass<&Editor::carry_out_in_time>},
      {CommandId::go_to_step, kPass<&Editor::carry_out_in_time>},
      {CommandId::go_to_branch, kPass<&Editor::carry_out_in_time>},
      {CommandId::explain_holding, kPass<&Editor::carry_out_in_time>},
      {CommandId::toggle_comparison, kCall<&Editor::toggle_comparison>},
      {CommandId::reset, kCall<&Editor::follow>},
      {CommandId::fire, [](Editor& editor, const ui::Command& command) { editor.fire(command.cursor); }},
      {CommandId::keep_shot, kCall<&Editor::keep_shot>},
      {CommandId::pick, [](Editor& editor, const ui::Command& command) { editor.pick(command.cursor); }},
      {CommandId::undo, [](Editor& editor, const ui::Command&) { editor.history_.undo(); }},
      {CommandId::redo, [](Editor& editor, const ui::Command&) { editor.history_.redo(); }},
      {CommandId::frame_all, kCall<&Editor::frame_all>},
      {CommandId::toggle_edges, [](Editor& editor, const ui::Command&) { toggle(editor.state_.view.edges); }},
      {CommandId::toggle_range_lock, kCall<&Editor::toggle_range_lock>},
      {CommandId::toggle_slice, kCall<&Editor::toggle_slice>},
      {CommandId::select_most_loaded, kCall<&Editor::select_most_loaded>},
      {CommandId::log, [](Editor& editor, const ui::Command&) { toggle(editor.state_.log_view.shown); }},
      {CommandId::toggle_problems,
       [](Editor& editor, const ui::Command&) { toggle(editor.state_.problem_view.shown); }},
      {CommandId::toggle_plots, [](Editor& editor, const ui::Command&) { toggle(editor.state_.plots.shown); }},
      {CommandId::preferences, [](Editor& editor, const ui::Command&) { editor.state_.show_preferences = true; }},
      {CommandId::palette, [](Editor& editor, const ui::Command&) { editor.state_.palette.shown = true; }},
      {CommandId::tour, [](Editor& editor, const ui::Command&) { editor.requested_script_ = app::tour(); }},
      {CommandId::help, [](Editor& editor, const ui::Command&) { toggle(editor.state_.show_help); }},
      {CommandId::add_box, kPass<&Editor::add_new_body>},
      {CommandId::add_plate, kPass<&Editor::add_new_body>},
      {CommandId::add_pane, kPass<&Editor::add_new_body>},
      {CommandId::add_cylinder, kPass<&Editor::add_new_body>},
      {CommandId::add_sphere, kPass<&Editor::add_new_body>},
      {CommandId::add_beam, kPass<&Editor::add_new_body>},
      {CommandId::add_support, kPass<&Editor::add_entry>},
      {CommandId::add_load, kPass<&Editor::add_entry>},
      {CommandId::add_probe, kPass<&Editor::add_entry>},
      {CommandId::add_projectile, kPass<&Editor::add_entry>},
      {CommandId::add_camera, kCall<&Editor::add_camera>},
      {CommandId::look_through, kCall<&Editor::look_through>},
      {CommandId::set_camera, kCall<&Editor::set_camera>},
      {CommandId::duplicate, kCall<&Editor::duplicate_entries>},
      {CommandId::remove, kCall<&Editor::remove_entries>},
      {CommandId::move_up, [](Editor& editor, const ui::Command&) { editor.move_entries(-1); }},
      {CommandId::move_down, [](Editor& editor, const ui::Command&) { editor.move_entries(1); }},
      {CommandId::rename, kCall<&Editor::begin_renaming>},
      {CommandId::toggle_hidden, kCall<&Editor::toggle_hidden>},
      {CommandId::toggle_gizmo, [](Editor& editor, const ui::Command&) { toggle(editor.state_.show_gizmo); }},
      {CommandId::toggle_painting, [](Editor& editor, const ui::Command&) { toggle(editor.state_.paint_regions); }},
      {CommandId::new_scene, kCall<&Editor::new_scene>},
      {CommandId::open_dialog, [](Editor& editor, const ui::Command&) { editor.state_.show_open = true; }},
      {CommandId::browse_scenes, [](Editor& editor, const ui::Command&) { editor.state_.browser.shown = true; }},
      {CommandId::open, [](Editor& editor, const ui::Command& command) { editor.open(command.path); }},
      {CommandId::add_surface_dialog, [](Editor& editor, const ui::Command&) { editor.state_.show_surface = true; }},
      {CommandId::add_surface, kCall<&Editor::add_surface>},
      {CommandId::save, kPass<&Editor::save>},
      {CommandId::save_dialog,
       [](Editor& editor, const ui::Command& command) { editor.ask_where_to_save(command.path); }},
      {CommandId::save_recording_dialog,
       [](Editor& editor, const ui::Command& command) {
         editor.ask_where_to_save_run(ui::SavedKind::recording, command.path);
       }},
      {CommandId::save_report_dialog,
       [](Editor& editor, const ui::Command& command) {
         editor.ask_where_to_save_run(ui::SavedKind::bug_report, command.path);
       }},
      {CommandId::save_plots_dialog,
       [](Editor& editor, const ui::Command& command) {
         editor.ask_where_to_save_run(ui::SavedKind::plots, command.path);
       }},
      {CommandId::export_dialog,
       [](Editor& editor,
          const ui::Command& command) { editor.ask_where_to_save_run(ui::SavedKind::exported, command.path); }},
      {CommandId::export_run, kPass<&Editor::save_run>},
      {CommandId::save_recording, kPass<&Editor::save_run>},
      {CommandId::save_report, kPass<&Editor::save_run>},
      {CommandId::save_plots, kPass<&Editor::save_run>},
      {CommandId::save_macro, kPass<&Editor::save_run>},
      {CommandId::record_macro, kCall<&Editor::toggle_macro_recording>},
      {CommandId::save_macro_dialog,
       [](Editor& editor, const ui::Command& command) { editor.ask_where_to_save_macro(command.path); }},
      {CommandId::play_macro,
       [](Editor& editor, const ui::Command& command) { editor.requested_script_ = read_script(command.path); }},
      {CommandId::recover, kCall<&Editor::recover>},
      {CommandId::discard_copy, kCall<&Editor::discard_copy>},
      {CommandId::leave_copy, kCall<&Editor::leave_copy>},
      {CommandId::screenshot, [](Editor& editor, const ui::Command&) { editor.screenshot_requested_ = true; }},
      {CommandId::quit, kCall<&Editor::quit>},
  };
  return kActions;
}

std::string_view Editor::disabled_reason(CommandId id) const {
  const ui::CommandInfo& info = ui::command_info(id);
  const ui::TimeView time = time_view();
  const bool has_legend = !picture_.surface.scalar_style.quantity.empty();
  return info.disabled_reason ? info.disabled_reason({state_, history_, time, frame().step, has_legend})
                              : std::string_view();
}

void Editor::carry_out(const ui::Command& command) {
  const std::span<const CommandAction> actions = command_actions();
  const auto action = std::ranges::find(actions, command.id, &CommandAction::id);
  assert(action != actions.end() && "every command is carried out");
  action->carry_out(*this, command);
}

}  // namespace griffith::app
