#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace griffith::ui {

/// An undoable edit: the scene before and after.
struct EditEntry {
  std::string label;
  Scene before, after;
};

/// The edited scene with its undo history. All edits go through change(). Edits with the same label, such as the steps
/// of a slider drag, make one entry, which finish() closes.
class EditHistory {
 public:
  explicit EditHistory(Scene scene) : scene_(std::move(scene)), saved_(scene_) {}

  const Scene& scene() const { return scene_; }

  /// Edits the scene. Opens an entry named `label` unless one of that name is open. Discards the edits that could be
  /// redone.
  void change(const std::string& label, const std::function<void(Scene&)>& edit);
  /// Takes over values that are in force in the simulation at another time, without an entry. No entry may be open.
  void adopt(const std::function<void(Scene&)>& change);
  /// Closes the open entry and drops it if it changed nothing.
  void finish();

  bool can_undo() const { return applied_ > 0 || open_; }
  bool can_redo() const { return !open_ && applied_ < entries_.size(); }
  /// Both finish an open entry first and do nothing at the end of the history.
  void undo();
  void redo();

  /// Undoes or redoes to the nearest scene that satisfies `accepted`; earlier scenes are tried first. Finishes an open
  /// entry first. False, with nothing else done, if there is none.
  bool go_to(const std::function<bool(const Scene&)>& accepted);

  /// Returns the entries, oldest first: those in force, then those that can be redone.
  const std::vector<EditEntry>& entries() const { return entries_; }

  /// True if an entry is open, that is, during a gesture.
  bool editing() const { return open_; }
  /// Counter that increases with each change of the scene.
  std::int64_t revision() const { return revision_; }

  bool modified() const { return has_later_edits_ || !(scene_ == saved_); }
  const Scene& saved() const { return saved_; }
  void mark_saved() { saved_ = Scene(scene_); }
  /// Sets whether the run has unsaved edits of later steps, which the scene at this step lacks.
  void set_later_edits(bool has_any) { has_later_edits_ = has_any; }
  bool has_later_edits() const { return has_later_edits_; }

 private:
  Scene scene_, saved_;
  std::vector<EditEntry> entries_;
  std::size_t applied_ = 0;
  std::int64_t revision_ = 0;
  bool open_ = false;             ///< the last applied entry still grows
  bool has_later_edits_ = false;  ///< see set_later_edits()
};

}  // namespace griffith::ui
