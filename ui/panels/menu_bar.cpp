#include "ui/model/scene_names.h"
#include "ui/panels/panels.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

void command_item(Panel& panel, CommandId id, bool checked = false) {
  const CommandInfo& info = command_info(id);
  const bool enabled = command_enabled(id, panel);
  const std::string label(info.label), shortcut(info.shortcut_text);
  if (ImGui::MenuItem(label.c_str(), shortcut.c_str(), checked, enabled)) issue(panel, {.id = id});
  tag_last_item(panel.tags, "menu/" + std::string(info.name), label, enabled);
}

void scene_items(Panel& panel) {
  const std::span<const std::filesystem::path> files = panel.input.scene_files;
  const std::vector<std::string> names = scene_names(files);
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string& name = names[i];
    if (ImGui::MenuItem(name.c_str(), nullptr, files[i] == panel.input.scene_path))
      issue(panel, {.id = CommandId::open, .path = files[i]});
    tag_last_item(panel.tags, "menu/scene/" + name, name);
  }
}

bool menu(Panel& panel, const char* label) {
  const bool open = ImGui::BeginMenu(label);
  tag_last_item(panel.tags, std::string("menu/") + label, open ? "open" : "closed");
  if (open) close_on_escape();
  return open;
}

void file_menu(Panel& panel) {
  if (!menu(panel, "File")) return;
  command_item(panel, CommandId::new_scene);
  command_item(panel, CommandId::open_dialog);
  if (ImGui::BeginMenu("Scenes", !panel.input.scene_files.empty())) {
    scene_items(panel);
    ImGui::EndMenu();
  }
  command_item(panel, CommandId::save);
  command_item(panel, CommandId::save_dialog);
  ImGui::Separator();
  command_item(panel, CommandId::save_recording_dialog);
  command_item(panel, CommandId::screenshot);
  ImGui::Separator();
  command_item(panel, CommandId::quit);
  ImGui::EndMenu();
}

void scene_title(const Panel& panel) {
  std::string title = panel.history.scene().name;
  if (panel.history.modified()) title += " *";
  const float width = ImGui::CalcTextSize(title.c_str()).x;
  ImGui::SetCursorPosX((ImGui::GetWindowWidth() - width) / 2);
  ImGui::TextColored(as_vec4(palette::kTextDim), "%s", title.c_str());
}

}  // namespace

void draw_menu_bar(Panel& panel) {
  if (!ImGui::BeginMainMenuBar()) return;
  file_menu(panel);
  if (menu(panel, "Edit")) {
    command_item(panel, CommandId::undo);
    command_item(panel, CommandId::redo);
    ImGui::Separator();
    command_item(panel, CommandId::duplicate_body);
    command_item(panel, CommandId::delete_body);
    ImGui::EndMenu();
  }
  if (menu(panel, "Add")) {
    for (const CommandId id : {CommandId::add_box, CommandId::add_plate, CommandId::add_pane, CommandId::add_cylinder,
                               CommandId::add_sphere, CommandId::add_beam})
      command_item(panel, id);
    ImGui::Separator();
    command_item(panel, CommandId::add_surface_dialog);
    ImGui::EndMenu();
  }
  if (menu(panel, "Simulation")) {
    for (const CommandId id :
         {CommandId::toggle_run, CommandId::step, CommandId::reset, CommandId::fire, CommandId::keep_shot}) {
      command_item(panel, id, id == CommandId::toggle_run && panel.state.running);
    }
    ImGui::Separator();
    for (const CommandId id :
         {CommandId::step_back, CommandId::go_to_start, CommandId::go_to_end, CommandId::explain_holding})
      command_item(panel, id);
    ImGui::EndMenu();
  }
  if (menu(panel, "View")) {
    command_item(panel, CommandId::frame_all);
    command_item(panel, CommandId::toggle_edges, panel.state.view.edges);
    command_item(panel, CommandId::toggle_range_lock, panel.state.view.range.has_value());
    command_item(panel, CommandId::toggle_slice, panel.state.view.slice.has_value());
    command_item(panel, CommandId::select_most_loaded);
    ImGui::EndMenu();
  }
  if (menu(panel, "Help")) {
    command_item(panel, CommandId::help, panel.state.show_help);
    command_item(panel, CommandId::save_report_dialog);
    ImGui::EndMenu();
  }
  scene_title(panel);
  ImGui::EndMainMenuBar();
}

}  // namespace griffith::ui
