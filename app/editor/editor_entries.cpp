#include <algorithm>
#include <cstdio>

#include "app/editor/editor.h"
#include "app/editor/new_body.h"
#include "app/editor/new_entry.h"
#include "app/editor/shooting.h"
#include "app/picture/scene_camera.h"
#include "ui/model/entry_choice.h"

namespace griffith::app {
using ui::CommandId;
using ui::EntryKind;
using ui::SceneEntry;

/// Adds a support, load or probe to the selected body, or a projectile.
void Editor::add_entry(const ui::Command& command) {
  state_.running = false;
  if (command.id == CommandId::add_projectile) return add_projectile();
  const Scene& scene = history_.scene();
  if (scene.bodies.empty()) return;
  const int index = state_.selected_body;
  const BodyDescription& body = scene.bodies[static_cast<std::size_t>(index)];
  const Eigen::AlignedBox3d box = rest_box(scene, index, world().frame(), built_);
  SceneEntry added;
  history_.change("Add " + std::string(ui::command_info(command.id).label), [&](Scene& edited) {
    BodyDescription& changed = edited.bodies[static_cast<std::size_t>(index)];
    if (command.id == CommandId::add_support) {
      added = {EntryKind::support, static_cast<int>(changed.supports.size()), index};
      changed.supports.push_back(new_support(body, box));
    } else if (command.id == CommandId::add_load) {
      added = {EntryKind::load, static_cast<int>(changed.loads.size()), index};
      changed.loads.push_back(new_load(body, box));
    } else {
      added = {EntryKind::probe, static_cast<int>(edited.probes.size())};
      edited.probes.push_back(new_probe(edited, body, box));
    }
  });
  history_.finish();
  ui::select_entries(state_, history_.scene(), {added});
}

void Editor::add_projectile() {
  const Vec3 eye = camera_.position.cast<double>(), target = camera_.target.cast<double>();
  ProjectileBurst shot = aimed_shot(state_.shot, eye, target, history_.scene().gravity);
  history_.change("Add Projectile", [&](Scene& scene) { scene.projectiles.push_back(shot); });
  history_.finish();
  const int last = static_cast<int>(history_.scene().projectiles.size()) - 1;
  ui::select_entries(state_, history_.scene(), {{EntryKind::projectile, last}});
}

void Editor::add_camera() {
  Camera camera = described(camera_);
  camera.name = ui::free_name(history_.scene().cameras, "view");
  history_.change("Add camera " + camera.name, [&](Scene& scene) { scene.cameras.push_back(camera); });
  history_.finish();
  const int last = static_cast<int>(history_.scene().cameras.size()) - 1;
  ui::select_entries(state_, history_.scene(), {{EntryKind::camera, last}});
}

void Editor::look_through() {
  const std::optional<SceneEntry> entry = ui::active_entry(state_, history_.scene());
  if (entry && entry->kind == EntryKind::camera) use_camera(ui::entry_name(history_.scene(), *entry));
}

void Editor::set_camera() {
  const std::optional<SceneEntry> entry = ui::active_entry(state_, history_.scene());
  if (!entry || entry->kind != EntryKind::camera) return;
  const std::string name = ui::entry_name(history_.scene(), *entry);
  history_.change("Set camera " + name + " to view", [&](Scene& scene) {
    Camera& camera = scene.cameras[static_cast<std::size_t>(entry->index)];
    camera = described(camera_);
    camera.name = name;
  });
  history_.finish();
}

void Editor::duplicate_entries() {
  state_.running = false;
  std::vector<SceneEntry> copies;
  history_.change("Duplicate", [&](Scene& scene) {
    for (const SceneEntry& entry : ui::selected_entries(state_, scene)) {
      if (entry.kind == EntryKind::body) {
        scene.bodies.push_back(copy_of_body(scene, entry.index, frame()));
        copies.push_back({EntryKind::body, static_cast<int>(scene.bodies.size()) - 1});
      } else {
        copies.push_back(ui::append_copy(scene, entry));
      }
    }
  });
  history_.finish();
  ui::select_entries(state_, history_.scene(), std::move(copies));
}

void Editor::remove_entries() {
  state_.running = false;
  const std::vector<SceneEntry> chosen = ui::selected_entries(state_, history_.scene());
  if (chosen.empty()) return;
  history_.change("Delete", [&](Scene& scene) { ui::remove_entries(scene, chosen); });
  history_.finish();
  // The next entry of the kind is selected; if none is left, nothing, so that Delete never continues with another kind.
  SceneEntry next = *std::ranges::min_element(chosen);
  next.kind = chosen.back().kind;
  while (next.index > 0 && !ui::has_entry(history_.scene(), next)) --next.index;
  state_.entries = {next};
  if (next.kind == EntryKind::body) state_.selected_body = next.index;
  state_.selection = {};
}

void Editor::move_entries(int way) {
  state_.running = false;
  std::vector<SceneEntry> moved;
  history_.change(way < 0 ? "Move up" : "Move down",
                  [&](Scene& scene) { moved = ui::move_entries(scene, ui::selected_entries(state_, scene), way); });
  history_.finish();
  ui::select_entries(state_, history_.scene(), std::move(moved));
}

void Editor::begin_renaming() {
  const std::optional<SceneEntry> entry = ui::active_entry(state_, history_.scene());
  if (!entry || !ui::has_name(entry->kind)) return;
  state_.list_pieces = false;
  state_.body_filter = {};
  state_.listed_entry.reset();  // scrolls to it
  state_.renamed = entry;
  state_.new_name = ui::entry_name(history_.scene(), *entry);
}

void Editor::toggle_hidden() {
  const std::vector<std::string> bodies = ui::selected_bodies(state_, history_.scene());
  const auto hidden = [&](const std::string& name) { return state_.hidden_bodies.contains(name); };
  const bool show = std::ranges::all_of(bodies, hidden);
  for (const std::string& name : bodies)
    show ? void(state_.hidden_bodies.erase(name)) : void(state_.hidden_bodies.insert(name));
}

}  // namespace griffith::app
