#include <algorithm>

#include "app/editor/body_presets.h"
#include "app/editor/editor.h"
#include "app/editor/editor_commands.h"
#include "app/editor/entry_edits.h"
#include "app/editor/new_entry.h"
#include "ui/model/entry_choice.h"
#include "ui/model/entry_place.h"
#include "ui/model/entry_scale.h"

namespace griffith::app {
using ui::CommandContext;
using ui::GizmoTool;
using ui::Menu;
using ui::SnapTarget;
namespace key = ui::key;

namespace {

std::string_view nothing_to_undo(const CommandContext& context) {
  return unless(context.history.can_undo(), "There is no edit to undo.");
}

std::string_view nothing_to_redo(const CommandContext& context) {
  return unless(context.history.can_redo(), "There is no edit to redo.");
}

std::string_view no_body(const CommandContext& context) {
  return unless(!context.history.scene().bodies.empty(), "The scene has no body.");
}

std::string_view nothing_selected(const CommandContext& context) {
  return unless(ui::active_entry(context.state, context.history.scene()).has_value(),
                "Nothing is selected in the outliner.");
}

std::string_view nothing_to_move_up(const CommandContext& context) {
  const Scene& scene = context.history.scene();
  return unless(ui::can_move(scene, ui::selected_entries(context.state, scene), -1), "No selected entry can move up.");
}

std::string_view nothing_to_move_down(const CommandContext& context) {
  const Scene& scene = context.history.scene();
  return unless(ui::can_move(scene, ui::selected_entries(context.state, scene), 1), "No selected entry can move down.");
}

std::string_view no_region_selected(const CommandContext& context) {
  const Scene& scene = context.history.scene();
  const std::optional<ui::SceneEntry> entry = ui::active_entry(context.state, scene);
  return unless(context.state.paint_regions || (entry && ui::region_of(scene, *entry)),
                "No support, load or probe with a region is selected in the outliner.");
}

std::string_view nothing_with_a_name(const CommandContext& context) {
  const std::optional<ui::SceneEntry> entry = ui::active_entry(context.state, context.history.scene());
  return unless(entry && ui::has_name(entry->kind), "No entry with a name is selected in the outliner.");
}

std::string_view no_surface_named(const CommandContext& context) {
  return unless(context.state.surface.path[0] != '\0', "No surface file has been chosen.");
}

std::string_view nothing_to_scale(const CommandContext& context) {
  if (context.state.gizmo == GizmoTool::scale) return {};
  const Scene& scene = context.history.scene();
  const std::optional<ui::SceneEntry> entry = ui::active_entry(context.state, scene);
  return entry ? ui::scale_problem(scene, *entry) : "Nothing is selected in the outliner.";
}

/// Shows the handles, or hides them if they are shown.
void switch_gizmo(Editor& e, GizmoTool tool) { e.state().gizmo = e.state().gizmo == tool ? GizmoTool::none : tool; }

void switch_snap_target(ui::EditorState& state) {
  const bool surfaces = state.snap_target == SnapTarget::surfaces;
  state.snap_target = surfaces ? SnapTarget::round_values : SnapTarget::surfaces;
}

/// `body`: some decimeters large.
void add_typical_body(Editor& e, const ui::Command& command, const TypicalBody& body) {
  add_bodies(e.document().history(), e.state(), "Add " + std::string(command_info(command.name).label),
             {new_body(body, e.document().scene(), e.run().frame())});
}

/// Adds a preset next to all others.
void add_preset(Editor& e, const ui::Command& command, std::vector<BodyDescription> bodies) {
  add_bodies(e.document().history(), e.state(), "Add " + std::string(command_info(command.name).label),
             placed(std::move(bodies), e.document().scene(), e.run().frame()));
}

/// Adds the vase of the sample scenes, whose surface is a file next to them.
void add_vase(Editor& e, const ui::Command& command) {
  namespace fs = std::filesystem;
  const std::vector<fs::path>& files = e.scenes().files();
  const auto sample =
      std::ranges::find_if(files, [](const fs::path& file) { return file.filename() == "vase_shot.json"; });
  if (sample == files.end())
    throw InputError("the vase", "is not there: no folder scenes with vase_shot.json is next to the program",
                     "start the program in its folder, or add a body from a surface");
  add_preset(e, command, vase(*sample, e.document().scene().folder));
}

const EditorCommand kEditCommands[] = {
    {{.name = "edit.undo",
      .label = "Undo",
      .hint = "Undo the last edit of the scene",
      .menu = Menu::edit,
      .shortcut = {'Z', true},
      .disabled_reason = nothing_to_undo,
      .repeats = true},
     [](Editor& e, const ui::Command&) { e.document().history().undo(); }},
    {{.name = "edit.redo",
      .label = "Redo",
      .hint = "Redo the last undone edit",
      .menu = Menu::edit,
      .shortcut = {'Z', true, true},
      .disabled_reason = nothing_to_redo,
      .repeats = true},
     [](Editor& e, const ui::Command&) { e.document().history().redo(); }},
    {{.name = "edit.rename",
      .label = "Rename",
      .hint = "Rename the active entry of the outliner; or double-click it",
      .menu = Menu::edit,
      .group = 1,
      .shortcut = {key::kF1 + 1},
      .disabled_reason = nothing_with_a_name},
     [](Editor& e, const ui::Command&) { begin_renaming(e.state(), e.document().scene()); }},
    {{.name = "edit.duplicate",
      .label = "Duplicate",
      .hint = "Duplicate the entries selected in the outliner",
      .menu = Menu::edit,
      .group = 1,
      .shortcut = {'D', true},
      .disabled_reason = nothing_selected},
     [](Editor& e, const ui::Command&) { duplicate_entries(e.document().history(), e.state(), e.run().frame()); }},
    {{.name = "edit.delete",
      .label = "Delete",
      .hint = "Delete the entries selected in the outliner, and the probes of deleted bodies",
      .menu = Menu::edit,
      .group = 1,
      .shortcut = {key::kDelete},
      .disabled_reason = nothing_selected},
     [](Editor& e, const ui::Command&) { remove_entries(e.document().history(), e.state()); }},
    {{.name = "edit.move_up",
      .label = "Move up",
      .hint = "Move the selected entries up in the outliner; the first camera is the initial view",
      .menu = Menu::edit,
      .group = 1,
      .shortcut = {key::kUp, true},
      .disabled_reason = nothing_to_move_up},
     [](Editor& e, const ui::Command&) { move_entries(e.document().history(), e.state(), -1); }},
    {{.name = "edit.move_down",
      .label = "Move down",
      .hint = "Move the selected entries down in the outliner",
      .menu = Menu::edit,
      .group = 1,
      .shortcut = {key::kDown, true},
      .disabled_reason = nothing_to_move_down},
     [](Editor& e, const ui::Command&) { move_entries(e.document().history(), e.state(), 1); }},
    {{.name = "edit.gizmo",
      .label = "Move and rotate",
      .hint = "Show or hide the handles that move and rotate the selected entries, at the start only; Ctrl snaps",
      .menu = Menu::edit,
      .group = 1,
      .shortcut = {'G'},
      .disabled_reason = nothing_selected,
      .is_on = [](const CommandContext& context) { return context.state.gizmo == GizmoTool::place; }},
     [](Editor& e, const ui::Command&) { switch_gizmo(e, GizmoTool::place); }},
    {{.name = "edit.scale",
      .label = "Scale",
      .hint = "Show or hide the handles that scale the selected entries, at the start only; elements keep their size",
      .menu = Menu::edit,
      .group = 1,
      .shortcut = {'S'},
      .disabled_reason = nothing_to_scale,
      .is_on = [](const CommandContext& context) { return context.state.gizmo == GizmoTool::scale; }},
     [](Editor& e, const ui::Command&) { switch_gizmo(e, GizmoTool::scale); }},
    {{.name = "edit.snap",
      .label = "Snap",
      .hint = "Let the handles snap to round values or to surfaces; Ctrl inverts it during a drag",
      .menu = Menu::edit,
      .group = 1,
      .shortcut = {key::kTab, false, true},
      .is_on = [](const CommandContext& context) { return context.state.snap; }},
     [](Editor& e, const ui::Command&) { toggle(e.state().snap); }},
    {{.name = "edit.snap_to_surfaces",
      .label = "Snap to surfaces",
      .hint = "Snap moves to the ground and to other bodies, so that they touch, instead of to round values",
      .menu = Menu::edit,
      .group = 1,
      .is_on = [](const CommandContext& context) { return context.state.snap_target == SnapTarget::surfaces; }},
     [](Editor& e, const ui::Command&) { switch_snap_target(e.state()); }},
    {{.name = "edit.paint",
      .label = "Paint region",
      .hint = "Paint the nodes of the selected support, load or probe on its body, at the start only; Ctrl erases",
      .menu = Menu::edit,
      .group = 1,
      .shortcut = {'T'},
      .disabled_reason = no_region_selected,
      .is_on = [](const CommandContext& context) { return context.state.paint_regions; }},
     [](Editor& e, const ui::Command&) { toggle(e.state().paint_regions); }},
    {{.name = "add.box", .label = "Box", .hint = "Add a block of concrete: 500 mm", .menu = Menu::add},
     [](Editor& e, const ui::Command& c) {
       add_typical_body(
           e, c, {"box", "concrete", BoxShape{Vec3(0.5, 0.5, 0.5), Vec3::Constant(0.125), BoxPattern::five_tet}});
     }},
    {{.name = "add.plate",
      .label = "Plate",
      .hint = "Add a glass plate lying on the ground: 0.8 x 0.8 m, 20 mm thick",
      .menu = Menu::add},
     [](Editor& e, const ui::Command& c) {
       add_typical_body(
           e, c,
           {"plate", "soda_lime_glass", BoxShape{Vec3(0.8, 0.02, 0.8), Vec3(0.08, 0.01, 0.08), BoxPattern::five_tet}});
     }},
    {{.name = "add.pane",
      .label = "Pane",
      .hint = "Add an upright pane of glass: 0.8 x 0.8 m, 20 mm thick",
      .menu = Menu::add},
     [](Editor& e, const ui::Command& c) {
       add_typical_body(
           e, c,
           {"pane", "soda_lime_glass", BoxShape{Vec3(0.8, 0.8, 0.02), Vec3(0.08, 0.08, 0.01), BoxPattern::five_tet}});
     }},
    {{.name = "add.cylinder",
      .label = "Cylinder",
      .hint = "Add a column of concrete: 0.6 m high, 200 mm thick",
      .menu = Menu::add},
     [](Editor& e, const ui::Command& c) {
       add_typical_body(
           e, c,
           {"cylinder", "concrete", CylinderShape{0.1, 0.6, Vec2(0.05, 0.06), BoxPattern::five_tet}, Vec3(90, 0, 0)});
     }},
    {{.name = "add.sphere", .label = "Sphere", .hint = "Add a ball of concrete: 400 mm", .menu = Menu::add},
     [](Editor& e, const ui::Command& c) {
       add_typical_body(e, c, {"sphere", "concrete", SphereShape{0.2, 0.08, BoxPattern::five_tet}});
     }},
    {{.name = "add.beam",
      .label = "Notched beam",
      .hint = "Add a concrete beam with a notch in its underside: 1.2 x 0.2 x 0.2 m",
      .menu = Menu::add},
     [](Editor& e, const ui::Command& c) {
       add_typical_body(e, c,
                        {"beam", "concrete",
                         NotchedBeamShape{Vec3(1.2, 0.2, 0.2), 0.05, Vec3::Constant(0.05), BoxPattern::five_tet}});
     }},
    {{.name = "add.brick_wall",
      .label = "Brick wall",
      .hint = "Add a wall of bricks on a fixed foot: 2.5 x 2 m, 250 mm thick",
      .menu = Menu::add},
     [](Editor& e, const ui::Command& c) { add_preset(e, c, brick_wall()); }},
    {{.name = "add.table",
      .label = "Table",
      .hint = "Add a table: a glass top of 1.2 x 0.7 m, 10 mm thick, on four wooden legs",
      .menu = Menu::add},
     [](Editor& e, const ui::Command& c) { add_preset(e, c, table()); }},
    {{.name = "add.vase",
      .label = "Vase",
      .hint = "Add a vase of earthenware: 0.52 m high, its wall 30 mm thick",
      .menu = Menu::add},
     add_vase},
    {{.name = "file.add_surface",
      .label = "Add a body from a surface…",
      .hint = "Fill a surface file with tetrahedra and add it to the scene",
      .menu = Menu::add,
      .group = 1},
     [](Editor& e, const ui::Command&) { e.state().show_surface = true; }},
    {{.name = "add.support",
      .label = "Support",
      .hint = "Fix the lower end of the selected body",
      .menu = Menu::add,
      .group = 2,
      .disabled_reason = no_body},
     [](Editor& e, const ui::Command&) {
       add_support(e.document().history(), e.state(), e.run().frame(), e.run().built());
     }},
    {{.name = "add.load",
      .label = "Load",
      .hint = "Apply pressure to the upper end of the selected body",
      .menu = Menu::add,
      .group = 2,
      .disabled_reason = no_body},
     [](Editor& e, const ui::Command&) {
       add_load(e.document().history(), e.state(), e.run().frame(), e.run().built());
     }},
    {{.name = "add.probe",
      .label = "Probe",
      .hint = "Record the motion of the center of the selected body",
      .menu = Menu::add,
      .group = 2,
      .disabled_reason = no_body},
     [](Editor& e, const ui::Command&) {
       add_probe(e.document().history(), e.state(), e.run().frame(), e.run().built());
     }},
    {{.name = "add.projectile",
      .label = "Projectile",
      .hint = "Add the shot of the projectile tool, fired from the camera along its line of sight",
      .menu = Menu::add,
      .group = 2},
     [](Editor& e, const ui::Command&) { add_projectile(e.document().history(), e.state(), e.viewport().camera()); }},
    {{.name = "add.camera",
      .label = "Camera from view",
      .hint = "Add a camera with the current view to the scene",
      .menu = Menu::add,
      .group = 2},
     [](Editor& e, const ui::Command&) { add_camera(e.document().history(), e.state(), e.viewport().camera()); }},
    {{.name = "file.fill_surface",
      .label = "Fill surface",
      .hint = "Fill the surface given in the dialog",
      .disabled_reason = no_surface_named,
      .for_pictures = false},
     [](Editor& e, const ui::Command&) { e.builder().add_surface(); }},
};

}  // namespace

std::span<const EditorCommand> edit_commands() { return kEditCommands; }

}  // namespace griffith::app
