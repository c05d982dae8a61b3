#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "app/editor/edit_recovery.h"
#include "app/editor/known_scenes.h"
#include "app/editor/run_analysis.h"
#include "app/editor/run_controller.h"
#include "app/editor/run_files.h"
#include "app/editor/scene_document.h"
#include "app/editor/scripting.h"
#include "app/editor/viewport.h"
#include "app/editor/world_builder.h"
#include "ui/panels/editor_layout.h"

namespace griffith::app {

/// Requests to the owner of the window, who resets them.
struct WindowRequests {
  bool quit = false, screenshot = false;
};

/// The editor without its window: its parts, each of which knows those before it, and the panels. Needs a current
/// OpenGL context; each drawn frame is advance(), draw_picture(), draw_panels().
class Editor {
 public:
  /// `edited`: unsaved version of the scene, if there is one. Throws InputError if the world cannot be built.
  Editor(Scene scene, std::filesystem::path path, const Scene* edited = nullptr);

  /// Draws the scene in the size that the panels left for it, if it has changed. `samples`: per pixel; those of the
  /// quality if absent.
  void draw_picture(std::optional<int> samples);
  /// Draws the panels into the current ImGui frame and executes the user's commands.
  void draw_panels(const ui::Fonts& fonts);
  /// Returns the seconds until something must be drawn without an external event; infinite if nothing moves. Needs the
  /// context of ImGui.
  double seconds_to_next_frame() const;

  /// Executes a command and shows problems. Asks first if unsaved edits would be lost.
  void execute(const ui::Command& command);
  /// Returns the reason why the command is disabled; empty if it is enabled.
  std::string_view disabled_reason(std::string_view command) const;

  /// Enables the list of recent scenes, copies of unsaved edits, and the recovery of edits of a crashed run. `states`:
  /// as for Autosave.
  void enable_autosave(const std::filesystem::path& states);

  ui::EditorState& state() { return state_; }
  const ui::EditorState& state() const { return state_; }
  const ui::WidgetTags& tags() const { return tags_; }
  SceneDocument& document() { return document_; }
  const SceneDocument& document() const { return document_; }
  KnownScenes& scenes() { return scenes_; }
  EditRecovery& recovery() { return recovery_; }
  Viewport& viewport() { return viewport_; }
  RunController& run() { return run_; }
  const RunController& run() const { return run_; }
  WorldBuilder& builder() { return builder_; }
  RunAnalysis& analysis() { return analysis_; }
  RunFiles& files() { return files_; }
  Scripting& scripting() { return scripting_; }
  WindowRequests& requests() { return requests_; }

 private:
  /// Continues work of more than one drawn frame, as the user decides.
  void go_on_with_work();
  ui::EditorInput panel_input(const ui::Fonts& fonts);
  /// Reports why a command is disabled.
  void refuse(const ui::CommandInfo& info, std::string_view reason);

  ui::EditorState state_;
  ui::WidgetTags tags_;
  SceneDocument document_;
  KnownScenes scenes_{state_};
  EditRecovery recovery_{state_, document_};
  Viewport viewport_{state_};
  RunController run_;
  WorldBuilder builder_{state_, document_, scenes_, recovery_, viewport_, run_};
  RunAnalysis analysis_{state_, run_, viewport_};
  RunFiles files_{state_, document_, run_, viewport_, analysis_};
  Scripting scripting_{state_, document_, viewport_, run_};
  WindowRequests requests_;
};

}  // namespace griffith::app
