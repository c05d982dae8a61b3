#include <optional>
#include <utility>

#include "ui/model/scene_names.h"
#include "ui/panels/panels.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

/// Draws the submenu of recent scenes.
void recent_menu(Panel& panel) {
  const std::span<const std::filesystem::path> files = panel.input.recent_files;
  const bool open = ImGui::BeginMenu("Recent", !files.empty());
  tag_last_item(panel.tags, "menu/Recent", open ? "open" : "closed", !files.empty());
  if (!open) return;
  const std::vector<std::string> names = scene_names(files);
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string& name = names[i];
    if (ImGui::MenuItem(name.c_str(), nullptr, files[i] == panel.input.scene_path))
      issue(panel, {.name = "file.open_path", .path = files[i]});
    tag_last_item(panel.tags, "menu/recent/" + name, name);
  }
  ImGui::EndMenu();
}

/// Draws the submenu of macros.
void macro_menu(Panel& panel) {
  const bool open = ImGui::BeginMenu("Play macro", !panel.input.macros.empty());
  tag_last_item(panel.tags, "menu/Play macro", open ? "open" : "closed", !panel.input.macros.empty());
  if (!open) return;
  for (const std::filesystem::path& macro : panel.input.macros) {
    const std::string name = macro.stem().string();
    if (ImGui::MenuItem(name.c_str())) issue(panel, {.name = "edit.play_macro", .path = macro});
    tag_last_item(panel.tags, "menu/macro/" + name, name);
  }
  ImGui::EndMenu();
}

/// Draws the commands of the menu in order, with separators between groups.
void command_items(Panel& panel, Menu menu) {
  std::optional<int> group;
  for (const CommandInfo& info : panel.input.commands) {
    if (info.menu != menu) continue;
    if (const auto before = std::exchange(group, info.group); before && before != info.group) ImGui::Separator();
    command_menu_item(panel, info, "menu/");
    if (info.name == "file.open") recent_menu(panel);
    if (info.name == "edit.record_macro") macro_menu(panel);
  }
}

void draw_menu(Panel& panel, Menu menu) {
  const char* label = menu_label(menu);
  const bool open = ImGui::BeginMenu(label);
  tag_last_item(panel.tags, std::string("menu/") + label, open ? "open" : "closed");
  if (!open) return;
  close_on_escape();
  command_items(panel, menu);
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
  for (const Menu menu : {Menu::file, Menu::edit, Menu::add, Menu::simulation, Menu::view, Menu::help})
    draw_menu(panel, menu);
  scene_title(panel);
  ImGui::EndMainMenuBar();
}

}  // namespace griffith::ui
