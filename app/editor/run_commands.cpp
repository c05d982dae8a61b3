#include <algorithm>
#include <limits>
#include <string>

#include "app/editor/editor.h"
#include "app/editor/editor_commands.h"
#include "app/editor/entry_edits.h"
#include "app/editor/holding_edits.h"
#include "app/editor/messages.h"
#include "app/editor/picking.h"

namespace griffith::app {
using ui::CommandArgument;
using ui::CommandContext;
using ui::Menu;
namespace key = ui::key;

namespace {

std::string_view no_past(const CommandContext& context) {
  return unless(context.state.microsteps || context.step > context.time.first_step, "This is the first recorded step.");
}

std::string_view no_future(const CommandContext& context) {
  return unless(context.state.microsteps || context.step < context.time.last_step, "This is the last recorded step.");
}

std::string_view no_microsteps(const CommandContext& context) {
  const bool stopped_before_crack = context.state.stop && !context.state.stop->cracks.empty();
  return unless(context.state.microsteps || context.microsteps > 0 || stopped_before_crack,
                "The shown step has no microsteps: nothing was struck and nothing cracked in it.");
}

std::string_view microsteps_not_shown(const CommandContext& context) {
  return unless(context.state.microsteps.has_value(), "No microsteps are shown; use Microsteps first.");
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

std::string_view without_motion(const CommandContext& context) {
  return unless(context.history.scene().analysis == Analysis::dynamic,
                "In a static analysis nothing moves; add a load, or make the analysis dynamic.");
}

std::string_view nothing_held(const CommandContext& context) {
  return unless(context.state.holds_piece, "No piece is held; grab one first.");
}

/// True if the report on what would have held a node offers that command.
bool is_offered(const CommandContext& context, std::string_view command) {
  return context.state.report &&
         std::ranges::find(context.state.report->actions, command, &ui::WorkReport::Action::command) !=
             context.state.report->actions.end();
}

constexpr std::string_view kNothingFound = "No such change was found; use What would have held it? first.";

std::string_view no_strength_found(const CommandContext& context) {
  return unless(is_offered(context, "time.apply_strength"), kNothingFound);
}
std::string_view no_speed_found(const CommandContext& context) {
  return unless(is_offered(context, "time.apply_speed"), kNothingFound);
}
std::string_view no_thickness_found(const CommandContext& context) {
  return unless(is_offered(context, "time.apply_thickness"), kNothingFound);
}

/// Makes the edit that would have held the node and closes the report. `effect`: what it begins.
void apply_found(Editor& e, void (*apply)(ui::EditHistory&, const HoldingFound&), const char* effect) {
  e.state().running = false;
  e.state().report.reset();
  apply(e.document().history(), *e.analysis().found());
  e.builder().follow_edits();
  log_message(e.state(), ui::LogLevel::info, std::string("Applied ") + effect + " Press Space to run it.",
              ui::LogSpan::advice);
}

/// Goes to a moment of the shown microsteps. False if none are shown.
bool go_to_moment(Editor& e, std::int64_t moment) {
  if (!e.state().microsteps) return false;
  e.run().go_to_moment(moment);
  return true;
}

/// The last edits belong to the time that is left.
RunController& run_to_travel(Editor& e) {
  e.builder().follow_edits();
  return e.run();
}

const EditorCommand kRunCommands[] = {
    {{.name = "simulation.run",
      .label = "Run",
      .hint = "Run or pause; while microsteps are shown, play them or pause",
      .menu = Menu::simulation,
      .shortcut = {key::kSpace},
      .is_on =
          [](const CommandContext& context) {
            return context.state.running || (context.state.microsteps && context.state.microsteps->playing);
          },
      .recorded = false},
     [](Editor& e, const ui::Command&) { e.run().toggle(); }},
    {{.name = "simulation.step",
      .label = "Step",
      .hint = "Pause and advance by one time step, or one of the shown microsteps",
      .menu = Menu::simulation,
      .shortcut = {'N'},
      .repeats = true},
     [](Editor& e, const ui::Command&) { e.run().step_once(); }},
    {{.name = "simulation.steps",
      .label = "Steps…",
      .hint = "Advance by a number of time steps as fast as possible",
      .menu = Menu::simulation,
      .shortcut = {'N', false, true}},
     [](Editor& e, const ui::Command&) { e.state().asked_steps = 10; }},
    {{.name = "simulation.reset",
      .label = "Reset",
      .hint = "Restart from the scene as edited",
      .menu = Menu::simulation,
      .shortcut = {'R'}},
     [](Editor& e, const ui::Command&) { e.builder().rebuild(); }},
    {{.name = "simulation.fire",
      .label = "Fire",
      .hint = "Fire the projectile at the cursor; or right-click in the view",
      .menu = Menu::simulation,
      .shortcut = {'F'},
      .argument = CommandArgument::cursor},
     [](Editor& e, const ui::Command& c) {
       e.run().fire(e.viewport().aimed_at(e.run().frame(), e.document().scene(), c.cursor).shot);
     }},
    {{.name = "simulation.grab",
      .label = "Grab",
      .hint = "Grab pieces in the view with the left button and pull them by a spring while the simulation runs",
      .menu = Menu::simulation,
      .shortcut = {'D'},
      .disabled_reason = without_motion,
      .is_on = [](const CommandContext& context) { return context.state.grab_tool; }},
     [](Editor& e, const ui::Command&) {
       toggle(e.state().grab_tool);
       e.state().push_tool = false;
     }},
    {{.name = "simulation.push",
      .label = "Push",
      .hint = "Push pieces by a click in the view, with an impulse along the line of sight",
      .menu = Menu::simulation,
      .shortcut = {'I'},
      .disabled_reason = without_motion,
      .is_on = [](const CommandContext& context) { return context.state.push_tool; }},
     [](Editor& e, const ui::Command&) {
       toggle(e.state().push_tool);
       e.state().grab_tool = false;
     }},
    {{.name = "simulation.keep_shot",
      .label = "Add last shot to scene",
      .hint = "Add the last shot to the scene and restart",
      .menu = Menu::simulation,
      .disabled_reason = nothing_fired},
     [](Editor& e, const ui::Command&) { keep_shot(e.document().history(), e.state()); }},
    {{.name = "time.back",
      .label = "Step back",
      .hint = "Go back by one time step, or one of the shown microsteps; repeated steps are identical to the bit",
      .menu = Menu::simulation,
      .group = 1,
      .shortcut = {key::kLeft},
      .disabled_reason = no_past},
     [](Editor& e, const ui::Command&) {
       if (e.state().microsteps && go_to_moment(e, e.state().microsteps->moment() - 1)) return;
       RunController& run = run_to_travel(e);
       run.go_to_nearest(run.timeline().step() - 1);
     }},
    {{.name = "time.start",
      .label = "Go to start",
      .hint = "Go to the first recorded step, or the first of the shown microsteps",
      .menu = Menu::simulation,
      .group = 1,
      .disabled_reason = no_past},
     [](Editor& e, const ui::Command&) {
       if (go_to_moment(e, 0)) return;
       RunController& run = run_to_travel(e);
       run.go_to_nearest(run.timeline().first_step());
     }},
    {{.name = "time.end",
      .label = "Go to end",
      .hint = "Go to the newest step of the branch, or the last of the shown microsteps",
      .menu = Menu::simulation,
      .group = 1,
      .disabled_reason = no_future},
     [](Editor& e, const ui::Command&) {
       if (go_to_moment(e, std::numeric_limits<std::int64_t>::max())) return;
       RunController& run = run_to_travel(e);
       run.go_to_nearest(run.timeline().last_step());
     }},
    {{.name = "time.microsteps",
      .label = "Microsteps",
      .hint = "Play the last step in slow motion, microstep by microstep: waves and cracks of an impact; or close it",
      .menu = Menu::simulation,
      .group = 1,
      .shortcut = {'U'},
      .disabled_reason = no_microsteps,
      .is_on = [](const CommandContext& context) { return context.state.microsteps.has_value(); }},
     [](Editor& e, const ui::Command&) {
       if (e.state().microsteps) return e.run().close_microsteps();
       e.builder().follow_edits();
       e.run().record_microsteps();
     }},
    {{.name = "time.finer",
      .label = "Finer microsteps",
      .hint = "Record microsteps around the shown one at an eighth of their interval",
      .disabled_reason = microsteps_not_shown},
     [](Editor& e, const ui::Command&) { e.run().record_finer_microsteps(); }},
    {{.name = "time.whole",
      .label = "Microsteps of the whole step",
      .hint = "Record microsteps from the first to the last of the step",
      .disabled_reason = microsteps_not_shown},
     [](Editor& e, const ui::Command&) { e.run().record_whole_step(); }},
    {{.name = "time.moment",
      .label = "Go to microstep",
      .hint = "Go to one of the recorded microsteps, counted from 0",
      .disabled_reason = microsteps_not_shown,
      .argument = CommandArgument::step},
     [](Editor& e, const ui::Command& c) { e.run().go_to_moment(c.step); }},
    {{.name = "time.holding",
      .label = "What would have held it?",
      .hint = "Find the strength, speed or thickness at which this node would hold, by repeating the step and the run",
      .menu = Menu::simulation,
      .group = 1,
      .disabled_reason = not_stopped_before_a_crack},
     [](Editor& e, const ui::Command&) {
       e.builder().follow_edits();
       e.analysis().explain_holding();
     }},
    {{.name = "time.stopped_node",
      .label = "Select the cracking node",
      .hint = "Select the node before whose crack the simulation has stopped, so that the panel explains it",
      .menu = Menu::simulation,
      .group = 1,
      .disabled_reason = not_stopped_before_a_crack},
     [](Editor& e, const ui::Command&) { select_node(e.state(), e.run().frame(), e.state().stop->node); }},
    {{.name = "time.apply_strength",
      .label = "Apply strength",
      .hint = "Give the body the strength at which the node holds, from this step on, as a branch",
      .disabled_reason = no_strength_found},
     [](Editor& e, const ui::Command&) {
       apply_found(e, apply_strength, "the strength, from this step on as a branch; B compares it with the other one.");
     }},
    {{.name = "time.apply_speed",
      .label = "Apply speed",
      .hint = "Slow all shots and moving bodies so that the node holds, and restart",
      .disabled_reason = no_speed_found},
     [](Editor& e, const ui::Command&) { apply_found(e, apply_speed, "the speed, from the start."); }},
    {{.name = "time.apply_thickness",
      .label = "Apply thickness",
      .hint = "Make the body so thick that the node holds, and restart",
      .disabled_reason = no_thickness_found},
     [](Editor& e, const ui::Command&) { apply_found(e, apply_thickness, "the thickness, from the start."); }},
    {{.name = "time.compare",
      .label = "Compare branches",
      .hint = "Show another branch at the same step next to this one, and where they first differ",
      .menu = Menu::simulation,
      .group = 1,
      .shortcut = {'B'},
      .disabled_reason = one_branch_alone,
      .is_on = [](const CommandContext& context) { return context.state.comparison.branch.has_value(); }},
     [](Editor& e, const ui::Command&) { e.analysis().toggle_comparison(); }},
    {{.name = "simulation.make_steps",
      .label = "Advance by steps",
      .hint = "Advance by a number of time steps, then stop",
      .argument = CommandArgument::step,
      .recorded = false},
     [](Editor& e, const ui::Command& c) { e.run().make_steps(c.step); }},
    {{.name = "simulation.grab_at",
      .label = "Grab at a point",
      .hint = "Grab the piece at a point of the view; a left drag with the tool Grab",
      .disabled_reason = without_motion,
      .argument = CommandArgument::cursor},
     [](Editor& e, const ui::Command& c) {
       if (const std::optional<Grab> grab = e.viewport().grabbed_at(e.run().shown(), c.cursor)) e.run().grab(*grab);
     }},
    {{.name = "simulation.push_at",
      .label = "Push at a point",
      .hint = "Push the piece at a point of the view along the line of sight; a click with the tool Push",
      .disabled_reason = without_motion,
      .argument = CommandArgument::cursor},
     [](Editor& e, const ui::Command& c) {
       if (const std::optional<Push> push = e.viewport().pushed_at(e.run().shown(), c.cursor)) e.run().push(*push);
     }},
    {{.name = "simulation.drag_to",
      .label = "Drag to a point",
      .hint = "Pull the grabbed piece to a point of the view, in a plane parallel to it",
      .disabled_reason = nothing_held,
      .argument = CommandArgument::cursor},
     [](Editor& e, const ui::Command& c) { e.run().drag(e.viewport().dragged_to(e.run().target(), c.cursor)); }},
    {{.name = "simulation.release",
      .label = "Release",
      .hint = "Let go of the grabbed piece",
      .disabled_reason = nothing_held},
     [](Editor& e, const ui::Command&) { e.run().release(); }},
    {{.name = "time.step",
      .label = "Go to step",
      .hint = "Go to a step of the recorded past",
      .argument = CommandArgument::step},
     [](Editor& e, const ui::Command& c) {
       RunController& run = run_to_travel(e);
       run.go_to(run.timeline().branch(), c.step);
     }},
    {{.name = "time.branch",
      .label = "Go to branch",
      .hint = "Go to the end of another branch",
      .argument = CommandArgument::branch_and_step},
     [](Editor& e, const ui::Command& c) { run_to_travel(e).go_to(c.branch, c.step); }},
};

}  // namespace

std::span<const EditorCommand> run_commands() { return kRunCommands; }

}  // namespace griffith::app
