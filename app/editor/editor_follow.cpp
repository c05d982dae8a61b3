#include <algorithm>
#include <utility>

#include "app/editor/editor.h"
#include "app/shared/scene_world.h"

namespace griffith::app {
namespace {

/// Returns the scene without its materials, which a running world follows.
Scene start_of(Scene scene) {
  scene.name.clear();
  scene.description.clear();
  scene.cameras.clear();
  scene.view = {};
  scene.materials.clear();
  scene.schema.clear();
  for (BodyDescription& body : scene.bodies) body.material = {};
  return scene;
}

}  // namespace

void Editor::follow() {
  loader_.start(LoadReason::follow, history_.scene(), path_, max_tets());
  loader_.wait(kBusyIndicatorDelay);
  receive_world();
}

void Editor::go_back_to_built() {
  history_.go_to([start = start_of(built_)](const Scene& scene) { return start_of(scene) == start; });
}

void Editor::take_followed(WorldLoader::Loaded loaded) {
  if (start_of(loaded.scene) != start_of(history_.scene())) return follow();  // edited since
  const bool edited = start_of(loaded.scene) != start_of(built_), was_empty = built_.bodies.empty();
  timeline_ = Timeline(std::move(loaded.world));
  built_at_ = loaded.started;
  warnings_ = std::move(loaded.warnings);
  display_ = CopyOnWrite(std::move(loaded.display));
  restart();
  if (edited) log_findings();
  if (was_empty) frame_all();
}

void Editor::log_findings() {
  for (const InputError& finding : world().findings()) log(ui::LogLevel::warning, finding.what());
  const auto choices = world().frame().element_choices;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (choices[i].automatic)
      log(ui::LogLevel::info,
          "Elements of the body \"" + history_.scene().bodies[i].name + "\": " + text_of(choices[i]));
}

void Editor::list_problems() {
  problems_.clear();
  for (const std::vector<InputError>* found : {&outdated_, &warnings_})
    for (const InputError& problem : *found)
      problems_.push_back({problem.where().substr(problem.where().find('#') + 1), problem.problem(), problem.remedy()});
}

void Editor::follow_edits() {
  if (history_.revision() == seen_revision_) return;
  // An edit in progress would make every step stale, and none would ever finish.
  if (history_.editing() && state_.running && background_.pending()) return;
  const std::int64_t revision = history_.revision();
  follow_materials();
  if (history_.editing()) return;
  seen_revision_ = revision;  // the result of undoing an edit is checked next
  // After an undo that removed a body, another one has its index.
  std::erase_if(state_.entries, [&](const ui::SceneEntry& entry) {
    return entry.kind == ui::EntryKind::body && !ui::has_entry(history_.scene(), entry);
  });
  state_.selected_body =
      std::clamp(state_.selected_body, 0, std::max(0, static_cast<int>(history_.scene().bodies.size()) - 1));
  if (start_of(history_.scene()) == start_of(built_)) return;
  follow();
}

void Editor::follow_materials() {
  const std::vector<BodyDescription>& bodies = history_.scene().bodies;
  const Frame frame = world().frame();
  if (!std::ranges::equal(bodies, built_.bodies, {}, &BodyDescription::name, &BodyDescription::name) ||
      frame.materials.size() != bodies.size())
    return;  // they come with the world being built
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (frame.materials[i] != bodies[i].material && !follow_material(static_cast<int>(i))) return;
    built_.bodies[i].material = bodies[i].material;
  }
}

bool Editor::follow_material(int scene_body) {
  try {
    timeline_.set_material(scene_body, history_.scene().bodies[scene_body].material);
    range_.restart();
    leave_state();
    return true;
  } catch (const InputError& error) {
    show_error(in_file(path_, error));
    const std::span<const Material> in_force = world().frame().materials;
    const bool found = history_.go_to(
        [&](const Scene& scene) { return std::ranges::equal(scene.bodies, in_force, {}, &BodyDescription::material); });
    if (!found) history_.undo();  // some bodies accepted the material before one refused it
    return false;
  }
}

}  // namespace griffith::app
