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

/// The user's folder for macros; empty where there is none.
std::filesystem::path macro_folder();

/// A file that is to be made of a picture of the window: a bug report or the plots.
struct PictureRequest {
  ui::SavedKind kind = ui::SavedKind::bug_report;
  std::filesystem::path file;
};

/// What carries out a command.
struct CommandAction {
  ui::CommandId id;
  void (*carry_out)(Editor& editor, const ui::Command& command);
};

/// The editor but for its window: scene, world, camera, picture and panels. Needs a current OpenGL context; each drawn
/// frame is advance(), draw_picture(), draw_panels().
class Editor {
 public:
  /// `edited`: what the scene has been changed to since it was read, if anything. Throws InputError when it can't be
  /// built.
  Editor(Scene scene, std::filesystem::path path, const Scene* edited = nullptr);

  /// Makes the time steps that are due after `elapsed` [s] of real time, if the simulation runs.
  void advance(double elapsed);
  /// From now on advance() lets a step that takes long go on in the background while the window draws. Which pictures
  /// there are depends on that, no step does.
  void step_in_background() { waits_for_steps_ = false; }
  /// In how many seconds there is something to be drawn that nothing from outside has brought about; infinite where
  /// all rests. Needs the context of ImGui.
  double seconds_to_next_frame() const;
  /// Makes one time step.
  void step();

  /// Draws the scene in the size that the panels left for it, if anything in it changed. `samples`: per pixel, those of
  /// the quality if absent.
  void draw_picture(std::optional<int> samples);
  /// Draws the panels into the current ImGui frame and carries out what the user asked for.
  void draw_panels(const ui::Fonts& fonts);

  /// What carries out each command of the registry.
  static std::span<const CommandAction> command_actions();
  /// Carries out what the user asked for; problems are shown. What would lose edits that are not saved asks first.
  void execute(const ui::Command& command);
  /// Why the command makes no sense now; empty: it does.
  std::string_view why_not(ui::CommandId id) const;
  /// Opens a scene, whatever becomes of the edits of this one; a problem is shown and leaves everything as it was.
  /// Where its world takes longer to build, the scene appears when that is done, and a dialog that can cancel it shows
  /// until then.
  void open(const std::filesystem::path& path);
  /// From now on remembers which scenes were opened, keeps a copy of edits that are not saved, and asks what is to
  /// become of those that a crash left. `states`: as Autosave has it.
  void keep_edits_safe(const std::filesystem::path& states);
  /// From now on the browser of scenes shows thumbnails of that source.
  void show_thumbnails(ThumbnailSource source) { thumbnail_source_ = std::move(source); }
  /// To be called often: copies what has been edited, as often as the preferences say. `now`: seconds of a clock that
  /// goes on.
  void autosave(double now);
  /// Looks through that camera of the scene. Throws InputError when there is none.
  void use_camera(const std::string& name);
  /// Changes what is shown by names, as named_view.h has them. Throws InputError for unknown ones.
  void use_view(const std::string& names);
  /// Chooses a node to be explained; nothing happens where there is none of that number.
  void select_node(NodeId node);
  void log(ui::LogLevel level, std::string text, ui::LogSpan span = ui::LogSpan::lasting);

  const Scene& scene() const { return history_.scene(); }
  ui::EditorState& state() { return state_; }
  const ui::EditorState& state() const { return state_; }
  const ui::WidgetTags& tags() const { return tags_; }
  Frame frame() const { return world().frame(); }
  const Timeline& timeline() const { return timeline_; }
  /// The picture that was drawn last, before the graphics device had it.
  const render::DrawScene& picture() const { return picture_; }
  std::string title() const;
  bool wants_to_quit() const { return wants_to_quit_; }
  /// True once after a screenshot was asked for.
  bool take_screenshot_request();
  /// The tour or the macro that was asked for, once.
  std::optional<Script> take_script_request();
  /// From now on offers the macros of that folder, and proposes it for new ones.
  void use_macros(std::filesystem::path folder);
  /// What scripts do besides commands: gives fields of the scene, as it would be saved now, or of the projectile tool
  /// other values, chooses entries by their full names, moves the camera. All throw InputError, which names `where`.
  void set_values(std::span<const SceneSetting> settings, const std::string& where);
  void set_shot(std::span<const SceneSetting> settings, const std::string& where);
  void choose(const std::vector<std::string>& names, const std::string& where);
  void look_from(const Vec3& eye, const Vec3& target);
  /// Stops the simulation and shows what did not work.
  void show_error(const InputError& error);
  /// What needs a picture of the window, once; it is to be saved with one of the next drawn frame.
  std::optional<PictureRequest> take_picture_request();
  /// Saves a bug report with the run, the log, versions and the picture, or the plots in it; problems are shown.
  /// `graphics`: what drew the picture.
  void save_window_picture(const PictureRequest& request, const render::Image& window, const std::string& graphics);

 private:
  /// Seconds that the window may stand still before it shows that work is going on.
  static constexpr double kPatience = 0.3;

  /// `edited`: what has become of the scene, where that is not saved.
  void show_scene(Scene scene, std::filesystem::path path, const Scene* edited = nullptr);
  /// Shows the world that was made from the scene as it is.
  void restart();
  /// Builds the world again from the scene as it is.
  void follow();
  void take_followed(WorldLoader::Loaded loaded);
  /// Undoes or redoes what the world could not be built for.
  void go_back_to_built();
  void log_findings();
  /// Lists what there is to know about the scene that the world was built from, and about its file.
  void list_problems();
  void follow_edits();
  void follow_materials();
  /// Whether the world could take it; else the edit is taken back.
  bool follow_material(int scene_body);
  void carry_out(const ui::Command& command);
  /// Says why a command is not carried out.
  void refuse(ui::CommandId id, std::string_view reason);
  void toggle_run();
  /// Runs until so many steps are made.
  void make_steps(std::int64_t count);
  void pause_and_step();
  void receive_world();
  /// So many tetrahedra are built unasked: few, or no many more than there are.
  double max_tets() const;
  /// Drops what keys have asked for while work went on that came to nothing, and says so.
  void forget_waiting();
  /// After work that led to no world: what is shown goes on.
  void give_up_work();
  void take_world(WorldLoader::Loaded loaded);
  void add_new_body(const ui::Command& command);
  void new_scene();
  /// Makes the shot that was fired last a part of the scene.
  void keep_shot();
  void add_body(const std::string& label, BodyDescription body);
  void add_entry(const ui::Command& command);
  /// Adds the shot of the projectile tool, fired from the eye at what is looked at.
  void add_projectile();
  /// Adds a camera that shows what the view shows.
  void add_camera();
  /// Looks through the active entry, where it is a camera.
  void look_through();
  /// Lets that camera show what the view shows.
  void set_camera();
  void duplicate_entries();
  void remove_entries();
  /// Moves the chosen entries in their lists, up (-1) or down (1).
  void move_entries(int way);
  void begin_renaming();
  /// Hides the chosen bodies, or shows them where all are hidden.
  void toggle_hidden();
  /// Of those that the world was built from.
  HiddenBodies hidden_bodies() const;
  void add_surface();
  void report_surface();
  /// What the projectile tool would fire at a place of the view, and what it aims at.
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
  /// Writes the recording or the plotted series, or asks for the picture of a bug report.
  void save_run(const ui::Command& command);
  void write_recorded_run(const std::filesystem::path& path);
  /// As CSV at once, as PNG of the next drawn frame.
  void write_plots(const std::filesystem::path& path);
  /// Throw InputError.
  void save_plots_picture(const std::filesystem::path& path, const render::Image& window);
  void save_report(const std::filesystem::path& path, const render::Image& window, const std::string& graphics);
  /// The past of the selected node.
  std::vector<ui::UtilizationSample> utilizations_of_node() const;
  ui::RunCurves plotted_curves() const;
  /// Begins to write the past of the present branch for other programs, as a video or as pictures of the view.
  void export_run(const std::filesystem::path& path);
  void go_on_with_export();
  /// The present branch. Throws InputError where files of its scene have changed since the world was built.
  Recording recorded_run() const;
  /// Where the scene stands on disk, absolute; empty when nowhere.
  std::filesystem::path own_file() const;
  /// Why the file is not to be written unasked; empty when it may.
  std::string what_saving_would_lose(const std::filesystem::path& file) const;
  /// Asks for the newest: of this scene or, at the start, of any.
  void ask_for_left_edits(bool of_any);
  /// Puts the scene's file on top of the recent ones.
  void remember_file();
  /// Has cards of scenes at hand while the browser is shown.
  void follow_browser();
  void list_macros();
  MacroMoment macro_moment() const;
  /// Lets the macro that is being recorded, if any, have what has changed.
  void note_for_macro();
  void toggle_macro_recording();
  void ask_where_to_save_macro(std::filesystem::path proposed);
  void write_macro(const std::filesystem::path& path);
  void discard_copy();
  void leave_copy();
  void recover();
  void show_recovered(Scene scene, const std::filesystem::path& file);
  /// Ends the program: what is not saved is not wanted.
  void quit();
  void select(const ui::Selection& selection);
  void select_most_loaded();
  void frame_all();
  /// Moves the camera along its line of sight and across until the picture shows all of the box.
  void look_at(const Eigen::AlignedBox3f& bounds);
  /// A scene without cameras was framed for a guess until the panels are laid out.
  void frame_for_layout();
  void toggle_range_lock();
  void toggle_slice();
  void add_scaling_label(const ui::Fonts& fonts, ui::EditorInput& input) const;
  const World& world() const { return timeline_.world(); }
  void carry_out_in_time(const ui::Command& command);
  /// Goes to a step that somebody named. Throws InputError where there is none.
  void go_to_recorded(int branch, std::int64_t step);
  /// Goes to a recorded step. The scene's materials become those that were in force.
  void go_to(int branch, std::int64_t step);
  /// Whether the step that was just made from `before` is one to stop before; then it is taken back.
  bool stop_before_step(World before);
  /// Makes steps of the past again, some seconds long at most, on the way to where the user wants to go.
  void go_on_with_travel(double seconds);
  std::string travel_stage() const;
  void arrive();
  /// Makes the materials that are in force those of the scene, without an entry in its history.
  void adopt_materials();
  /// "step 31", with its branch where there are several.
  std::string moment_text() const;
  /// Forgets the stop and the messages of the state that was shown.
  void leave_state();
  /// Begins to look for the strength, speed and thickness with which the node stands that is about to crack.
  void explain_holding();
  void go_on_with_holding();
  ui::TimeView time_view() const;
  /// Compares with the branch that this one came from, or the newest; or no longer.
  void toggle_comparison();
  /// Brings the compared branch to the step that is shown.
  void follow_comparison();
  std::optional<ui::ComparisonView> comparison_view() const;
  void remember();
  /// What a step in the background would begin with now.
  BackgroundStep::Start step_start() const { return {world_count_, timeline_.revision()}; }
  bool watches() const { return state_.breakpoints.any() && !passes_stop_; }
  /// Makes steps for `elapsed` [s] of real time.
  void make_due_steps(double elapsed);
  /// Starts all speed measurements again, after a pause or in another scene.
  void reset_pace();
  /// `is_last`: before the next picture, which is made with it.
  void begin_background_step(bool is_last);
  /// Ends the step in the background; whether it is made by then. It is forgotten if something else was done meanwhile.
  bool end_background_step(BackgroundStep::Clock::time_point deadline);
  void take_step(BackgroundStep::Made made);
  /// After a step. `before`: the world before it, where breakpoints are watched. `picture`: of the world, if any.
  void follow_step(std::optional<World> before, std::optional<StepPicture> picture);
  PictureSettings picture_settings() const;
  /// Takes over a picture of the world as it is; whether that shows what is wanted now.
  bool take_picture(StepPicture picture);
  /// Makes the picture of the world as it is, unless it is there.
  void update_picture();
  void move_slice(const ui::CameraMotion& motion);
  void move_camera();
  /// Moves the legend to where it covers nothing, once for each camera, size and view: not because of a step.
  void place_legend(ui::Legend& legend, const ui::Fonts& fonts);
  float aspect() const;
  /// The camera, opened so far that a narrow view shows as much across as a wide one.
  render::Camera picture_camera() const;

  /// What the picture is made from: an equal one need not be made again.
  struct ContentKey {
    std::int64_t world = -1, world_revision = -1, scene_revision = -1, arrivals = 0;
    ViewSettings view;
    ui::Selection selected;
    std::set<std::string> hidden;
    bool operator==(const ContentKey&) const = default;
  };
  ContentKey content_key() const;
  /// And how it is drawn: an equal one need not be drawn again.
  struct PictureKey {
    ContentKey content;
    int width = 0, height = 0;
    int compared = -1;  ///< branch; -1: none
    Eigen::Vector3f position = Eigen::Vector3f::Zero(), target = Eigen::Vector3f::Zero();
    bool operator==(const PictureKey&) const = default;
  };
  PictureKey picture_key() const;
  void draw_comparison(const PictureKey& key, std::optional<int> samples);

  ui::EditHistory history_;
  ui::EditorState state_;
  ui::WidgetTags tags_;
  std::filesystem::path path_;
  /// Of its file, before it was read or when it was written last; the earliest where edits were recovered.
  std::filesystem::file_time_type file_time_;
  std::filesystem::file_time_type opened_time_;  ///< of the file that is being opened, before it was read
  std::vector<std::filesystem::path> scene_files_;
  std::filesystem::file_time_type built_at_ = std::filesystem::file_time_type::clock::now();  ///< when that began
  Timeline timeline_;
  CopyOnWrite<EmbeddedDisplay> display_;  ///< of the world
  std::vector<InputError> warnings_;      ///< of the world, as scene_warnings() has them
  std::vector<InputError> outdated_;      ///< names in the scene's file
  std::vector<ui::SceneProblem> problems_;
  WorldLoader loader_;
  std::optional<Autosave> autosave_;
  RecentFiles recent_{""};
  ThumbnailSource thumbnail_source_;
  std::unique_ptr<SceneGallery> gallery_;               ///< while the browser is shown
  double copied_at_ = -ui::kAutosaveIntervals.maximum;  ///< when edits were copied last, by the clock of autosave()
  std::int64_t copied_revision_ = -1;                   ///< of the scene
  Scene built_;                      ///< what the world was built from, with the materials that it has now
  std::int64_t seen_revision_ = -1;  ///< of the scene, when it was last compared with that
  std::int64_t world_count_ = 0;     ///< worlds made so far
  render::Camera camera_;
  render::Renderer renderer_;
  render::DrawScene picture_;
  ContentKey made_of_;  ///< the picture
  SteadyRange range_;
  ui::LegendCorner legend_corner_ = {};
  PictureKey legend_placed_;  ///< for which picture it was
  PictureKey drawn_;
  RunHistory run_history_;
  std::unique_ptr<RunExport> export_;
  std::unique_ptr<HoldingSearch> holding_;
  std::unique_ptr<ComparedBranch> compared_;
  std::string difference_;  ///< of the compared branch
  UtilizationHistory history_of_utilizations_;
  std::vector<ui::UtilizationSample> utilizations_;  ///< of the selected node
  StepPacer pacer_;
  BackgroundStep background_;
  bool waits_for_steps_ = true;
  /// Steps of the past that are being made again, from the first to the last.
  std::optional<ui::StepSpan> travel_;
  std::int64_t arrivals_ = 0;             ///< how often another time was gone to
  bool passes_stop_ = false;              ///< the next step is made although a breakpoint is met in it
  double step_seconds_ = 0;               ///< smoothed
  RateMeter pictures_drawn_, time_made_;  ///< a second of real time; simulated time [s]
  double made_since_advance_ = 0;         ///< simulated, since advance() was called last [s]
  bool laid_out_ = false;                 ///< the size of the picture is known
  bool wants_to_quit_ = false, screenshot_wanted_ = false;
  std::optional<Script> wanted_script_;
  std::filesystem::path macro_folder_;
  std::vector<std::filesystem::path> macros_;  ///< in it, sorted
  std::optional<MacroRecorder> recorder_;      ///< while one is being recorded
  std::string recorded_macro_;                 ///< the last one
  std::optional<PictureRequest> wanted_picture_;
};

}  // namespace griffith::app
