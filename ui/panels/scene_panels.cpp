#include <type_traits>

#include "ui/model/entry_choice.h"
#include "ui/panels/panels.h"
#include "ui/widgets/field_rows.h"

namespace griffith::ui {
namespace {

bool header(const Panel& panel, const char* tag, const std::string& text) {
  open_if_sought(panel, tag);
  const bool open = ImGui::CollapsingHeader((text + "###" + tag).c_str());
  tag_last_item(panel.tags, tag, open ? "open" : "closed");
  return open;
}

/// Returns the entry's name before the current edit, unless that edit created it.
std::string old_name(const EditHistory& history, const SceneEntry& entry) {
  const bool was_there = history.editing() && has_entry(history.entries().back().before, entry);
  return full_name(was_there ? history.entries().back().before : history.scene(), entry);
}

/// Returns the reason why the edited entry cannot have its name; empty if it can. Probes follow a renamed body.
template <class T>
std::string take_name(const Scene& scene, const SceneEntry& entry, const T& edited) {
  if constexpr (requires { edited.name; }) {
    Scene renamed = scene;
    return rename_entry(renamed, entry, edited.name);
  } else {
    return {};
  }
}

/// Draws the rows of an entry and puts its edits into the scene. `tag`: prefix of their tags.
template <class T>
void entry_rows(Panel& panel, const SceneEntry& entry, const std::string& tag, T edited,
                const std::vector<std::string_view>& hidden) {
  FieldRows rows(panel, tag, hidden);
  rows.show(edited);
  Edit edit = rows.finish();
  if (edit.changed) {
    const std::string problem = take_name(panel.history.scene(), entry, edited);
    if (!problem.empty()) panel.state.field_note = {tag + "/name", problem};
    edit.changed = problem.empty();
  }
  const std::string label = "Set " + rows.edited() + " of " + old_name(panel.history, entry);
  if (edit.changed) {
    panel.history.change(label, [&](Scene& scene) {
      if constexpr (requires { edited.name; }) rename_entry(scene, entry, edited.name);
      visit_list(scene, entry, [&](auto& list) {
        auto& item = list[static_cast<std::size_t>(entry.index)];
        if constexpr (std::is_same_v<std::remove_reference_t<decltype(item)>, T>) item = edited;
      });
    });
  }
  if (edit.finished) panel.history.finish();
}

void body_rows_of(Panel& panel, const SceneEntry& entry) {
  if (!header(panel, "body", "Shape and motion")) return;
  entry_rows(panel, entry, "body", panel.history.scene().bodies[static_cast<std::size_t>(entry.index)],
             {"supports", "loads"});
}

}  // namespace

void draw_entry_panel(Panel& panel) {
  const Scene& scene = panel.history.scene();
  const std::optional<SceneEntry> entry = active_entry(panel.state, scene);
  if (!entry) return;
  if (entry->kind == EntryKind::body) {
    draw_material_panel(panel);
    return body_rows_of(panel, *entry);
  }
  heading(panel, full_name(scene, *entry).c_str());
  visit_entry(scene, *entry, [&](const auto& item) { entry_rows(panel, *entry, "entry", item, idle_fields(item)); });
}

void draw_scene_panel(Panel& panel) {
  if (!header(panel, "scene", "Scene")) return;
  Scene scene = panel.history.scene();
  FieldRows rows(panel, "scene", {"bodies", "projectiles", "probes", "cameras", "view"});
  rows.show(scene);
  const Edit edit = rows.finish();
  if (edit.changed) panel.history.change("Set " + rows.edited(), [&](Scene& edited) { edited = std::move(scene); });
  if (edit.finished) panel.history.finish();
}

}  // namespace griffith::ui
