#include "ui/dialogs/dialogs.h"

#include <array>
#include <utility>

#include "ui/dialogs/dialog_window.h"
#include "ui/model/scene_names.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr char kWorkTitle[] = "Working";

constexpr std::array<std::pair<const char*, const char*>, 14> kMouseHelp = {{
    {"Left drag", "orbit"},
    {"Shift + drag, middle drag", "pan"},
    {"Wheel", "zoom"},
    {"Click", "inspect a node and its element, select the body"},
    {"Ctrl + drag", "move the slice plane"},
    {"Left drag, Grab on", "pull a piece by a spring while the simulation runs; Escape lets go"},
    {"Click, Push on", "push a piece along the line of sight"},
    {"Drag a material", "give it to a body, in the view or the outliner"},
    {"Right click in the view", "fire the projectile at that point; hold the button to preview its path"},
    {"Click on a number", "type a value: 20, 20 GPa, 2*30+1 mm; Tab: next field, Escape: cancel"},
    {"Drag a number", "change it; Shift: fine steps, Ctrl: round values"},
    {"Click on a view's name", "with four views: choose its side and its quantity"},
    {"Right end of a title", "drag: move the section of the panel; click: fold it"},
    {"Drop a file", "open a scene"},
}};

void labeled_text(const char* label, const std::string& text, ImU32 color) {
  if (text.empty()) return;
  ImGui::TextColored(as_vec4(palette::kTextDim), "%s", label);
  wrapped_text(text, color);
  ImGui::Spacing();
}

void error_dialog(Panel& panel) {
  std::optional<ErrorMessage>& error = panel.state.error;
  if (!begin_dialog(panel, "Error", error.has_value(), 480)) return;
  if (error) {
    labeled_text("Where", error->where, palette::kText);
    labeled_text("Problem", error->problem, palette::kError);
    labeled_text("Remedy", error->remedy, palette::kGood);
  }
  hint(panel, "The program continues with its previous state.");
  ImGui::Spacing();
  if (text_button(panel, "error/close", "Close", 120 * ui_scale(panel)) || dismiss_pressed()) error.reset();
  if (!error) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

/// Names the commands that keys have queued: "Then: Delete, Delete". Reports if a click was lost.
void waiting_line(Panel& panel) {
  std::string text;
  for (const Command& command : panel.state.waiting)
    text.append(text.empty() ? "Then: " : ", ").append(command_info(command.name, panel).label);
  if (!text.empty()) {
    hint(panel, text);
    tag_last_item(panel.tags, "work/waiting", text);
  }
  if (!panel.state.lost_click) return;
  hint(panel, "Clicks have no effect until this is done, nor do keys after a click.");
  tag_last_item(panel.tags, "work/lost_click", "");
}

/// Shows the progress of work. A dialog takes the keyboard, so none opens while text is typed: the next field, to which
/// Tab went on, would lose what is typed into it whenever the work that the last one began takes long.
void work_dialog(Panel& panel) {
  EditorState& state = panel.state;
  if (ImGui::GetIO().WantTextInput && !ImGui::IsPopupOpen(kWorkTitle)) return;
  if (!begin_dialog(panel, kWorkTitle, true, 480)) return;
  const std::string text = state.work + " ...";
  ImGui::TextUnformatted(text.c_str());
  tag_last_item(panel.tags, "work/stage", state.work);
  waiting_line(panel);
  ImGui::Spacing();
  if (text_button(panel, "work/cancel", "Cancel", 120 * ui_scale(panel)) || escape_pressed()) state.cancel_work = true;
  ImGui::EndPopup();
}

/// Closes the progress dialog once its work is done; nothing else closes it.
void close_work_dialog() {
  if (!ImGui::IsPopupOpen(kWorkTitle)) return;
  if (ImGui::BeginPopupModal(kWorkTitle, nullptr, kDialogFlags)) {
    ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
}

void open_scene(Panel& panel, const std::filesystem::path& path) {
  issue(panel, {.name = "file.open_path", .path = path});
  panel.state.show_open = false;
}

void scene_list(Panel& panel) {
  ImGui::BeginChild("##scenes", {0, 12 * ImGui::GetTextLineHeightWithSpacing()});
  const std::span<const std::filesystem::path> files = panel.input.scene_files;
  const std::vector<std::string> names = scene_names(files);
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string& name = names[i];
    if (ImGui::Selectable(name.c_str(), files[i] == panel.input.scene_path)) open_scene(panel, files[i]);
    tag_last_item(panel.tags, "open/" + name, name);
  }
  ImGui::EndChild();
}

void open_dialog(Panel& panel) {
  EditorState& state = panel.state;
  if (!begin_dialog(panel, "Open a scene", state.show_open, 520)) return;
  scene_list(panel);
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputTextWithHint("##path", "path of a scene file, or drop it on the window", state.path_text.data(),
                               state.path_text.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  const bool left = escape_left_untyped();
  tag_last_item(panel.tags, "open/path", state.path_text.data());
  ImGui::Spacing();
  const bool pressed = text_button(panel, "open/open", "Open", 120 * ui_scale(panel));
  if ((entered || pressed) && state.path_text[0] != '\0') open_scene(panel, state.path_text.data());
  ImGui::SameLine();
  if (text_button(panel, "open/scenes", "Pictures…", 120 * ui_scale(panel))) {
    issue(panel, {.name = "file.scenes"});
    state.show_open = false;
  }
  ImGui::SameLine();
  if (text_button(panel, "open/cancel", "Cancel", 120 * ui_scale(panel)) || escape_pressed() || left)
    state.show_open = false;
  if (!state.show_open) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

void help_table_row(const char* keys, const char* text) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextColored(as_vec4(palette::kAccent), "%s", keys);
  ImGui::TableNextColumn();
  wrapped_text(text);
}

void help_dialog(Panel& panel) {
  EditorState& state = panel.state;
  if (!begin_dialog(panel, "Mouse and keyboard", state.show_help, 620)) return;
  const float room = 0.9f * ImGui::GetIO().DisplaySize.y - 6 * ImGui::GetFrameHeightWithSpacing();
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_ScrollY;
  if (ImGui::BeginTable("##help", 2, kFlags, {0, room})) {
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("text", ImGuiTableColumnFlags_WidthStretch);
    for (const auto& [keys, text] : kMouseHelp) help_table_row(keys, text);
    help_table_row("", "");
    for (const CommandInfo& info : panel.input.commands) {
      if (info.shortcut.key == key::kNone) continue;
      help_table_row(shortcut_text(info.shortcut).c_str(), std::string(info.hint).c_str());
    }
    ImGui::EndTable();
  }
  ImGui::Spacing();
  if (text_button(panel, "help/close", "Close", 120 * ui_scale(panel)) || dismiss_pressed()) state.show_help = false;
  if (!state.show_help) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace

void draw_dialogs(Panel& panel) {
  if (panel.state.work.empty()) close_work_dialog();
  switch (shown_dialog(panel.state)) {
    case Dialog::none:
      return;
    case Dialog::work:
      return work_dialog(panel);
    case Dialog::error:
      return error_dialog(panel);
    case Dialog::large_mesh:
      return draw_large_mesh_dialog(panel);
    case Dialog::report:
      return draw_report_dialog(panel);
    case Dialog::unsaved:
      return draw_unsaved_dialog(panel);
    case Dialog::save_as:
      return draw_save_dialog(panel);
    case Dialog::replacement:
      return draw_replacement_dialog(panel);
    case Dialog::recovery:
      return draw_recovery_dialog(panel);
    case Dialog::surface:
      return draw_surface_dialog(panel);
    case Dialog::scenes:
      return draw_scenes_dialog(panel);
    case Dialog::open:
      return open_dialog(panel);
    case Dialog::preferences:
      return draw_preferences_dialog(panel);
    case Dialog::steps:
      return draw_steps_dialog(panel);
    case Dialog::array:
      return draw_array_dialog(panel);
    case Dialog::render:
      return draw_render_dialog(panel);
    case Dialog::palette:
      return draw_palette_dialog(panel);
    case Dialog::help:
      return help_dialog(panel);
  }
}

}  // namespace griffith::ui
