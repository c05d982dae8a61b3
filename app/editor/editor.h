#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "app/editor/autosave.h"
#include "app/editor/background_step.h"
#include "app/editor/compared_branch.h"
#include "app/editor/holding_search.h"
#include "app/editor/macro_recorder.h"
#include "app/editor/rate_meter.h"
#include "app/editor/recent_files.h"
#include "app/editor/run_export.h"
#include "app/editor/run_history.h"
#include "app/editor/scene_gallery.h"
#include "app/editor/script.h"
#include "app/editor/step_pacer.h"
#include "app/editor/utilization_history.h"
#include "app/editor/world_loader.h"
#include "app/picture/draw_scene_from_frame.h"
#include "app/picture/steady_range.h"
#include "renderer/camera.h"
#include "renderer/image.h"
#include "renderer/renderer.h"
#include "sim/core/error.h"
#include "sim/recording/recording.h"
#include "sim/timeline/timeline.h"
#include "ui/panels/editor_layout.h"

namespace griffith::app {

class Editor;

/// Returns the user's folder for macros; empty if there is none.
std::filesystem::path macro_folder();

/// A file made from a picture of the window: a bug report or the plots.
struct PictureRequest {
  ui::SavedKind kind = ui::SavedKind::bug_report;
  std::filesystem::path file;
};

/// Action of a command.
struct CommandAction {
  ui::CommandId id;
  void (*carry_out)(Editor& editor, const ui::Command& command);
};

/// The editor without its window: scene, world, camera, picture and panels. Needs a current OpenGL context; each drawn
/// frame is advance(), draw_picture(), draw_panels().
class Editor {
 public:
  /// `edited`: unsaved version of the scene, if there is one. Throws InputError if the world cannot be built.
  Editor(Scene scene, std::filesystem::path path, const Scene* edited = nullptr);

  /// Makes the time steps that are due after `elapsed` [s] of real time, if the simulation runs.
  void advance(double elapsed);
  /// Lets advance() finish slow steps in the background while the window draws. This affects which steps are shown, but
  /// no step itself.
  void step_in_background() { waits_for_steps_ = false; }
  /// Returns the seconds until something must be drawn without an external event; infinite if nothing moves. Needs the
  /// context of ImGui.
  double seconds_to_next_frame() const;
  /// Makes one time step.
  void step();

  /// Draws the scene in the size that the panels left for it, if it has changed. `samples`: per pixel; those of the
  /// quality if absent.
  void draw_picture(std::optional<int> samples);
  /// Draws the panels into the current ImGui frame and executes the user's commands.
  void draw_panels(const ui::Fonts& fonts);

  /// Returns the action of each command of the registry.
  static std::span<const CommandAction> command_actions();
  /// Executes a command and shows problems. Asks first if unsaved edits would be lost.
  void execute(const ui::Command& command);
  /// Returns the reason why the command is disabled; empty if it is enabled.
  std::string_view disabled_reason(ui::CommandId id) const;
  /// Opens a scene without asking about unsaved edits. A problem is shown and changes nothing. If building its world
  /// takes long, a dialog that can cancel it is shown until the scene appears.
  void open(const std::filesystem::path& path);
  /// Enables the list of recent scenes, copies of unsaved edits, and the recovery of edits of a crashed run. `states`:
  /// as for Autosave.
  void enable_autosave(const std::filesystem::path& states);
  /// Sets the source of thumbnails for the scene browser.
  void show_thumbnails(ThumbnailSource source) { thumbnail_source_ = std::move(source); }
  /// Copies unsaved edits as often as the preferences say; call it often. `now`: seconds of a steady clock.
  void autosave(double now);
  /// Looks through a camera of the scene. Throws InputError if there is none of that name.
  void use_camera(const std::string& name);
  /// Changes the view by names of named_view.h. Throws InputError for unknown ones.
  void use_view(const std::string& names);
  /// Selects a node to be explained; does nothing if it does not exist.
  void select_node(NodeId node);
  void log(ui::LogLevel level, std::string text, ui::LogSpan span = ui::LogSpan::lasting);

  const Scene& scene() const { return history_.scene(); }
  ui::EditorState& state() { return state_; }
  const ui::EditorState& state() const { return state_; }
  const ui::WidgetTags& tags() const { return tags_; }
  Frame frame() const { return world().frame(); }
  const Timeline& timeline() const { return timeline_; }
  /// Returns the last drawn picture as passed to the renderer.
  const render::DrawScene& picture() const { return picture_; }
  std::string title() const;
  bool wants_to_quit() const { return wants_to_quit_; }
  /// True once after a screenshot was requested.
  bool take_screenshot_request();
  /// Returns the requested tour or macro, once.
  std::optional<Script> take_script_request();
  /// Sets the folder of macros, which also receives new ones.
  void use_macros(std::filesystem::path folder);
  /// Actions of scripts besides commands: setting fields of the scene, as it would be saved, or of the projectile tool;
  /// selecting entries by full name; moving the camera. All throw InputError, which names `where`.
  void set_values(std::span<const SceneSetting> settings, const std::string& where);
  void set_shot(std::span<const SceneSetting> settings, const std::string& where);
  void choose(const std::vector<std::string>& names, const std::string& where);
  void look_from(const Vec3& eye, const Vec3& target);
  /// Stops the simulation and shows the error.
  void show_error(const InputError& error);
  /// Returns a pending request for a picture of the window, once; save it with one of the next drawn frame.
  std::optional<PictureRequest> take_picture_request();
  /// Saves a bug report with run, log, versions and picture, or the plots in the picture; shows problems. `graphics`:
  /// name of the renderer.
  void save_window_picture(const PictureRequest& request, const render::Image& window, const std::string& graphics);

 private:
  /// Delay before the window shows that work is in progress [s].
  static constexpr double kBusyIndicatorDelay = 0.3;

  /// `edited`: unsaved version of the scene.
  void show_scene(Scene scene, std::filesystem::path path, const Scene* edited = nullptr);
  /// Shows the world made from the current scene.
  void restart();
  /// Rebuilds the world from the current scene.
  void follow();
  void take_followed(WorldLoader::Loaded loaded);
  /// Undoes or redoes the edits for which the world could not be built.
  void go_back_to_built();
  void log_findings();
  /// Lists the problems of the scene from which the world was built, and of its file.
  void list_problems();
  void follow_edits();
  void follow_materials();
  /// True if the world accepted the material; else the edit is undone.
  bool follow_material(int scene_body);
  void carry_out(const ui::Command& command);
  /// Reports why a command is disabled.
  void refuse(ui::CommandId id, std::string_view reason);
  void toggle_run();
  /// Runs until that many steps are made.
  void make_steps(std::int64_t count);
  void pause_and_step();
  void receive_world();
  /// Returns the number of tetrahedra that are built without confirmation: a small number, or slightly more than there
  /// are.
  double max_tets() const;
  /// Discards commands queued during work that failed, with a message.
  void discard_queued_commands();
  /// Ends work that led to no world; the shown one stays.
  void end_work();
  void take_world(WorldLoader::Loaded loaded);
  void add_new_body(const ui::Command& command);
  void new_scene();
  /// Adds the last shot to the scene.
  void keep_shot();
  void add_body(const std::string& label, BodyDescription body);
  void add_entry(const ui::Command& command);
  /// Adds a shot of the projectile tool from the eye at the camera's target.
  void add_projectile();
  /// Adds a camera with the current view.
  void add_camera();
  /// Looks through the active entry if it is a camera.
  void look_through();
  /// Sets that camera to the current view.
  void set_camera();
  void duplicate_entries();
  void remove_entries();
  /// Moves the selected entries in their lists, up (-1) or down (1).
  void move_entries(int way);
  void begin_renaming();
  /// Hides the selected bodies, or shows them if all are hidden.
  void toggle_hidden();
  /// Returns the hidden bodies by index in the scene from which the world was built.
  HiddenBodies hidden_bodies() const;
  void add_surface();
  void report_surface();
  /// Projectile that would be fired at a point of the view, with its target.
  struct AimedShot {
    ProjectileBurst shot;
    Vec3 target;
  };
  AimedShot aimed_at(const Vec2& cursor) const;
  ui::Aim aim() const;
  void fire(const Vec2& cursor);
  void pick(const Vec2& cursor);
  void save(const ui::Command& command);
  void ask_where_to_save(std::filesystem::path proposed = {});
  void ask_where_to_save_run(ui::SavedKind kind, std::filesystem::path proposed);
  /// Writes the recording or the plotted series, or requests the picture of a bug report.
  void save_run(const ui::Command& command);
  void write_recorded_run(const std::filesystem::path& path);
  /// Writes CSV at once, or a PNG of the next drawn frame.
  void write_plots(const std::filesystem::path& path);
  /// Throws InputError.
  void save_plots_picture(const std::filesystem::path& path, const render::Image& window);
  void save_report(const std::filesystem::path& path, const render::Image& window, const std::string& graphics);
  /// Returns the past of the selected node.
  std::vector<ui::UtilizationSample> utilizations_of_node() const;
  ui::RunCurves plotted_curves() const;
  /// Begins to export the current branch for other programs, as a video or as pictures of the view.
  void export_run(const std::filesystem::path& path);
  void go_on_with_export();
  /// Returns a recording of the current branch. Throws InputError if files of its scene have changed since the world
  /// was built.
  Recording recorded_run() const;
  /// Returns the absolute path of the scene's file; empty if there is none.
  std::filesystem::path own_file() const;
  /// Returns the loss that saving to the file would cause; empty if it is safe.
  std::string what_saving_would_lose(const std::filesystem::path& file) const;
  /// Offers the newest recoverable edits, of this scene or, at the start, of any.
  void offer_recovery(bool of_any);
  /// Puts the scene's file on top of the recent ones.
  void remember_file();
  /// Provides the cards of scenes while the browser is shown.
  void follow_browser();
  void list_macros();
  MacroMoment macro_moment() const;
  /// Passes changes to the macro being recorded, if there is one.
  void note_for_macro();
  void toggle_macro_recording();
  void ask_where_to_save_macro(std::filesystem::path proposed);
  void write_macro(const std::filesystem::path& path);
  void discard_copy();
  void leave_copy();
  void recover();
  void show_recovered(Scene scene, const std::filesystem::path& file);
  /// Ends the program and discards unsaved edits.
  void quit();
  void select(const ui::Selection& selection);
  void select_most_loaded();
  void frame_all();
  /// Moves the camera along its line of sight and sideways until the picture shows all of the box.
  void look_at(const Eigen::AlignedBox3f& bounds);
  /// Frames a scene without cameras again once the panels are laid out.
  void frame_for_layout();
  void toggle_range_lock();
  void toggle_slice();
  void add_scaling_label(const ui::Fonts& fonts, ui::EditorInput& input) const;
  const World& world() const { return timeline_.world(); }
  void carry_out_in_time(const ui::Command& command);
  /// Goes to a step given by the user. Throws InputError if it was not recorded.
  void go_to_recorded(int branch, std::int64_t step);
  /// Goes to a recorded step. The scene's materials become those that were in force.
  void go_to(int branch, std::int64_t step);
  /// True if a breakpoint lies in the step just made from `before`; the step is then undone.
  bool stop_before_step(World before);
  /// Recomputes past steps toward the requested one, for at most that many seconds.
  void continue_travel(double seconds);
  std::string travel_stage() const;
  void arrive();
  /// Makes the materials in force those of the scene, without an entry in its history.
  void adopt_materials();
  /// Describes the shown step: "step 31", with its branch if there are several.
  std::string moment_text() const;
  /// Clears the stop and the messages of the shown state.
  void leave_state();
  /// Begins to search the strength, speed and thickness at which the cracking node would hold.
  void explain_holding();
  void go_on_with_holding();
  ui::TimeView time_view() const;
  /// Compares with the parent branch or the newest one; or ends the comparison.
  void toggle_comparison();
  /// Brings the compared branch to the shown step.
  void follow_comparison();
  std::optional<ui::ComparisonView> comparison_view() const;
  void remember();
  /// Returns the starting point of a background step.
  BackgroundStep::Start step_start() const { return {world_count_, timeline_.revision()}; }
  bool watches() const { return state_.breakpoints.any() && !passes_stop_; }
  /// Makes steps for `elapsed` [s] of real time.
  void make_due_steps(double elapsed);
  /// Restarts all speed measurements, after a pause or in another scene.
  void reset_pace();
  /// `is_last`: last step before the next picture, which is made with it.
  void begin_background_step(bool is_last);
  /// Waits for the background step. True if it is finished by then. It is discarded if the world has changed meanwhile.
  bool end_background_step(BackgroundStep::Clock::time_point deadline);
  void take_step(BackgroundStep::Made made);
  /// Handles a finished step. `before`: the world before it, if breakpoints are set. `picture`: of the world, if any.
  void follow_step(std::optional<World> before, std::optional<StepPicture> picture);
  PictureSettings picture_settings() const;
  /// Takes over a picture of the world. True if it shows the current view.
  bool take_picture(StepPicture picture);
  /// Makes the picture of the world unless it exists.
  void update_picture();
  void move_slice(const ui::CameraMotion& motion);
  void move_camera();
  /// Moves the legend to a free corner, once for each camera, size and view, but not after a step.
  void place_legend(ui::Legend& legend, const ui::Fonts& fonts);
  float aspect() const;
  /// Returns the camera, widened so that a narrow view shows as much horizontally as a wide one.
  render::Camera picture_camera() const;

  /// Input of the picture's content; equal keys give equal pictures.
  struct ContentKey {
    std::int64_t world = -1, world_revision = -1, scene_revision = -1, arrivals = 0;
    ViewSettings view;
    ui::Selection selected;
    std::set<std::string> hidden;
    bool operator==(const ContentKey&) const = default;
  };
  ContentKey content_key() const;
  /// Input of the drawing; equal keys need no new drawing.
  struct PictureKey {
    ContentKey content;
    int width = 0, height = 0;
    int compared = -1;  ///< compared branch; -1: none
    Eigen::Vector3f position = Eigen::Vector3f::Zero(), target = Eigen::Vector3f::Zero();
    bool operator==(const PictureKey&) const = default;
  };
  PictureKey picture_key() const;
  void draw_comparison(const PictureKey& key, std::optional<int> samples);

  ui::EditHistory history_;
  ui::EditorState state_;
  ui::WidgetTags tags_;
  std::filesystem::path path_;
  /// Time of the file before it was read, or when it was last written; the earliest time if edits were recovered.
  std::filesystem::file_time_type file_time_;
  std::filesystem::file_time_type opened_time_;  ///< time of the file being opened, before it was read
  std::vector<std::filesystem::path> scene_files_;
  std::filesystem::file_time_type built_at_ = std::filesystem::file_time_type::clock::now();  ///< start of that
  Timeline timeline_;
  CopyOnWrite<EmbeddedDisplay> display_;  ///< display of the world
  std::vector<InputError> warnings_;      ///< warnings of the world from scene_warnings()
  std::vector<InputError> outdated_;      ///< outdated names in the scene's file
  std::vector<ui::SceneProblem> problems_;
  WorldLoader loader_;
  std::optional<Autosave> autosave_;
  RecentFiles recent_{""};
  ThumbnailSource thumbnail_source_;
  std::unique_ptr<SceneGallery> gallery_;               ///< while the browser is shown
  double copied_at_ = -ui::kAutosaveIntervals.maximum;  ///< time of the last copy of edits, by the clock of autosave()
  std::int64_t copied_revision_ = -1;                   ///< revision of the scene in that copy
  Scene built_;                      ///< scene from which the world was built, with its current materials
  std::int64_t seen_revision_ = -1;  ///< last revision of the scene compared with that
  std::int64_t world_count_ = 0;     ///< number of worlds made so far
  render::Camera camera_;
  render::Renderer renderer_;
  render::DrawScene picture_;
  ContentKey made_of_;  ///< input of the current picture
  SteadyRange range_;
  ui::LegendCorner legend_corner_ = {};
  PictureKey legend_placed_;  ///< picture for which the legend was placed
  PictureKey drawn_;
  RunHistory run_history_;
  std::unique_ptr<RunExport> export_;
  std::unique_ptr<HoldingSearch> holding_;
  std::unique_ptr<ComparedBranch> compared_;
  std::string difference_;  ///< text about the compared branch
  UtilizationHistory history_of_utilizations_;
  std::vector<ui::UtilizationSample> utilizations_;  ///< past of the selected node
  StepPacer pacer_;
  BackgroundStep background_;
  bool waits_for_steps_ = true;
  /// Past steps being recomputed, from the first to the last.
  std::optional<ui::StepSpan> travel_;
  std::int64_t arrivals_ = 0;             ///< number of jumps to another time
  bool passes_stop_ = false;              ///< makes the next step despite its breakpoint
  double step_seconds_ = 0;               ///< smoothed duration of a step
  RateMeter pictures_drawn_, time_made_;  ///< pictures per second; simulated time per second
  double made_since_advance_ = 0;         ///< time simulated since the last call of advance() [s]
  bool laid_out_ = false;                 ///< the size of the picture is known
  bool wants_to_quit_ = false, screenshot_requested_ = false;
  std::optional<Script> requested_script_;
  std::filesystem::path macro_folder_;
  std::vector<std::filesystem::path> macros_;  ///< macros in that folder, sorted
  std::optional<MacroRecorder> recorder_;      ///< while one is being recorded
  std::string recorded_macro_;                 ///< text of the last macro
  std::optional<PictureRequest> requested_picture_;
};

}  // namespace griffith::app
