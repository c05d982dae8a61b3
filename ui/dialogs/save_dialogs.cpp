#include <algorithm>
#include <cfloat>

#include "ui/dialogs/dialog_window.h"
#include "ui/dialogs/dialogs.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr float kButtonWidth = 120;    // design pixels
constexpr std::size_t kMaxLines = 12;  ///< most lines before the list scrolls

void set_name(SaveTarget& target, const std::string& name) {
  target.name = {};
  name.copy(target.name.data(), target.name.size() - 1);
}

/// Lists the existing scenes; a click takes the name.
void name_list(Panel& panel, SaveTarget& target) {
  if (target.existing.empty()) return;
  const auto lines = static_cast<float>(std::min<std::size_t>(target.existing.size(), kMaxLines));
  ImGui::BeginChild("##scenes", {0, lines * ImGui::GetTextLineHeightWithSpacing()});
  for (const std::string& name : target.existing) {
    if (ImGui::Selectable(name.c_str(), name == target.name.data())) set_name(target, name);
    tag_last_item(panel.tags, "save/" + name, name);
  }
  ImGui::EndChild();
}

/// Texts of the dialog for a kind of file.
struct SavedWords {
  const char* title;
  CommandId save, dialog;
};

SavedWords words_of(SavedKind kind) {
  switch (kind) {
    case SavedKind::scene:
      return {"Save the scene as", CommandId::save, CommandId::save_dialog};
    case SavedKind::recording:
      return {"Save the recording as", CommandId::save_recording, CommandId::save_recording_dialog};
    case SavedKind::plots:
      return {"Save the plots as", CommandId::save_plots, CommandId::save_plots_dialog};
    case SavedKind::macro:
      return {"Save the macro as", CommandId::save_macro, CommandId::save_macro_dialog};
    case SavedKind::exported:
      return {"Export the run as", CommandId::export_run, CommandId::export_dialog};
    default:
      return {"Save the bug report as", CommandId::save_report, CommandId::save_report_dialog};
  }
}

/// Returns the dialog that asks for another file than the command has.
CommandId dialog_of(CommandId save) {
  for (const SavedKind kind :
       {SavedKind::recording, SavedKind::bug_report, SavedKind::plots, SavedKind::exported, SavedKind::macro})
    if (words_of(kind).save == save) return words_of(kind).dialog;
  return CommandId::save_dialog;
}

std::string_view ending_of(SavedKind kind) {
  switch (kind) {
    case SavedKind::scene:
      return ".json";
    case SavedKind::plots:
      return ".csv";
    case SavedKind::exported:
      return ".glb";
    case SavedKind::macro:
      return ".script";
    default:
      return ".tar.zst";
  }
}

void close(bool answered) {
  if (answered) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

/// Explains the formats by file name extension.
void export_hint(const Panel& panel) {
  hint(panel, "Pieces, motion and bonds: .glb (Blender, Unity, Unreal), .usda (USD), .json, .csv");
  hint(panel, "Page for a browser: .html");
  hint(panel, "The view: .mp4, .webm, .gif (with ffmpeg), .png (one picture per step)");
}

}  // namespace

SaveTarget save_target(const std::filesystem::path& file, SavedKind kind) {
  const std::filesystem::path whole = std::filesystem::absolute(file).lexically_normal();
  SaveTarget target{kind, whole.parent_path(), {}, {}};
  set_name(target, whole.filename().string());
  return target;
}

std::filesystem::path file_of(const SaveTarget& target) {
  std::filesystem::path file = target.folder / target.name.data();
  const std::string_view ending = ending_of(target.kind);
  const bool is_picture = target.kind == SavedKind::plots && file.extension() == ".png";
  const bool ends_well =
      is_picture || (target.kind == SavedKind::exported ? file.has_extension() : file.string().ends_with(ending));
  if (!ends_well) file += ending;
  return file.lexically_normal();
}

void draw_save_dialog(Panel& panel) {
  std::optional<SaveTarget>& target = panel.state.save_as;
  const SavedWords words = words_of(target ? target->kind : SavedKind::scene);
  if (!begin_dialog(panel, words.title, target.has_value(), 520)) return;
  name_list(panel, *target);
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputTextWithHint("##name", "file name", target->name.data(), target->name.size(),
                               ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  const bool left = escape_left_untyped();
  tag_last_item(panel.tags, "save/name", target->name.data());
  const bool named = target->name[0] != '\0';
  const std::filesystem::path file = file_of(*target);
  hint(panel, named ? file.string() : target->folder.string());
  tag_last_item(panel.tags, "save/path", file.string());
  if (target->kind == SavedKind::exported) export_hint(panel);
  if (target->kind == SavedKind::plots) hint(panel, "Values of all steps: .csv; picture of the plots: .png");
  ImGui::Spacing();
  const bool pressed = text_button(panel, "save/save", "Save", kButtonWidth * ui_scale(panel));
  const bool saved = (entered || pressed) && named;
  if (saved) issue(panel, {.id = words.save, .path = file});
  ImGui::SameLine();
  const bool cancelled =
      text_button(panel, "save/cancel", "Cancel", kButtonWidth * ui_scale(panel)) || escape_pressed() || left;
  if (cancelled) panel.state.after_save.reset();
  if (saved || cancelled) target.reset();
  close(saved || cancelled);
}

void draw_replacement_dialog(Panel& panel) {
  std::optional<Replacement>& replacement = panel.state.replacement;
  if (!begin_dialog(panel, "Replace the file?", replacement.has_value(), 480)) return;
  ImGui::TextWrapped("%s Its content would be lost.", replacement->problem.c_str());
  tag_last_item(panel.tags, "replace/problem", replacement->problem);
  ImGui::Spacing();
  const float width = kButtonWidth * ui_scale(panel);
  const bool agreed = text_button(panel, "replace/replace", "Replace", width);
  if (agreed) {
    replacement->command.replace = true;
    issue(panel, replacement->command);
  }
  ImGui::SameLine();
  const bool cancelled = text_button(panel, "replace/cancel", "Cancel", width) || escape_pressed();
  const std::filesystem::path file = replacement->command.path;
  if (cancelled && !file.empty()) issue(panel, {.id = dialog_of(replacement->command.id), .path = file});
  if (cancelled && file.empty()) panel.state.after_save.reset();
  if (agreed || cancelled) replacement.reset();
  close(agreed || cancelled);
}

void draw_unsaved_dialog(Panel& panel) {
  std::optional<Command>& command = panel.state.unsaved;
  if (!begin_dialog(panel, "Unsaved edits", command.has_value(), 480)) return;
  ImGui::TextWrapped("%s would discard them.", command->id == CommandId::quit ? "Quitting" : "Opening another scene");
  ImGui::Spacing();
  const float width = kButtonWidth * ui_scale(panel);
  const bool saved = text_button(panel, "unsaved/save", "Save", width);
  ImGui::SameLine();
  const bool discarded = text_button(panel, "unsaved/discard", "Discard", width);
  ImGui::SameLine();
  const bool cancelled = text_button(panel, "unsaved/cancel", "Cancel", width) || escape_pressed();
  if (saved) {
    panel.state.after_save = command;
    issue(panel, {.id = CommandId::save});
  } else if (discarded) {
    command->discard_edits = true;
    issue(panel, *command);
  }
  if (saved || discarded || cancelled) command.reset();
  close(saved || discarded || cancelled);
}

void draw_recovery_dialog(Panel& panel) {
  const std::string& edits = panel.state.recoverable_edits;
  if (!begin_dialog(panel, "Recover unsaved edits", !edits.empty(), 520)) return;
  ImGui::TextWrapped("Griffith quit before these edits were saved. It kept a copy:");
  ImGui::TextWrapped("%s", edits.c_str());
  tag_last_item(panel.tags, "left_edits/text", edits);
  ImGui::Spacing();
  const float width = kButtonWidth * ui_scale(panel);
  std::optional<CommandId> answer;
  if (text_button(panel, "left_edits/recover", "Recover", width)) answer = CommandId::recover;
  ImGui::SameLine();
  if (text_button(panel, "left_edits/discard", "Discard", width)) answer = CommandId::discard_copy;
  ImGui::SameLine();
  if (text_button(panel, "left_edits/later", "Ask later", width) || escape_pressed()) answer = CommandId::leave_copy;
  if (answer) issue(panel, {.id = *answer});
  close(answer.has_value());
}

}  // namespace griffith::ui
