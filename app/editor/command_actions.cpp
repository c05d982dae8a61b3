#include <algorithm>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/entry_edits.h"
#include "app/editor/messages.h"
#include "app/editor/new_body.h"
#include "app/editor/picking.h"
#include "app/shared/scene_files.h"
#include "ui/model/entry_choice.h"

namespace griffith::app {
using ui::CommandId;

namespace {

namespace fs = std::filesystem;

void toggle(bool& value) { value = !value; }

void add_typical_body(Editor& e, const ui::Command& command) {
  e.state().running = false;
  add_body(e.document().history(), e.state(), "Add " + std::string(ui::command_info(command.id).label),
           new_body(command.id, e.document().scene(), e.run().frame()));
}

/// The last edits belong to the time that is left.
RunController& run_to_travel(Editor& e) {
  e.builder().follow_edits();
  return e.run();
}

void look_through(Editor& e) {
  const Scene& scene = e.document().scene();
  const std::optional<ui::SceneEntry> entry = ui::active_entry(e.state(), scene);
  if (entry && entry->kind == ui::EntryKind::camera) e.viewport().use_camera(scene, ui::entry_name(scene, *entry));
}

fs::path file_named(std::string name) {
  std::ranges::replace(name, '/', '-');
  return name.empty() ? "scene.json" : name + ".json";
}

void ask_where_to_save(Editor& e, fs::path proposed) {
  const SceneDocument& document = e.document();
  if (proposed.empty()) proposed = document.path().empty() ? file_named(document.scene().name) : document.path();
  e.state().save_as = ui::save_target(proposed);
  for (const fs::path& file : scenes_in(e.state().save_as->folder))
    e.state().save_as->existing.push_back(file.filename().string());
}

void save(Editor& e, const ui::Command& command) {
  SceneDocument& document = e.document();
  const fs::path file = command.path.empty() ? document.path() : command.path;
  if (file.empty()) return ask_where_to_save(e, {});
  if (std::string problem = document.saving_problem(file); !command.replace && !problem.empty()) {
    e.state().replacement = ui::Replacement{command, std::move(problem)};
    return;
  }
  const std::optional<ui::Command> next = std::exchange(e.state().after_save, std::nullopt);
  document.save(file, e.state().view);
  e.scenes().list(file);
  e.recovery().remove_copy();
  e.scenes().remember(document.absolute_path());
  log_message(e.state(), ui::LogLevel::info, "Saved " + file.string());
  if (next) e.execute(*next);
}

void quit(Editor& e) {
  e.recovery().remove_copy();
  e.requests().quit = true;
}

}  // namespace

/// One entry for each command of the registry.
std::span<const CommandAction> Editor::command_actions() {
  static constexpr CommandAction kActions[] = {
      {CommandId::toggle_run, [](Editor& e, const ui::Command&) { e.run().toggle(); }},
      {CommandId::step, [](Editor& e, const ui::Command&) { e.run().step_once(); }},
      {CommandId::ask_steps, [](Editor& e, const ui::Command&) { e.state().asked_steps = 10; }},
      {CommandId::make_steps, [](Editor& e, const ui::Command& c) { e.run().make_steps(c.step); }},
      {CommandId::step_back,
       [](Editor& e, const ui::Command&) {
         RunController& run = run_to_travel(e);
         run.go_to_nearest(run.timeline().step() - 1);
       }},
      {CommandId::go_to_start,
       [](Editor& e, const ui::Command&) {
         RunController& run = run_to_travel(e);
         run.go_to_nearest(run.timeline().first_step());
       }},
      {CommandId::go_to_end,
       [](Editor& e, const ui::Command&) {
         RunController& run = run_to_travel(e);
         run.go_to_nearest(run.timeline().last_step());
       }},
      {CommandId::go_to_step,
       [](Editor& e, const ui::Command& c) {
         RunController& run = run_to_travel(e);
         run.go_to(run.timeline().branch(), c.step);
       }},
      {CommandId::go_to_branch, [](Editor& e, const ui::Command& c) { run_to_travel(e).go_to(c.branch, c.step); }},
      {CommandId::explain_holding,
       [](Editor& e, const ui::Command&) {
         e.builder().follow_edits();
         e.analysis().explain_holding();
       }},
      {CommandId::toggle_comparison, [](Editor& e, const ui::Command&) { e.analysis().toggle_comparison(); }},
      {CommandId::reset, [](Editor& e, const ui::Command&) { e.builder().rebuild(); }},
      {CommandId::fire,
       [](Editor& e, const ui::Command& c) {
         e.run().fire(e.viewport().aimed_at(e.run().frame(), e.document().scene(), c.cursor).shot);
       }},
      {CommandId::keep_shot, [](Editor& e, const ui::Command&) { keep_shot(e.document().history(), e.state()); }},
      {CommandId::pick, [](Editor& e, const ui::Command& c) { e.viewport().pick(e.run().shown(), c.cursor); }},
      {CommandId::undo, [](Editor& e, const ui::Command&) { e.document().history().undo(); }},
      {CommandId::redo, [](Editor& e, const ui::Command&) { e.document().history().redo(); }},
      {CommandId::frame_all, [](Editor& e, const ui::Command&) { e.viewport().frame_all(e.run().shown()); }},
      {CommandId::toggle_edges, [](Editor& e, const ui::Command&) { toggle(e.state().view.edges); }},
      {CommandId::toggle_range_lock, [](Editor& e, const ui::Command&) { e.viewport().toggle_range_lock(); }},
      {CommandId::toggle_slice, [](Editor& e, const ui::Command&) { e.viewport().toggle_slice(e.run().frame()); }},
      {CommandId::select_most_loaded,
       [](Editor& e, const ui::Command&) { select_most_loaded(e.state(), e.run().frame()); }},
      {CommandId::log, [](Editor& e, const ui::Command&) { toggle(e.state().log_view.shown); }},
      {CommandId::toggle_problems, [](Editor& e, const ui::Command&) { toggle(e.state().problem_view.shown); }},
      {CommandId::toggle_plots, [](Editor& e, const ui::Command&) { toggle(e.state().plots.shown); }},
      {CommandId::preferences, [](Editor& e, const ui::Command&) { e.state().show_preferences = true; }},
      {CommandId::palette, [](Editor& e, const ui::Command&) { e.state().palette.shown = true; }},
      {CommandId::tour, [](Editor& e, const ui::Command&) { e.scripting().play(app::tour()); }},
      {CommandId::help, [](Editor& e, const ui::Command&) { toggle(e.state().show_help); }},
      {CommandId::add_box, [](Editor& e, const ui::Command& c) { add_typical_body(e, c); }},
      {CommandId::add_plate, [](Editor& e, const ui::Command& c) { add_typical_body(e, c); }},
      {CommandId::add_pane, [](Editor& e, const ui::Command& c) { add_typical_body(e, c); }},
      {CommandId::add_cylinder, [](Editor& e, const ui::Command& c) { add_typical_body(e, c); }},
      {CommandId::add_sphere, [](Editor& e, const ui::Command& c) { add_typical_body(e, c); }},
      {CommandId::add_beam, [](Editor& e, const ui::Command& c) { add_typical_body(e, c); }},
      {CommandId::add_support,
       [](Editor& e, const ui::Command&) {
         add_support(e.document().history(), e.state(), e.run().frame(), e.run().built());
       }},
      {CommandId::add_load,
       [](Editor& e,
          const ui::Command&) { add_load(e.document().history(), e.state(), e.run().frame(), e.run().built()); }},
      {CommandId::add_probe,
       [](Editor& e,
          const ui::Command&) { add_probe(e.document().history(), e.state(), e.run().frame(), e.run().built()); }},
      {CommandId::add_projectile,
       [](Editor& e, const ui::Command&) { add_projectile(e.document().history(), e.state(), e.viewport().camera()); }},
      {CommandId::add_camera,
       [](Editor& e, const ui::Command&) { add_camera(e.document().history(), e.state(), e.viewport().camera()); }},
      {CommandId::look_through, [](Editor& e, const ui::Command&) { look_through(e); }},
      {CommandId::set_camera,
       [](Editor& e, const ui::Command&) { set_camera(e.document().history(), e.state(), e.viewport().camera()); }},
      {CommandId::duplicate,
       [](Editor& e, const ui::Command&) { duplicate_entries(e.document().history(), e.state(), e.run().frame()); }},
      {CommandId::remove, [](Editor& e, const ui::Command&) { remove_entries(e.document().history(), e.state()); }},
      {CommandId::move_up, [](Editor& e, const ui::Command&) { move_entries(e.document().history(), e.state(), -1); }},
      {CommandId::move_down, [](Editor& e, const ui::Command&) { move_entries(e.document().history(), e.state(), 1); }},
      {CommandId::rename, [](Editor& e, const ui::Command&) { begin_renaming(e.state(), e.document().scene()); }},
      {CommandId::toggle_hidden, [](Editor& e, const ui::Command&) { toggle_hidden(e.state(), e.document().scene()); }},
      {CommandId::toggle_gizmo, [](Editor& e, const ui::Command&) { toggle(e.state().show_gizmo); }},
      {CommandId::toggle_painting, [](Editor& e, const ui::Command&) { toggle(e.state().paint_regions); }},
      {CommandId::new_scene, [](Editor& e, const ui::Command&) { e.builder().open_empty(); }},
      {CommandId::open_dialog, [](Editor& e, const ui::Command&) { e.state().show_open = true; }},
      {CommandId::browse_scenes, [](Editor& e, const ui::Command&) { e.state().browser.shown = true; }},
      {CommandId::open, [](Editor& e, const ui::Command& c) { e.builder().open(c.path); }},
      {CommandId::add_surface_dialog, [](Editor& e, const ui::Command&) { e.state().show_surface = true; }},
      {CommandId::add_surface, [](Editor& e, const ui::Command&) { e.builder().add_surface(); }},
      {CommandId::save, [](Editor& e, const ui::Command& c) { save(e, c); }},
      {CommandId::save_dialog, [](Editor& e, const ui::Command& c) { ask_where_to_save(e, c.path); }},
      {CommandId::save_recording_dialog,
       [](Editor& e, const ui::Command& c) { e.files().ask_where_to_save(ui::SavedKind::recording, c.path); }},
      {CommandId::save_report_dialog,
       [](Editor& e, const ui::Command& c) { e.files().ask_where_to_save(ui::SavedKind::bug_report, c.path); }},
      {CommandId::save_plots_dialog,
       [](Editor& e, const ui::Command& c) { e.files().ask_where_to_save(ui::SavedKind::plots, c.path); }},
      {CommandId::export_dialog,
       [](Editor& e, const ui::Command& c) { e.files().ask_where_to_save(ui::SavedKind::exported, c.path); }},
      {CommandId::export_run, [](Editor& e, const ui::Command& c) { e.files().begin_export(c); }},
      {CommandId::save_recording, [](Editor& e, const ui::Command& c) { e.files().save_recording(c); }},
      {CommandId::save_report, [](Editor& e, const ui::Command& c) { e.files().save_report(c); }},
      {CommandId::save_plots, [](Editor& e, const ui::Command& c) { e.files().save_plots(c); }},
      {CommandId::save_macro, [](Editor& e, const ui::Command& c) { e.scripting().save(c); }},
      {CommandId::record_macro, [](Editor& e, const ui::Command&) { e.scripting().toggle_recording(); }},
      {CommandId::save_macro_dialog, [](Editor& e, const ui::Command& c) { e.scripting().ask_where_to_save(c.path); }},
      {CommandId::play_macro, [](Editor& e, const ui::Command& c) { e.scripting().play(read_script(c.path)); }},
      {CommandId::recover, [](Editor& e, const ui::Command&) { e.builder().recover(); }},
      {CommandId::discard_copy, [](Editor& e, const ui::Command&) { e.recovery().discard_offered(); }},
      {CommandId::leave_copy, [](Editor& e, const ui::Command&) { e.recovery().leave_offered(); }},
      {CommandId::screenshot, [](Editor& e, const ui::Command&) { e.requests().screenshot = true; }},
      {CommandId::quit, [](Editor& e, const ui::Command&) { quit(e); }},
  };
  return kActions;
}

}  // namespace griffith::app
