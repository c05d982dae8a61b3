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

#include "sim/scene/scene.h"
#include "ui/model/commands.h"
#include "ui/model/comparison.h"
#include "ui/model/edit_history.h"
#include "ui/model/gizmo.h"
#include "ui/model/number_edit.h"
#include "ui/model/painted_region.h"
#include "ui/model/preferences.h"
#include "ui/model/run_curves.h"
#include "ui/model/scene_browser.h"
#include "ui/model/scene_entry.h"
#include "ui/model/scene_problem.h"
#include "ui/model/selection.h"
#include "ui/model/stop.h"
#include "ui/model/time_view.h"

namespace griffith::ui {

/// What the mouse asked of the camera in one drawn frame.
struct CameraMotion {
  float yaw = 0, pitch = 0;             ///< turn about the target [rad]
  float pan_right = 0, pan_up = 0;      ///< of camera and target, in heights of the picture
  float zoom = 1;                       ///< factor on the distance to the target
  float slice_right = 0, slice_up = 0;  ///< of the slice plane, in heights of the picture
  bool operator==(const CameraMotion&) const = default;
};

/// What the utilization of a node was at a time.
struct UtilizationSample {
  double time = 0;  ///< [s]
  float utilization = 0;
  bool broke = false;  ///< the node separated under it
};

/// What an error dialog says.
struct ErrorMessage {
  std::string where, problem, remedy;
};

/// A body to be filled from a surface file, as the dialog for it has it.
struct SurfaceRequest {
  std::array<char, 512> path = {};
  double scale = 1;            ///< metres per unit of the file
  bool automatic_size = true;  ///< the size of the elements follows from that of the surface
  double element_size = 0.1;   ///< else this [m]
  MeshingMethod method = MeshingMethod::automatic;
};

/// What a dialog asks a place for.
enum class SavedKind { scene, recording, bug_report, plots, exported, macro };

/// Where something is to be saved, as the dialog for it has it.
struct SaveTarget {
  SavedKind kind = SavedKind::scene;
  std::filesystem::path folder;  ///< where relative names start, absolute
  std::array<char, 512> name = {};
  std::vector<std::string> there;  ///< names of scenes in the folder
};
/// Proposes the file's folder and name.
SaveTarget save_target(const std::filesystem::path& file, SavedKind kind = SavedKind::scene);
/// The file; ends as files of its kind do, whether that was typed or not.
std::filesystem::path file_of(const SaveTarget& target);

/// A save that would lose what another has written.
struct Replacement {
  Command command;
  std::string problem;  ///< "/home/me/wall.json is there already."
};

/// Why the last edit of a field was not taken as it was meant.
struct FieldNote {
  std::string tag;  ///< of the field; empty: there is nothing to say
  std::string text;
};

/// What there is to tell about work that went well.
struct WorkReport {
  std::string title;
  std::vector<std::string> facts, warnings;
};

enum class LogLevel { info, warning, error };

/// For how long a message is true.
enum class LogSpan {
  lasting,  ///< of something that was done
  state,    ///< while the simulation stays in the state that is shown
  action,   ///< and the user does nothing else
};

struct LogLine {
  LogLevel level = LogLevel::info;
  std::string text;
  LogSpan span = LogSpan::lasting;
};

/// What the panel of messages shows.
struct LogView {
  bool shown = false;
  std::array<bool, 3> levels = {true, true, true};  ///< by LogLevel
  std::array<char, 64> filter = {};                 ///< what the shown lines hold
  float height = 0;                                 ///< of the panel [pixels]; 0: not laid out yet
};

/// The search for a command.
struct Palette {
  bool shown = false;
  std::array<char, 64> text = {};  ///< being typed
  int chosen = 0;                  ///< among those that match
};

/// What a script says to the reader.
struct Caption {
  enum class Answer { none, next, skip };
  std::string text;
  std::string tag;  ///< of the widget that it is about; may be empty
  Answer answer = Answer::none;
};

/// What the editor itself remembers: nothing of it is part of the scene, nothing of it influences results of a step.
struct EditorState {
  bool running = false;
  Breakpoints breakpoints;
  std::optional<Stop> stop;        ///< the simulation stopped by itself in the state that is shown, and why
  double speed = 1;                ///< simulated seconds per second, 0.001..1
  std::int64_t steps_left = 0;     ///< until the simulation, which runs, is to stop; 0: it goes on
  std::optional<int> asked_steps;  ///< so many are being asked for
  ViewSettings view;               ///< as shown now; starts with the scene's
  ProjectileBurst shot;            ///< what the projectile tool fires; position and direction come from the cursor
  std::optional<Vec2> aimed_at;    ///< while a shot is being aimed: place in the view, from its top left corner, 0..1
  std::optional<ProjectileBurst> last_shot;  ///< as it was fired, and when; until it is part of the scene
  int selected_body = 0;                     ///< index into Scene::bodies
  std::vector<SceneEntry> entries;           ///< chosen in the outliner, in that order; empty: the selected body
  std::optional<SceneEntry> listed_entry;    ///< the active one, when the outliner was drawn last
  std::optional<SceneEntry> renamed;         ///< whose name is being typed
  std::string new_name;
  std::set<std::string> hidden_bodies;        ///< by name: not drawn
  bool list_pieces = false;                   ///< the list of bodies holds each piece by itself
  std::array<char, 64> body_filter = {};      ///< what the listed ones have in their name or state
  FieldNote field_note;                       ///< of the last edit, until the next click
  Selection selection;                        ///< picked in the view; follows the material when a body breaks
  bool show_gizmo = false;                    ///< handles that move and turn what is chosen
  std::optional<RegionDrag> region_drag;      ///< while a part of a region is held
  bool paint_regions = false;                 ///< the mouse paints the region of what is chosen
  std::optional<RegionStroke> region_stroke;  ///< while it does
  std::optional<GizmoDrag> gizmo_drag;        ///< while one is held
  CameraMotion camera_motion;
  ImVec2 viewport_minimum = {0, 0}, viewport_size = {0, 0};  ///< of the picture, as drawn last [pixels]
  float left_width = 0, right_width = 0;                     ///< of the side panels [pixels]; 0: not laid out yet
  bool show_times = true;      ///< milliseconds and pictures a second; off makes pictures of the panels reproducible
  bool open_sections = false;  ///< all parts of the panels that can be folded are open, for pictures of them
  bool show_help = false, show_open = false, show_surface = false;
  SurfaceRequest surface;
  std::optional<WorkReport> report;
  std::string work;                  ///< what is being done while a world is built; empty: nothing
  bool cancel_work = false;          ///< the user wants no more of it
  std::vector<Command> waiting;      ///< asked for by keys meanwhile; carried out after it, in that order
  std::optional<double> large_mesh;  ///< the tetrahedra that work would make: so many that it waits for an answer
  bool build_large_mesh = false;     ///< the answer is yes
  std::optional<ErrorMessage> error;
  std::optional<Command> unsaved;          ///< waits for an answer: it would lose edits that are not saved
  std::optional<SaveTarget> save_as;       ///< being asked for
  std::optional<Replacement> replacement;  ///< waits for an answer
  std::optional<Command> after_save;       ///< what the scene is being saved for
  std::string left_edits;                  ///< which edits were cut short and are waiting for an answer; empty: none
  Preferences preferences;
  bool show_preferences = false;
  double wanted_scale = 0;  ///< being dragged in the preferences; 0: not shown yet
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
  std::size_t log_seen = 0;              ///< so many of the lines are older than the last thing that the user did
  std::size_t log_passed = 0;            ///< and so many are older than the state of the simulation that is shown
  std::array<char, 512> path_text = {};  ///< being typed in the open dialog
  NumberEdit number;                     ///< the number field being dragged or typed into
};

/// Whether work goes on, something waits for it, or steps that were asked for are being made.
inline bool is_busy(const EditorState& state) {
  return !state.work.empty() || !state.waiting.empty() || state.steps_left > 0;
}

}  // namespace griffith::ui
