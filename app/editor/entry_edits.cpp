#include "app/editor/entry_edits.h"

#include <algorithm>
#include <functional>

#include "app/editor/new_entry.h"
#include "app/editor/shooting.h"
#include "app/picture/scene_camera.h"
#include "ui/model/entry_choice.h"

namespace griffith::app {
using ui::EntryKind;
using ui::SceneEntry;

namespace {

int last_of(const auto& list) { return static_cast<int>(list.size()) - 1; }

/// Makes an edit as one entry of the history. `edit` returns the entry that it adds, which is selected.
void add_entry(ui::EditHistory& history, ui::EditorState& state, const std::string& label,
               const std::function<SceneEntry(Scene&)>& edit) {
  SceneEntry added;
  history.change(label, [&](Scene& scene) { added = edit(scene); });
  history.finish();
  ui::select_entries(state, history.scene(), {added});
}

/// The same for an entry of the selected body. `edit` gets the body's place in its rest space too [m].
void add_to_body(ui::EditHistory& history, ui::EditorState& state, const Frame& frame, const Scene& built,
                 const std::string& label,
                 const std::function<SceneEntry(Scene&, BodyDescription&, const Eigen::AlignedBox3d&)>& edit) {
  state.running = false;
  if (history.scene().bodies.empty()) return;
  const Eigen::AlignedBox3d box = rest_box(history.scene(), state.selected_body, frame, built);
  add_entry(history, state, label, [&](Scene& scene) {
    return edit(scene, scene.bodies[static_cast<std::size_t>(state.selected_body)], box);
  });
}

/// Lists a material of its own name among the scene's, as in a scene that was read.
void offer_material(const Material& material, Scene& scene) {
  const auto has_name = [&](const MaterialPreset& preset) { return preset.material.name == material.name; };
  const bool is_known = std::ranges::any_of(material_presets(), has_name) ||
                        std::ranges::find(scene.materials, material.name, &Material::name) != scene.materials.end();
  if (!is_known) scene.materials.push_back(material);
}

}  // namespace

void add_bodies(ui::EditHistory& history, ui::EditorState& state, const std::string& label,
                std::vector<BodyDescription> bodies) {
  state.running = false;
  std::vector<SceneEntry> added;
  history.change(label, [&](Scene& scene) {
    for (BodyDescription& body : bodies) {
      offer_material(body.material, scene);
      state.added_bodies.push_back(body.name);
      scene.bodies.push_back(std::move(body));
      added.push_back({EntryKind::body, last_of(scene.bodies)});
    }
  });
  history.finish();
  ui::select_entries(state, history.scene(), std::move(added));
}

void add_support(ui::EditHistory& history, ui::EditorState& state, const Frame& frame, const Scene& built) {
  add_to_body(history, state, frame, built, "Add Support", [&](Scene&, BodyDescription& body, const auto& box) {
    body.supports.push_back(new_support(body, box));
    return SceneEntry{EntryKind::support, last_of(body.supports), state.selected_body};
  });
}

void add_load(ui::EditHistory& history, ui::EditorState& state, const Frame& frame, const Scene& built) {
  add_to_body(history, state, frame, built, "Add Load", [&](Scene&, BodyDescription& body, const auto& box) {
    body.loads.push_back(new_load(body, box));
    return SceneEntry{EntryKind::load, last_of(body.loads), state.selected_body};
  });
}

void add_probe(ui::EditHistory& history, ui::EditorState& state, const Frame& frame, const Scene& built) {
  add_to_body(history, state, frame, built, "Add Probe", [&](Scene& scene, BodyDescription& body, const auto& box) {
    scene.probes.push_back(new_probe(scene, body, box));
    return SceneEntry{EntryKind::probe, last_of(scene.probes)};
  });
}

void add_projectile(ui::EditHistory& history, ui::EditorState& state, const render::Camera& camera) {
  state.running = false;
  add_entry(history, state, "Add Projectile", [&](Scene& scene) {
    scene.projectiles.push_back(
        aimed_shot(state.shot, camera.position.cast<double>(), camera.target.cast<double>(), scene.gravity));
    return SceneEntry{EntryKind::projectile, last_of(scene.projectiles)};
  });
}

void keep_shot(ui::EditHistory& history, ui::EditorState& state) {
  if (!state.last_shot) return;
  state.running = false;
  history.change("Add shot", [&](Scene& scene) { scene.projectiles.push_back(*state.last_shot); });
  history.finish();
  state.last_shot.reset();
}

void add_camera(ui::EditHistory& history, ui::EditorState& state, const render::Camera& camera) {
  Camera added = described(camera);
  added.name = ui::free_name(history.scene().cameras, "view");
  add_entry(history, state, "Add camera " + added.name, [&](Scene& scene) {
    scene.cameras.push_back(added);
    return SceneEntry{EntryKind::camera, last_of(scene.cameras)};
  });
}

void set_camera(ui::EditHistory& history, const ui::EditorState& state, const render::Camera& camera) {
  const std::optional<SceneEntry> entry = ui::active_entry(state, history.scene());
  if (!entry || entry->kind != EntryKind::camera) return;
  Camera changed = described(camera);
  changed.name = ui::entry_name(history.scene(), *entry);
  history.change("Set camera " + changed.name + " to view",
                 [&](Scene& scene) { scene.cameras[static_cast<std::size_t>(entry->index)] = changed; });
  history.finish();
}

void duplicate_entries(ui::EditHistory& history, ui::EditorState& state, const Frame& frame) {
  state.running = false;
  std::vector<SceneEntry> copies;
  history.change("Duplicate", [&](Scene& scene) {
    for (const SceneEntry& entry : ui::selected_entries(state, scene)) {
      if (entry.kind == EntryKind::body) {
        scene.bodies.push_back(copy_of_body(scene, entry.index, frame));
        state.added_bodies.push_back(scene.bodies.back().name);
        copies.push_back({EntryKind::body, last_of(scene.bodies)});
      } else {
        copies.push_back(ui::append_copy(scene, entry));
      }
    }
  });
  history.finish();
  ui::select_entries(state, history.scene(), std::move(copies));
}

void remove_entries(ui::EditHistory& history, ui::EditorState& state) {
  state.running = false;
  const std::vector<SceneEntry> chosen = ui::selected_entries(state, history.scene());
  if (chosen.empty()) return;
  history.change("Delete", [&](Scene& scene) { ui::remove_entries(scene, chosen); });
  history.finish();
  // The next entry of the kind is selected; if none is left, nothing, so that Delete never continues with another kind.
  SceneEntry next = *std::ranges::min_element(chosen);
  next.kind = chosen.back().kind;
  while (next.index > 0 && !ui::has_entry(history.scene(), next)) --next.index;
  state.entries = {next};
  if (next.kind == EntryKind::body) state.selected_body = next.index;
  state.selection = {};
}

void move_entries(ui::EditHistory& history, ui::EditorState& state, int way) {
  state.running = false;
  std::vector<SceneEntry> moved;
  history.change(way < 0 ? "Move up" : "Move down",
                 [&](Scene& scene) { moved = ui::move_entries(scene, ui::selected_entries(state, scene), way); });
  history.finish();
  ui::select_entries(state, history.scene(), std::move(moved));
}

void begin_renaming(ui::EditorState& state, const Scene& scene) {
  const std::optional<SceneEntry> entry = ui::active_entry(state, scene);
  if (!entry || !ui::has_name(entry->kind)) return;
  state.list_pieces = false;
  state.body_filter = {};
  state.listed_entry.reset();  // scrolls to it
  state.renamed = entry;
  state.new_name = ui::entry_name(scene, *entry);
}

void toggle_hidden(ui::EditorState& state, const Scene& scene) {
  const std::vector<std::string> bodies = ui::selected_bodies(state, scene);
  const auto hidden = [&](const std::string& name) { return state.hidden_bodies.contains(name); };
  const bool show = std::ranges::all_of(bodies, hidden);
  for (const std::string& name : bodies)
    show ? void(state.hidden_bodies.erase(name)) : void(state.hidden_bodies.insert(name));
}

}  // namespace griffith::app
