#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "app/editor/autosave.h"
#include "app/editor/scene_document.h"
#include "ui/model/editor_state.h"

namespace griffith::app {

/// Copies unsaved edits as often as the preferences say, and offers those of a crashed run. Does nothing until it is
/// enabled.
class EditRecovery {
 public:
  EditRecovery(ui::EditorState& state, const SceneDocument& document) : state_(state), document_(document) {}

  /// `states`: as for Autosave.
  void enable(const std::filesystem::path& states);
  /// Copies the edits if that is due; call it often. `now`: seconds of a steady clock.
  void copy(double now);
  /// Removes the copy after the edits were saved or discarded.
  void remove_copy();

  /// Offers the newest recoverable edits of the scene's file, or of any.
  void offer(bool of_any);
  /// Returns the offered edits, if there are any. Throws InputError if they cannot be read.
  std::optional<UnsavedEdits> take_offered();
  /// Makes the copy with the taken edits this program's own.
  void adopt_offered();
  /// Deletes the offered copy and offers the next.
  void discard_offered();
  /// Leaves the offered copy for the next start.
  void leave_offered();

 private:
  ui::EditorState& state_;
  const SceneDocument& document_;
  std::optional<Autosave> autosave_;
  double copied_at_ = -ui::kAutosaveIntervals.maximum;  ///< time of the last copy, by the clock of copy()
  std::int64_t copied_revision_ = -1;                   ///< revision of the scene in that copy
};

}  // namespace griffith::app
