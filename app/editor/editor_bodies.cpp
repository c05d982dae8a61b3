#include <utility>

#include "app/editor/editor.h"
#include "app/editor/new_body.h"
#include "app/shared/scene_world.h"
#include "ui/model/entry_choice.h"

namespace griffith::app {
void Editor::add_new_body(const ui::Command& command) {
  state_.running = false;
  add_body("Add " + std::string(ui::command_info(command.id).label), new_body(command.id, history_.scene(), frame()));
}

void Editor::new_scene() {
  Scene scene;
  if (autosave_) autosave_->remove();
  timeline_ = Timeline(make_world(scene, ""));
  display_ = CopyOnWrite(embedded_display(world().frame(), scene));
  file_time_ = {};
  show_scene(std::move(scene), "");
}

void Editor::add_body(const std::string& label, BodyDescription body) {
  history_.change(label, [&](Scene& scene) { scene.bodies.push_back(std::move(body)); });
  history_.finish();
  ui::select_entries(state_, history_.scene(),
                     {{ui::EntryKind::body, static_cast<int>(history_.scene().bodies.size()) - 1}});
}

void Editor::keep_shot() {
  if (!state_.last_shot) return;
  state_.running = false;
  history_.change("Add shot", [&](Scene& scene) { scene.projectiles.push_back(*state_.last_shot); });
  history_.finish();
  state_.last_shot.reset();
}

}  // namespace griffith::app
