#include "ui/model/edit_history.h"

namespace griffith::ui {

// Scenes are copied, then moved: GCC 12 warns of uninitialized memory when their probes are assigned in place.

void EditHistory::change(const std::string& label, const std::function<void(Scene&)>& edit) {
  if (open_ && entries_.back().label != label) finish();
  if (!open_) {
    entries_.resize(applied_);
    entries_.push_back({label, scene_, scene_});
    applied_ = entries_.size();
    open_ = true;
  }
  edit(scene_);
  ++revision_;
}

void EditHistory::adopt(const std::function<void(Scene&)>& change) {
  change(scene_);
  ++revision_;
}

void EditHistory::finish() {
  if (!open_) return;
  open_ = false;
  EditEntry& entry = entries_.back();
  entry.after = Scene(scene_);
  if (entry.before == entry.after) {
    entries_.pop_back();
    applied_ = entries_.size();
  }
}

void EditHistory::undo() {
  finish();
  if (applied_ == 0) return;
  scene_ = Scene(entries_[--applied_].before);
  ++revision_;
}

void EditHistory::redo() {
  finish();
  if (applied_ == entries_.size()) return;
  scene_ = Scene(entries_[applied_++].after);
  ++revision_;
}

bool EditHistory::go_to(const std::function<bool(const Scene&)>& accepted) {
  finish();
  const std::size_t last = entries_.size();
  const auto found = [&](std::size_t place) {
    return place <= last && accepted(place == applied_  ? scene_
                                     : place < applied_ ? entries_[place].before
                                                        : entries_[place - 1].after);
  };
  std::size_t way = 0;
  while (way <= last && !found(applied_ - way) && !found(applied_ + way)) ++way;
  if (way > last) return false;
  const bool back = found(applied_ - way);
  for (; way > 0; --way) back ? undo() : redo();
  return true;
}

}  // namespace griffith::ui
