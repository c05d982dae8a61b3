#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "app/editor/edit_recovery.h"
#include "app/editor/known_scenes.h"
#include "app/editor/run_controller.h"

namespace griffith::app {

/// Builds the world of an edited, opened or extended scene, and shows it. If that takes long, a dialog that can cancel
/// it is shown until receive() takes the world. A problem is shown and changes nothing.
class WorldBuilder {
 public:
  WorldBuilder(ui::EditorState& state, SceneDocument& document, KnownScenes& scenes, EditRecovery& recovery,
               Viewport& viewport, RunController& run)
      : state_(state), document_(document), scenes_(scenes), recovery_(recovery), viewport_(viewport), run_(run) {}

  /// Opens a scene without asking about unsaved edits.
  void open(const std::filesystem::path& path);
  /// Opens an empty scene.
  void open_empty();
  /// Opens a scene that has no file yet.
  void open_without_file(const Scene& scene);
  /// Opens the offered edits of a crashed run.
  void recover();
  /// Adds a body filled from the surface file given in its dialog. Throws InputError if none is given.
  void add_surface();
  /// Rebuilds the world from the edited scene.
  void rebuild();
  /// Rebuilds it if that differs from the scene of the world; new materials act at once. True if another world is shown
  /// already.
  bool follow_edits();

  /// Takes the world that was built meanwhile, and what the user decided about it. True if another world is shown.
  bool receive();
  /// Describes the progress; empty if nothing is being built.
  std::string stage() const { return loader_.stage(); }

 private:
  void start(LoadReason reason, Scene scene, std::filesystem::path path);
  bool wait();
  /// Takes the world if it is ready. True if there was one.
  bool take();
  /// Ends work that led to no world; the shown one stays.
  void end_work();
  void fail(const InputError& error);
  void show(WorldLoader::Loaded loaded);
  void show_opened(WorldLoader::Loaded loaded);
  void show_followed(WorldLoader::Loaded loaded);
  void show_recovered(WorldLoader::Loaded loaded);
  void show_extended(WorldLoader::Loaded loaded);
  /// Brings the bodies that were added into view; all of a scene that was empty.
  void show_added(bool was_empty);
  /// Replaces scene and world. `scene`: in the file; `edited`: unsaved version of it.
  void show_scene(Scene scene, const Scene* edited, std::filesystem::path path, SceneDocument::FileTime file_time,
                  BuiltWorld built);
  void log_findings();
  /// Returns the number of tetrahedra that are built without confirmation: a small number, or slightly more than there
  /// are.
  double max_tets() const;

  ui::EditorState& state_;
  SceneDocument& document_;
  KnownScenes& scenes_;
  EditRecovery& recovery_;
  Viewport& viewport_;
  RunController& run_;
  WorldLoader loader_;
  SceneDocument::FileTime opened_time_;  ///< time of the file being opened, before it was read
  std::int64_t seen_revision_ = -1;      ///< last revision of the scene that was compared with that of the world
};

/// Prepares the editor for a scene: its view and projectile, nothing selected.
void begin_scene(ui::EditorState& state, const Scene& scene);
/// Logs that the scene was opened.
void log_opened(ui::EditorState& state, const Scene& scene);

}  // namespace griffith::app
