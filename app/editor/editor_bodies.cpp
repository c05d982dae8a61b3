#include <utility>

#include "app/editor/editor.h"
#include "app/editor/new_body.h"
#include "app/shared/scene_world.h"

namespace griffith::app {
using ui::CommandId;

void Editor::carry_out_on_bodies(const ui::Command& command) {
  state_.running = false;
  const Scene& scene = history_.scene();
  if (command.id == CommandId::delete_body) return delete_body();
  if (command.id != CommandId::duplicate_body)
    return add_body("Add " + std::string(ui::command_info(command.id).label), new_body(command.id, scene, frame()));
  if (!scene.bodies.empty()) add_body("Duplicate body", copy_of_body(scene, state_.selected_body, frame()));
}

void Editor::new_scene() {
  Scene scene;
  if (autosave_) autosave_->remove();
  timeline_ = Timeline(make_world(scene, ""));
  display_ = embedded_display(world().frame(), scene);
  file_time_ = {};
  show_scene(std::move(scene), "");
}

void Editor::add_body(const std::string& label, BodyDescription body) {
  history_.change(label, [&](Scene& scene) { scene.bodies.push_back(std::move(body)); });
  history_.finish();
  state_.selection = {};
  state_.selected_body = static_cast<int>(history_.scene().bodies.size()) - 1;
}

void Editor::delete_body() {
  if (history_.scene().bodies.empty()) return;
  history_.change("Delete body", [&](Scene& scene) { remove_body(scene, state_.selected_body); });
  history_.finish();
  state_.selection = {};
}

void Editor::keep_shot() {
  if (!state_.last_shot) return;
  state_.running = false;
  history_.change("Add shot", [&](Scene& scene) { scene.projectiles.push_back(*state_.last_shot); });
  history_.finish();
  state_.last_shot.reset();
}

}  // namespace griffith::app
