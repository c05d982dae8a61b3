#include "ui/edit_history.h"

namespace griffith::ui {

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

void EditHistory::finish() {
  if (!open_) return;
  open_ = false;
  EditEntry& entry = entries_.back();
  entry.after = scene_;
  if (entry.before == entry.after) {
    entries_.pop_back();
    applied_ = entries_.size();
  }
}

void EditHistory::undo() {
  finish();
  if (applied_ == 0) return;
  scene_ = entries_[--applied_].before;
  ++revision_;
}

void EditHistory::redo() {
  finish();
  if (applied_ == entries_.size()) return;
  scene_ = entries_[applied_++].after;
  ++revision_;
}

}  // namespace griffith::ui
