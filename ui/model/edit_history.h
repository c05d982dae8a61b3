#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace griffith::ui {

/// One undoable edit: the scene as it was and as it became.
struct EditEntry {
  std::string label;
  Scene before, after;
};

/// The scene being edited, and the way back. All edits go through change(): those with one label, such as the many
/// steps of a slider drag, make one entry, closed by finish().
class EditHistory {
 public:
  explicit EditHistory(Scene scene) : scene_(std::move(scene)), saved_(scene_) {}

  const Scene& scene() const { return scene_; }

  /// Edits the scene. Opens an entry named `label` unless one of that name is open; drops what could be redone.
  void change(const std::string& label, const std::function<void(Scene&)>& edit);
  /// Follows what is in force in the simulation at another time: no edit, so no entry. None may be open.
  void adopt(const std::function<void(Scene&)>& change);
  /// Closes the open entry; one that ended where it began is dropped.
  void finish();

  bool can_undo() const { return applied_ > 0 || open_; }
  bool can_redo() const { return !open_ && applied_ < entries_.size(); }
  /// Both finish an open entry first and do nothing at the end of the history.
  void undo();
  void redo();

  /// Undoes or redoes as much as it takes to find a scene that is `wanted`, the nearest one; earlier ones come first.
  /// Finishes an open entry first. False, with nothing else done, when there is none.
  bool go_to(const std::function<bool(const Scene&)>& wanted);

  /// Oldest first; those in force, then those that can be redone.
  const std::vector<EditEntry>& entries() const { return entries_; }

  /// Whether an entry is open: a gesture is going on.
  bool editing() const { return open_; }
  /// Another one after each change of the scene.
  std::int64_t revision() const { return revision_; }

  bool modified() const { return !(scene_ == saved_); }
  void mark_saved() { saved_ = Scene(scene_); }

 private:
  Scene scene_, saved_;
  std::vector<EditEntry> entries_;
  std::size_t applied_ = 0;
  std::int64_t revision_ = 0;
  bool open_ = false;  ///< the last applied entry still grows
};

}  // namespace griffith::ui
