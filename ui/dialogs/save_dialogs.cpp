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

/// The dialog for a kind of file.
struct SavedFormat {
  const char* title;
  std::string_view dialog;     ///< command that opens it
  std::string_view extension;  ///< appended to names without it
};

/// By SavedKind.
constexpr SavedFormat kFormats[] = {
    {"Save the scene as", "file.save_as", ".json"},        {"Save the recording as", "file.record", ".tar.zst"},
    {"Save the bug report as", "help.report", ".tar.zst"}, {"Save the plots as", "file.plots", ".csv"},
    {"Export the run as", "file.export", ".glb"},          {"Save the macro as", "edit.save_macro", ".script"},
};

const SavedFormat& format_of(SavedKind kind) { return kFormats[static_cast<std::size_t>(kind)]; }

/// Returns the dialog that asks for another file than the command has.
std::string_view dialog_of(std::string_view save, const Panel& panel) {
  for (const SavedFormat& format : kFormats)
    if (command_info(format.dialog, panel).with_path == save) return format.dialog;
  return format_of(SavedKind::scene).dialog;
}

void close(bool answered) {
  if (answered) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace

std::string_view extension_of(SavedKind kind) { return format_of(kind).extension; }

SaveTarget save_target(const std::filesystem::path& file, SavedKind kind) {
  const std::filesystem::path whole = std::filesystem::absolute(file).lexically_normal();
  SaveTarget target;
  target.kind = kind;
  target.folder = whole.parent_path();
  set_name(target, whole.filename().string());
  return target;
}

std::filesystem::path file_of(const SaveTarget& target) {
  std::filesystem::path file = target.folder / target.name.data();
  const std::string_view extension = extension_of(target.kind);
  const bool is_picture = target.kind == SavedKind::plots && file.extension() == ".png";
  const bool ends_well =
      is_picture || (target.kind == SavedKind::exported ? file.has_extension() : file.string().ends_with(extension));
  if (!ends_well) file += extension;
  return file.lexically_normal();
}

void draw_save_dialog(Panel& panel) {
  std::optional<SaveTarget>& target = panel.state.save_as;
  const SavedFormat& format = format_of(target ? target->kind : SavedKind::scene);
  if (!begin_dialog(panel, format.title, target.has_value(), 520)) return;
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
  if (target->kind == SavedKind::exported)
    for (const std::string& line : panel.input.export_hints) hint(panel, line);
  if (target->kind == SavedKind::plots) hint(panel, "Values of all steps: .csv; picture of the plots: .png");
  if (target->kind == SavedKind::recording || target->kind == SavedKind::bug_report)
    checkbox(panel, "save/pack_outside", "Pack files from outside the scene's folder", target->pack_outside);
  ImGui::Spacing();
  const bool pressed = text_button(panel, "save/save", "Save", kButtonWidth * ui_scale(panel));
  const bool saved = (entered || pressed) && named;
  if (saved)
    issue(panel,
          {.name = command_info(format.dialog, panel).with_path, .path = file, .pack_outside = target->pack_outside});
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
  wrapped_text(replacement->problem + " Its content would be lost.");
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
  if (cancelled && !file.empty()) issue(panel, {.name = dialog_of(replacement->command.name, panel), .path = file});
  if (cancelled && file.empty()) panel.state.after_save.reset();
  if (agreed || cancelled) replacement.reset();
  close(agreed || cancelled);
}

void draw_unsaved_dialog(Panel& panel) {
  std::optional<Command>& command = panel.state.unsaved;
  if (!begin_dialog(panel, "Unsaved edits", command.has_value(), 480)) return;
  wrapped_text(std::string(command_info(command->name, panel).leaves) + " would discard them.");
  ImGui::Spacing();
  const float width = kButtonWidth * ui_scale(panel);
  const bool saved = text_button(panel, "unsaved/save", "Save", width);
  ImGui::SameLine();
  const bool discarded = text_button(panel, "unsaved/discard", "Discard", width);
  ImGui::SameLine();
  const bool cancelled = text_button(panel, "unsaved/cancel", "Cancel", width) || escape_pressed();
  if (saved) {
    panel.state.after_save = command;
    issue(panel, {.name = "file.save"});
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
  wrapped_text("Griffith quit before these edits were saved. It kept a copy:");
  wrapped_text(edits);
  tag_last_item(panel.tags, "left_edits/text", edits);
  ImGui::Spacing();
  const float width = kButtonWidth * ui_scale(panel);
  std::optional<std::string_view> answer;
  if (text_button(panel, "left_edits/recover", "Recover", width)) answer = "file.recover";
  ImGui::SameLine();
  if (text_button(panel, "left_edits/discard", "Discard", width)) answer = "file.discard_copy";
  ImGui::SameLine();
  if (text_button(panel, "left_edits/later", "Ask later", width) || escape_pressed()) answer = "file.leave_copy";
  if (answer) issue(panel, {.name = *answer});
  close(answer.has_value());
}

}  // namespace griffith::ui
