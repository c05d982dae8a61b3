#include "ui/panels/panels.h"
#include "ui/widgets/field_rows.h"

namespace griffith::ui {
namespace {

bool header(const Panel& panel, const char* tag, const std::string& text) {
  open_if_all_are(panel);
  const bool open = ImGui::CollapsingHeader((text + "###" + tag).c_str());
  tag_last_item(panel.tags, tag, open ? "open" : "closed");
  return open;
}

/// Another body has the name already, which probes know bodies by.
bool is_taken(const Scene& scene, const std::string& name, std::size_t by_other_than) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (i != by_other_than && scene.bodies[i].name == name) return true;
  return false;
}

/// As it was called before the edit that is going on.
const std::string& old_name(const EditHistory& history, std::size_t index) {
  return (history.editing() ? history.entries().back().before : history.scene()).bodies[index].name;
}

/// Probes follow their body to its new name.
void put_back(Scene& scene, std::size_t index, const BodyDescription& body) {
  for (Probe& probe : scene.probes)
    if (probe.body == scene.bodies[index].name) probe.body = body.name;
  scene.bodies[index] = body;
}

}  // namespace

void draw_body_panel(Panel& panel) {
  const Scene& scene = panel.history.scene();
  if (scene.bodies.empty()) return;
  const auto index = static_cast<std::size_t>(panel.state.selected_body);
  if (!header(panel, "body", "Shape, supports and loads")) return;
  BodyDescription body = scene.bodies[index];
  FieldRows rows(panel, "body");
  rows.show(body);
  Edit edit = rows.finish();
  if (edit.changed && is_taken(scene, body.name, index)) {
    panel.state.field_note = {"body/name", "Another body has the name \"" + body.name + "\"."};
    edit.changed = false;
  }
  const std::string label = "Set " + rows.edited() + " of " + old_name(panel.history, index);
  if (edit.changed) panel.history.change(label, [&](Scene& edited) { put_back(edited, index, body); });
  if (edit.finished) panel.history.finish();
}

void draw_scene_panel(Panel& panel) {
  if (!header(panel, "scene", "Scene")) return;
  Scene scene = panel.history.scene();
  FieldRows rows(panel, "scene", {"bodies", "view"});
  rows.show(scene);
  const Edit edit = rows.finish();
  if (edit.changed) panel.history.change("Set " + rows.edited(), [&](Scene& edited) { edited = std::move(scene); });
  if (edit.finished) panel.history.finish();
}

}  // namespace griffith::ui
