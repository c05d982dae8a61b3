#include <algorithm>
#include <cassert>

#include "app/editor/editor.h"
#include "ui/model/command_context.h"

namespace griffith::app {
using ui::CommandId;

namespace {

void toggle(bool& value) { value = !value; }

}  // namespace

/// One entry for each command of the registry.
std::span<const CommandAction> Editor::command_actions() {
  static constexpr auto kInTime = [](Editor& editor, const ui::Command& command) { editor.carry_out_in_time(command); };
  static constexpr auto kAddBody = [](Editor& editor, const ui::Command& command) { editor.add_new_body(command); };
  static constexpr auto kAddEntry = [](Editor& editor, const ui::Command& command) { editor.add_entry(command); };
  static constexpr auto kSaveRun = [](Editor& editor, const ui::Command& command) { editor.save_run(command); };
  static constexpr CommandAction kActions[] = {
      {CommandId::toggle_run, [](Editor& editor, const ui::Command&) { editor.toggle_run(); }},
      {CommandId::step, [](Editor& editor, const ui::Command&) { editor.pause_and_step(); }},
      {CommandId::ask_steps, [](Editor& editor, const ui::Command&) { editor.state_.asked_steps = 10; }},
      {CommandId::make_steps, [](Editor& editor, const ui::Command& command) { editor.make_steps(command.step); }},
      {CommandId::step_back, kInTime},
      {CommandId::go_to_start, kInTime},
      {CommandId::go_to_end, kInTime},
      {CommandId::go_to_step, kInTime},
      {CommandId::go_to_branch, kInTime},
      {CommandId::explain_holding, kInTime},
      {CommandId::toggle_comparison, [](Editor& editor, const ui::Command&) { editor.toggle_comparison(); }},
      {CommandId::reset, [](Editor& editor, const ui::Command&) { editor.follow(); }},
      {CommandId::fire, [](Editor& editor, const ui::Command& command) { editor.fire(command.cursor); }},
      {CommandId::keep_shot, [](Editor& editor, const ui::Command&) { editor.keep_shot(); }},
      {CommandId::pick, [](Editor& editor, const ui::Command& command) { editor.pick(command.cursor); }},
      {CommandId::undo, [](Editor& editor, const ui::Command&) { editor.history_.undo(); }},
      {CommandId::redo, [](Editor& editor, const ui::Command&) { editor.history_.redo(); }},
      {CommandId::frame_all, [](Editor& editor, const ui::Command&) { editor.frame_all(); }},
      {CommandId::toggle_edges, [](Editor& editor, const ui::Command&) { toggle(editor.state_.view.edges); }},
      {CommandId::toggle_range_lock, [](Editor& editor, const ui::Command&) { editor.toggle_range_lock(); }},
      {CommandId::toggle_slice, [](Editor& editor, const ui::Command&) { editor.toggle_slice(); }},
      {CommandId::select_most_loaded, [](Editor& editor, const ui::Command&) { editor.select_most_loaded(); }},
      {CommandId::log, [](Editor& editor, const ui::Command&) { toggle(editor.state_.log_view.shown); }},
      {CommandId::toggle_problems,
       [](Editor& editor, const ui::Command&) { toggle(editor.state_.problem_view.shown); }},
      {CommandId::toggle_plots, [](Editor& editor, const ui::Command&) { toggle(editor.state_.plots.shown); }},
      {CommandId::preferences, [](Editor& editor, const ui::Command&) { editor.state_.show_preferences = true; }},
      {CommandId::palette, [](Editor& editor, const ui::Command&) { editor.state_.palette.shown = true; }},
      {CommandId::tour, [](Editor& editor, const ui::Command&) { editor.wanted_script_ = app::tour(); }},
      {CommandId::help, [](Editor& editor, const ui::Command&) { toggle(editor.state_.show_help); }},
      {CommandId::add_box, kAddBody},
      {CommandId::add_plate, kAddBody},
      {CommandId::add_pane, kAddBody},
      {CommandId::add_cylinder, kAddBody},
      {CommandId::add_sphere, kAddBody},
      {CommandId::add_beam, kAddBody},
      {CommandId::add_support, kAddEntry},
      {CommandId::add_load, kAddEntry},
      {CommandId::add_probe, kAddEntry},
      {CommandId::add_projectile, kAddEntry},
      {CommandId::add_camera, [](Editor& editor, const ui::Command&) { editor.add_camera(); }},
      {CommandId::look_through, [](Editor& editor, const ui::Command&) { editor.look_through(); }},
      {CommandId::set_camera, [](Editor& editor, const ui::Command&) { editor.set_camera(); }},
      {CommandId::duplicate, [](Editor& editor, const ui::Command&) { editor.duplicate_entries(); }},
      {CommandId::remove, [](Editor& editor, const ui::Command&) { editor.remove_entries(); }},
      {CommandId::move_up, [](Editor& editor, const ui::Command&) { editor.move_entries(-1); }},
      {CommandId::move_down, [](Editor& editor, const ui::Command&) { editor.move_entries(1); }},
      {CommandId::rename, [](Editor& editor, const ui::Command&) { editor.begin_renaming(); }},
      {CommandId::toggle_hidden, [](Editor& editor, const ui::Command&) { editor.toggle_hidden(); }},
      {CommandId::toggle_gizmo, [](Editor& editor, const ui::Command&) { toggle(editor.state_.show_gizmo); }},
      {CommandId::toggle_painting, [](Editor& editor, const ui::Command&) { toggle(editor.state_.paint_regions); }},
      {CommandId::new_scene, [](Editor& editor, const ui::Command&) { editor.new_scene(); }},
      {CommandId::open_dialog, [](Editor& editor, const ui::Command&) { editor.state_.show_open = true; }},
      {CommandId::browse_scenes, [](Editor& editor, const ui::Command&) { editor.state_.browser.shown = true; }},
      {CommandId::open, [](Editor& editor, const ui::Command& command) { editor.open(command.path); }},
      {CommandId::add_surface_dialog, [](Editor& editor, const ui::Command&) { editor.state_.show_surface = true; }},
      {CommandId::add_surface, [](Editor& editor, const ui::Command&) { editor.add_surface(); }},
      {CommandId::save, [](Editor& editor, const ui::Command& command) { editor.save(command); }},
      {CommandId::save_dialog,
       [](Editor& editor, const ui::Command& command) { editor.ask_where_to_save(command.path); }},
      {CommandId::save_recording_dialog,
       [](Editor& editor,
          const ui::Command& command) { editor.ask_where_to_save_run(ui::SavedKind::recording, command.path); }},
      {CommandId::save_report_dialog,
       [](Editor& editor,
          const ui::Command& command) { editor.ask_where_to_save_run(ui::SavedKind::bug_report, command.path); }},
      {CommandId::save_plots_dialog,
       [](Editor& editor,
          const ui::Command& command) { editor.ask_where_to_save_run(ui::SavedKind::plots, command.path); }},
      {CommandId::export_dialog,
       [](Editor& editor,
          const ui::Command& command) { editor.ask_where_to_save_run(ui::SavedKind::exported, command.path); }},
      {CommandId::export_run, kSaveRun},
      {CommandId::save_recording, kSaveRun},
      {CommandId::save_report, kSaveRun},
      {CommandId::save_plots, kSaveRun},
      {CommandId::save_macro, kSaveRun},
      {CommandId::record_macro, [](Editor& editor, const ui::Command&) { editor.toggle_macro_recording(); }},
      {CommandId::save_macro_dialog,
       [](Editor& editor, const ui::Command& command) { editor.ask_where_to_save_macro(command.path); }},
      {CommandId::play_macro,
       [](Editor& editor, const ui::Command& command) { editor.wanted_script_ = read_script(command.path); }},
      {CommandId::recover, [](Editor& editor, const ui::Command&) { editor.recover(); }},
      {CommandId::discard_copy, [](Editor& editor, const ui::Command&) { editor.discard_copy(); }},
      {CommandId::leave_copy, [](Editor& editor, const ui::Command&) { editor.leave_copy(); }},
      {CommandId::screenshot, [](Editor& editor, const ui::Command&) { editor.screenshot_wanted_ = true; }},
      {CommandId::quit, [](Editor& editor, const ui::Command&) { editor.quit(); }},
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
