#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "sim/scene/grab.h"
#include "sim/scene/scene.h"
#include "ui/model/commands.h"
#include "ui/model/comparison.h"
#include "ui/model/edit_history.h"
#include "ui/model/four_views.h"
#include "ui/model/gizmo.h"
#include "ui/model/microsteps.h"
#include "ui/model/number_edit.h"
#include "ui/model/painted_region.h"
#include "ui/model/preferences.h"
#include "ui/model/render_request.h"
#include "ui/model/run_curves.h"
#include "ui/model/scene_browser.h"
#include "ui/model/scene_entry.h"
#include "ui/model/scene_problem.h"
#include "ui/model/selection.h"
#include "ui/model/stop.h"
#include "ui/model/symbol.h"
#include "ui/model/time_view.h"

namespace griffith::ui {

/// Camera motion requested by the mouse in one drawn frame.
struct CameraMotion {
  float yaw = 0, pitch = 0;             ///< rotation about the target [rad]
  float pan_right = 0, pan_up = 0;      ///< displacement of camera and target, in heights of the picture
  float zoom = 1;                       ///< factor on the distance to the target
  float slice_right = 0, slice_up = 0;  ///< displacement of the slice plane, in heights of the picture
  bool operator==(const CameraMotion&) const = default;
};

/// Utilization of a node at one time.
struct UtilizationSample {
  double time = 0;  ///< [s]
  float utilization = 0;
  bool broke = false;  ///< the node separated under it
};

/// Text of an error dialog.
struct ErrorMessage {
  std::string where, problem, remedy;
};

/// Input of the dialog that fills a surface file with elements.
struct SurfaceRequest {
  std::array<char, 512> path = {};
  double scale = 1;            ///< meters per unit of the file
  bool automatic_size = true;  ///< derives the size of the elements from that of the surface
  double element_size = 0.1;   ///< size of the elements if it is not automatic [m]
  MeshingMethod method = MeshingMethod::automatic;
};

/// Input of the dialog that repeats bodies.
struct ArrayRequest {
  int count = 2;                ///< number of each body, 2..kMaxArray
  Vec3 offset = Vec3::UnitX();  ///< from each one to the next [m]
};

/// Kind of file that a dialog saves.
enum class SavedKind { scene, recording, bug_report, plots, exported, macro };

/// Input of the save dialog.
struct SaveTarget {
  SavedKind kind = SavedKind::scene;
  std::filesystem::path folder;  ///< base of relative names, absolute
  std::array<char, 512> name = {};
  std::vector<std::string> existing;  ///< names of the scenes in the folder
  bool pack_outside = false;          ///< recordings hold files from outside the scene's folder, too
};
/// Returns the extension of files of that kind: ".json".
std::string_view extension_of(SavedKind kind);
/// Proposes the file's folder and name.
SaveTarget save_target(const std::filesystem::path& file, SavedKind kind = SavedKind::scene);
/// Returns the file to write; its extension is appended where it is missing.
std::filesystem::path file_of(const SaveTarget& target);

/// A save that would replace a file of another program.
struct Replacement {
  Command command;
  std::string problem;  ///< "/home/me/wall.json is there already."
};

/// Message about an edit that was not accepted as typed.
struct FieldNote {
  std::string tag;  ///< tag of the field; empty: no message
  std::string text;
};

/// Message about work that succeeded.
struct WorkReport {
  /// A button that issues a command.
  struct Action {
    std::string_view command;
    std::string label;
  };
  std::string title;
  std::vector<std::string> facts, warnings;
  std::vector<Action> actions = {};
};

enum class LogLevel { info, warning, error };

/// Validity of a message.
enum class LogSpan {
  lasting,  ///< until the next message: reports something that was done
  state,    ///< as long as the simulation stays in the shown state
  action,   ///< until the state changes or the user does something else
  advice,   ///< until the user does something, in whatever state: says what to do next
};

struct LogLine {
  LogLevel level = LogLevel::info;
  std::string text;
  LogSpan span = LogSpan::lasting;
};

/// Settings of the message panel.
struct LogView {
  bool shown = false;
  std::array<bool, 3> levels = {true, true, true};  ///< by LogLevel
  std::array<char, 64> filter = {};                 ///< text that the shown lines contain
  float height = 0;                                 ///< height of the panel [pixels]; 0: not laid out yet
};

/// State of the command palette.
struct Palette {
  bool shown = false;
  std::array<char, 64> text = {};  ///< search text
  int chosen = 0;                  ///< index among the matching entries
};

/// Text that a script shows to the user.
struct Caption {
  enum class Answer { none, next, skip };
  std::string text;
  std::string tag;  ///< tag of the widget that it refers to; may be empty
  Answer answer = Answer::none;
};

/// A push, as the view shows it for some steps.
struct PushMark {
  std::int64_t step = 0;                              ///< step that it follows
  Vec3 point = Vec3::Zero(), impulse = Vec3::Zero();  ///< [m], [N·s]
};

/// Rectangle of a section of a side panel [pixels].
struct SectionArea {
  std::string name;
  bool is_left = true;
  ImVec2 low, high;
};

/// State of the editor itself: neither part of the scene nor relevant to the result of a step.
struct EditorState {
  bool running = false;
  Breakpoints breakpoints;
  std::optional<Stop> stop;                     ///< reason why the simulation stopped by itself in the shown state
  double speed = 1;                             ///< simulated seconds per second, 0.001..1
  std::optional<MicrostepPlayback> microsteps;  ///< while microsteps are shown
  double microstep_seconds = 8;                 ///< time in which all recorded microsteps are played [s]
  bool explain_first_crack = false;   ///< selects the node of the next crack, so that the inspector explains it
  std::int64_t steps_left = 0;        ///< steps until the simulation stops; 0: runs on
  std::optional<int> asked_steps;     ///< number in the dialog that asks for steps
  RenderRequest render;               ///< input of the dialog that draws pictures
  std::optional<ArrayRequest> array;  ///< input of the dialog that repeats bodies while it is open
  ViewSettings view;                  ///< current view; starts with the scene's
  ProjectileBurst shot;               ///< settings of the projectile tool; position and direction come from the cursor
  std::optional<Vec2> aimed_at;       ///< while a shot is aimed: point of the viewport, from its top left corner, 0..1
  std::optional<ProjectileBurst> last_shot;  ///< last shot with its time, until it is added to the scene
  bool grab_tool = false;                    ///< the left button grabs pieces in the view
  GrabSpring grab_spring;                    ///< spring of the next grab
  bool holds_piece = false;                  ///< the mouse or a script holds a piece
  bool mouse_grabs = false;                  ///< the left button went down to grab
  bool push_tool = false;                    ///< a click pushes the piece below it
  double push_speed = 2;                     ///< speed that the next push gives to a free piece [m/s]
  std::optional<PushMark> push_mark;         ///< last push
  std::optional<Material> dragged_material;  ///< while a material is dragged onto a body
  std::optional<Vec2> pointed_at;         ///< point of the viewport below the mouse, 0..1, while a tool needs its piece
  int selected_body = 0;                  ///< index into Scene::bodies
  std::vector<SceneEntry> entries;        ///< entries selected in the outliner, in that order; empty: the selected body
  std::vector<std::string> added_bodies;  ///< names of bodies to bring into view once they are built
  std::optional<SceneEntry> listed_entry;  ///< the active entry when the outliner was drawn last
  std::optional<SceneEntry> renamed;       ///< entry whose name is being typed
  std::string new_name;
  std::set<std::string> hidden_bodies;    ///< names of the bodies that are not drawn
  bool list_pieces = false;               ///< lists each piece instead of each body
  std::array<char, 64> body_filter = {};  ///< text that the listed names or states contain
  FieldNote field_note;                   ///< message about the last edit, until the next click
  Selection selection;                    ///< picked in the view; follows the material through fracture
  std::optional<Symbol> symbol;           ///< symbol of a layer picked in the view
  GizmoTool gizmo = GizmoTool::none;      ///< handles of the selected entries in the view
  bool snap = false;                      ///< drags of handles snap; Ctrl inverts it
  SnapTarget snap_target = SnapTarget::round_values;
  std::optional<RegionDrag> region_drag;      ///< while a grip of a region is dragged
  bool paint_regions = false;                 ///< the mouse paints the region of the active entry
  std::optional<RegionStroke> region_stroke;  ///< while a stroke is painted
  std::optional<GizmoDrag> gizmo_drag;        ///< while a handle is dragged
  CameraMotion camera_motion;
  ImVec2 viewport_minimum = {0, 0}, viewport_size = {0, 0};  ///< rectangle of the pictures as drawn last [pixels]
  FourViews four_views;
  float left_width = 0, right_width = 0;     ///< widths of the side panels [pixels]; 0: not laid out yet, or hidden
  std::vector<SectionArea> section_areas;    ///< sections of the side panels as drawn last
  std::optional<std::string> moved_section;  ///< section that is being dragged
  bool show_times = true;  ///< shows milliseconds and frames per second; off for reproducible pictures of the panels
  bool open_sections = false;  ///< unfolds all sections of the panels, for pictures of them
  bool show_help = false, show_open = false, show_surface = false;
  SurfaceRequest surface;
  std::optional<WorkReport> report;
  std::string work;                  ///< description of the work while a world is built; empty: none
  bool cancel_work = false;          ///< the user cancelled the work
  std::vector<Command> waiting;      ///< commands queued by keys during the work, in order
  bool lost_click = false;           ///< true once a click beside the dialog of the work was lost
  std::optional<double> large_mesh;  ///< tetrahedra that the work would make, while it waits for confirmation
  bool build_large_mesh = false;     ///< confirmation of the large mesh
  std::optional<ErrorMessage> error;
  std::optional<Command> unsaved;          ///< command that would discard unsaved edits, while it waits for an answer
  std::optional<SaveTarget> save_as;       ///< input of the save dialog while it is open
  std::optional<Replacement> replacement;  ///< waits for an answer
  std::optional<Command> after_save;       ///< command that follows the save
  std::string
      recoverable_edits;  ///< description of edits that can be recovered, while they wait for an answer; empty: none
  Preferences preferences;
  bool show_preferences = false;
  double dragged_scale = 0;  ///< while it is dragged in the preferences; 0: not shown yet
  Palette palette;
  SceneBrowser browser;
  LogView log_view;
  ProblemView problem_view;
  SoughtField sought;
  bool recording_macro = false;
  PlotsState plots;
  Comparison comparison;
  std::optional<Caption> caption;
  std::vector<LogLine> log;
  std::size_t log_seen = 0;              ///< lines that are older than the user's last action
  std::size_t log_passed = 0;            ///< lines that are older than the shown state of the simulation
  std::array<char, 512> path_text = {};  ///< text of the open dialog
  NumberEdit number;                     ///< the number field being dragged or typed into
  std::string number_to_open;            ///< tag of the number field to be typed into from the next frame on
  KeptUnit kept_unit;                    ///< unit of the row typed into last
};

/// True if work is in progress or waits for an answer, or requested steps are being made.
inline bool is_busy(const EditorState& state) {
  return !state.work.empty() || !state.waiting.empty() || state.steps_left > 0;
}

/// Restores the usual places and sizes of panels, with one view.
void reset_layout(EditorState& state);

}  // namespace griffith::ui
