#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editor/macro_recorder.h"
#include "app/editor/run_controller.h"
#include "app/editor/script.h"

namespace griffith::app {

/// Returns the user's folder for macros; empty if there is none.
std::filesystem::path macro_folder();

/// Macros of the user, the one being recorded, and the script to be played next.
class Scripting {
 public:
  Scripting(ui::EditorState& state, const SceneDocument& document, const Viewport& viewport, const RunController& run)
      : state_(state), document_(document), viewport_(viewport), run_(run) {}

  /// Sets the folder of macros, which also receives new ones.
  void use_macros(std::filesystem::path folder);
  /// Returns the macros in that folder, sorted.
  const std::vector<std::filesystem::path>& macros() const { return macros_; }

  /// Begins or ends to record a macro; at the end its dialog is opened.
  void toggle_recording();
  /// Records changes since the last call, if a macro is being recorded.
  void note();
  /// Marks the current state as made by the editor.
  void skip();
  /// Records a command that was carried out.
  void add(const ui::Command& command);
  /// Opens the dialog that asks for the macro's file. `proposed`: empty for the first free name.
  void ask_where_to_save(std::filesystem::path proposed);
  /// Writes the last macro to the command's file. Throws InputError.
  void save(const ui::Command& command);

  /// Requests that a script be played.
  void play(Script script) { requested_ = std::move(script); }
  /// Returns the requested script, once.
  std::optional<Script> take_request() { return std::exchange(requested_, std::nullopt); }

 private:
  /// True if there is a macro to save; says so in the log if not.
  bool has_macro();

  void list();
  MacroMoment moment() const;

  ui::EditorState& state_;
  const SceneDocument& document_;
  const Viewport& viewport_;
  const RunController& run_;
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> macros_;
  std::optional<MacroRecorder> recorder_;  ///< while one is being recorded
  std::string recorded_;                   ///< text of the last macro
  std::optional<Script> requested_;
};

// Actions of scripts besides commands. All throw InputError, which names `where`.

/// Sets fields of the scene, as it would be saved.
void set_values(ui::EditHistory& history, ui::EditorState& state, std::span<const SceneSetting> settings,
                const std::string& where);
/// Sets fields of the projectile tool.
void set_shot(ui::EditorState& state, std::span<const SceneSetting> settings, const std::string& where);
/// Selects entries by full name.
void choose(ui::EditorState& state, const Scene& scene, const std::vector<std::string>& names,
            const std::string& where);

}  // namespace griffith::app
