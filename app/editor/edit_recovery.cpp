#include "app/editor/edit_recovery.h"

#include "app/editor/messages.h"

namespace griffith::app {

void EditRecovery::enable(const std::filesystem::path& states) {
  autosave_.emplace(states);
  offer(true);
}

void EditRecovery::copy(double now) {
  if (!autosave_) return;
  const ui::EditHistory& history = document_.history();
  if (!history.modified()) return autosave_->remove();
  const bool due = now - copied_at_ >= state_.preferences.autosave_interval && history.revision() != copied_revision_;
  if (!due || history.editing()) return;
  copied_at_ = now;
  try {
    Scene scene = history.scene();
    scene.view = state_.view;
    autosave_->write(scene, document_.absolute_path());
    copied_revision_ = history.revision();
  } catch (const InputError& error) {
    log_message(state_, ui::LogLevel::warning, error.what());
  }
}

void EditRecovery::remove_copy() {
  copied_revision_ = -1;
  if (autosave_) autosave_->remove();
}

void EditRecovery::offer(bool of_any) {
  if (!autosave_) return;
  const std::filesystem::path file = document_.absolute_path();
  const bool found = of_any ? autosave_->find_any(file) : autosave_->find(file);
  state_.recoverable_edits = found ? autosave_->found_text() : "";
}

std::optional<UnsavedEdits> EditRecovery::take_offered() {
  state_.recoverable_edits.clear();
  if (!autosave_ || !autosave_->has_found()) return std::nullopt;
  return autosave_->found_edits();
}

void EditRecovery::adopt_offered() {
  copied_revision_ = -1;
  autosave_->adopt_found();
}

void EditRecovery::discard_offered() {
  if (autosave_) autosave_->remove_found();
  offer(true);
}

void EditRecovery::leave_offered() {
  state_.recoverable_edits.clear();
  if (autosave_) autosave_->leave_found();
}

}  // namespace griffith::app
