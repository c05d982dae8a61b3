#include "app/editor/world_builder.h"

#include <algorithm>
#include <new>
#include <stdexcept>
#include <utility>

#include "app/editor/frame_schedule.h"
#include "app/editor/messages.h"
#include "app/editor/starting_scene.h"
#include "app/editor/surface_body.h"
#include "app/shared/scene_files.h"
#include "sim/scene/scene_reader.h"
#include "ui/model/entry_choice.h"

namespace griffith::app {

namespace fs = std::filesystem;

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

ProjectileBurst first_shot(const Scene& scene) {
  ProjectileBurst shot = scene.projectiles.empty() ? ProjectileBurst{} : scene.projectiles.front();
  shot.count = 1;
  return shot;
}

}  // namespace

void begin_scene(ui::EditorState& state, const Scene& scene) {
  state.running = false;
  state.view = scene.view;
  state.shot = first_shot(scene);
  state.selected_body = 0;
  state.entries.clear();
  state.hidden_bodies.clear();
  state.renamed.reset();
  state.selection = {};
  state.last_shot.reset();
}

void log_opened(ui::EditorState& state, const Scene& scene) {
  const std::string text = scene.bodies.empty()
                               ? "The scene is empty. The menu Add has walls, tables, panes and shapes."
                               : "Opened \"" + scene.name + "\". Press Space to run, right-click to fire.";
  log_message(state, ui::LogLevel::info, text, ui::LogSpan::advice);
}

void WorldBuilder::open(const fs::path& path) {
  try {
    opened_time_ = time_of_file(path);
    start(LoadReason::open, read_scene(path), path);
    wait();
  } catch (const InputError& error) {
    show_error(state_, error);
  }
}

void WorldBuilder::open_empty() {
  Scene empty;
  empty.view.quantity = "material";
  empty.view.edges = false;
  open_without_file(empty);
}

void WorldBuilder::open_without_file(const Scene& scene) {
  recovery_.remove_copy();
  show_scene(scene, nullptr, "", {}, build_world(scene, ""));
}

void WorldBuilder::recover() {
  std::optional<UnsavedEdits> edits = recovery_.take_offered();
  if (!edits) return;
  start(LoadReason::recover, std::move(edits->scene), std::move(edits->file));
  wait();
}

void WorldBuilder::add_surface() {
  state_.running = false;
  loader_.start(LoadReason::add_body, scene_with_surface(state_.surface, document_.scene(), run_.frame()),
                document_.path(), max_tets());
}

void WorldBuilder::rebuild() {
  start(LoadReason::follow, document_.scene(), document_.path());
  wait();
}

bool WorldBuilder::follow_edits() {
  const ui::EditHistory& history = document_.history();
  if (history.revision() == seen_revision_) return false;
  // It must not replace the world of another scene.
  if (!loader_.stage().empty() && loader_.reason() != LoadReason::follow) return false;
  // An edit in progress would make every step stale, and none would ever finish.
  if (history.editing() && state_.running && run_.steps_in_background()) return false;
  const std::int64_t revision = history.revision();
  run_.follow_materials();
  if (history.editing()) return false;
  seen_revision_ = revision;  // the result of undoing an edit is checked next
  // After an undo that removed a body, another one has its index.
  std::erase_if(state_.entries, [&](const ui::SceneEntry& entry) {
    return entry.kind == ui::EntryKind::body && !ui::has_entry(document_.scene(), entry);
  });
  state_.selected_body =
      std::clamp(state_.selected_body, 0, std::max(0, static_cast<int>(document_.scene().bodies.size()) - 1));
  if (start_of(document_.scene()) == start_of(run_.built())) return false;
  start(LoadReason::follow, document_.scene(), document_.path());
  return wait();
}

void WorldBuilder::start(LoadReason reason, Scene scene, fs::path path) {
  loader_.start(reason, std::move(scene), std::move(path), max_tets());
}

bool WorldBuilder::wait() {
  loader_.wait(kBusyIndicatorDelay);
  const bool taken = take();
  state_.work = loader_.stage();
  return taken;
}

bool WorldBuilder::receive() {
  if (state_.cancel_work) {
    loader_.cancel();
    end_work();
  }
  if (state_.build_large_mesh) loader_.start_again();
  state_.cancel_work = state_.build_large_mesh = false;
  return take();
}

bool WorldBuilder::take() {
  try {
    std::optional<WorldLoader::Loaded> loaded = loader_.take();
    if (loaded) show(std::move(*loaded));
    return loaded.has_value();
  } catch (const InputError& error) {
    fail(error);
  } catch (const LargeMesh& mesh) {
    state_.large_mesh = mesh.tets;
  } catch (const std::bad_alloc&) {
    fail(InputError("the scene", "cannot be built: out of memory", "use larger elements or fewer bodies"));
  } catch (const std::runtime_error& error) {
    fail(InputError("the scene", std::string("cannot be built: ") + error.what(), ""));
  }
  return false;
}

void WorldBuilder::fail(const InputError& error) {
  end_work();
  show_error(state_, error);
}

void WorldBuilder::end_work() {
  state_.added_bodies.clear();
  if (loader_.reason() != LoadReason::follow) {
    seen_revision_ = -1;  // it may have replaced a world that was to follow an edit
    return;
  }
  // Undoes or redoes the edits for which the world could not be built.
  document_.history().go_to([start = start_of(run_.built())](const Scene& scene) { return start_of(scene) == start; });
}

void WorldBuilder::show(WorldLoader::Loaded loaded) {
  switch (loaded.reason) {
    case LoadReason::follow:
      return show_followed(std::move(loaded));
    case LoadReason::recover:
      return show_recovered(std::move(loaded));
    case LoadReason::add_body:
      return show_extended(std::move(loaded));
    case LoadReason::open:
      return show_opened(std::move(loaded));
  }
}

void WorldBuilder::show_opened(WorldLoader::Loaded loaded) {
  recovery_.remove_copy();
  const Scene scene = loaded.scene;
  show_scene(scene, nullptr, loaded.path, opened_time_, std::move(loaded));
  scenes_.remember(document_.absolute_path());
  recovery_.offer(false);
}

void WorldBuilder::show_followed(WorldLoader::Loaded loaded) {
  if (start_of(loaded.scene) != start_of(document_.scene())) return rebuild();  // edited since
  const Scene before = run_.built();
  seen_revision_ = -1;
  run_.restart(std::move(loaded));
  if (start_of(run_.built()) != start_of(before)) log_findings();
  show_added(before.bodies.empty());
}

void WorldBuilder::show_added(bool was_empty) {
  const std::vector<std::string> added = std::exchange(state_.added_bodies, {});
  if (was_empty) return viewport_.frame_all(run_.shown());
  viewport_.reveal(run_.shown(), added);
}

void WorldBuilder::show_recovered(WorldLoader::Loaded loaded) {
  Scene saved = starting_scene();
  try {
    if (!loaded.path.empty()) saved = read_scene(loaded.path);
  } catch (const InputError& error) {
    log_message(state_, ui::LogLevel::warning, error.what());
  }
  recovery_.adopt_offered();
  const Scene edited = loaded.scene;
  show_scene(std::move(saved), &edited, loaded.path, SceneDocument::FileTime::min(), std::move(loaded));
  log_message(state_, ui::LogLevel::info, "Recovered unsaved edits. Ctrl+S saves them.");
}

void WorldBuilder::show_extended(WorldLoader::Loaded loaded) {
  const bool was_empty = run_.built().bodies.empty();
  const int added = static_cast<int>(loaded.scene.bodies.size()) - 1;
  document_.history().change("Add body", [&](Scene& scene) { scene.bodies = loaded.scene.bodies; });
  document_.history().finish();
  ui::select_entries(state_, document_.scene(), {{ui::EntryKind::body, added}});
  seen_revision_ = -1;
  run_.restart(std::move(loaded));
  state_.report = surface_report(run_.world(), document_.scene(), added);
  log_message(state_, ui::LogLevel::info, state_.report->title + ": " + state_.report->facts.front());
  for (const std::string& warning : state_.report->warnings) log_message(state_, ui::LogLevel::warning, warning);
  state_.added_bodies.push_back(document_.scene().bodies.back().name);
  show_added(was_empty);
}

void WorldBuilder::show_scene(Scene scene, const Scene* edited, fs::path path, SceneDocument::FileTime file_time,
                              BuiltWorld built) {
  begin_scene(state_, edited ? *edited : scene);
  state_.added_bodies.clear();
  document_.show(std::move(scene), std::move(path), edited, file_time);
  scenes_.list(document_.path());
  seen_revision_ = -1;
  run_.restart(std::move(built));
  viewport_.use_camera(document_.scene(), "");
  log_opened(state_, document_.scene());
}

void WorldBuilder::log_findings() {
  for (const InputError& finding : run_.world().findings()) log_message(state_, ui::LogLevel::warning, finding.what());
  const auto choices = run_.frame().element_choices;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (choices[i].automatic)
      log_message(state_, ui::LogLevel::info,
                  "Elements of the body \"" + document_.scene().bodies[i].name + "\": " + text_of(choices[i]));
}

double WorldBuilder::max_tets() const {
  constexpr double kMany = 4e5;
  return std::max(kMany, 2.0 * static_cast<double>(run_.frame().elements.tets.size()));
}

}  // namespace griffith::app
