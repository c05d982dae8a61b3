#include <imgui_stdlib.h>

#include <array>
#include <string>

#include "ui/dialogs/dialog_window.h"
#include "ui/dialogs/dialogs.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

/// Texts of a subject, by RenderedSubject.
struct Subject {
  std::string label, path_label, path, hint;
};

const std::array<Subject, 3>& subjects() {
  static const std::array<Subject, 3> kSubjects = {{
      {"still of this step", "File", "picture.png",
       "The view as it is, in any size: large pictures are drawn in parts."},
      {"turntable of this step", "File", "turntable.mp4",
       "Once around the camera's target: a video (.mp4, .webm, .gif, with ffmpeg), or numbered pictures (.png)."},
      {"scenes of this folder", "Folder", "pictures",
       "A picture of each scene file in the folder of the open one, by its first camera. Unsaved edits are not drawn."},
  }};
  return kSubjects;
}

const Subject& subject_of(const RenderRequest& request) {
  return subjects()[static_cast<std::size_t>(request.subject)];
}

void subject_row(Panel& panel, RenderRequest& request) {
  std::vector<std::string> labels;
  for (const Subject& subject : subjects()) labels.push_back(subject.label);
  const int chosen = combo_row(panel, "render/subject", "Draw", labels, subject_of(request).label);
  if (chosen < 0) return;
  const bool proposed = request.path.empty() || request.path == subject_of(request).path;
  request.subject = static_cast<RenderedSubject>(chosen);
  if (proposed) request.path = subject_of(request).path;
}

void number_rows(Panel& panel, RenderRequest& request) {
  const auto row = [&](const char* tag, const char* label, double most, int& value, double least) {
    number_field_row(panel, {.tag = tag, .label = label, .numbers = between(least, most, "")}, value);
  };
  constexpr double kMinSide = 16, kMaxSide = 65536, kMaxPictures = 3600, kMaxStep = 1e6;
  row("render/width", "Width", kMaxSide, request.width, kMinSide);
  row("render/height", "Height", kMaxSide, request.height, kMinSide);
  if (request.subject == RenderedSubject::turntable)
    row("render/pictures", "Pictures", kMaxPictures, request.pictures, 2);
  if (request.subject == RenderedSubject::scenes) row("render/step", "Time steps before", kMaxStep, request.step, 0);
}

void quality_row(Panel& panel, RenderRequest& request) {
  static const std::vector<std::string> kLabels = {"as in the view", "poster"};
  const int chosen = combo_row(panel, "render/quality", "Quality", kLabels, kLabels[request.poster]);
  if (chosen >= 0) request.poster = chosen == 1;
}

/// Draws the field of the path. True if it was entered.
bool path_row(Panel& panel, RenderRequest& request) {
  if (request.path.empty()) request.path = subject_of(request).path;
  row_label(panel, subject_of(request).path_label.c_str());
  const bool entered = ImGui::InputText("##render_path", &request.path, ImGuiInputTextFlags_EnterReturnsTrue);
  tag_last_item(panel.tags, "render/path", request.path);
  return entered;
}

}  // namespace

void draw_render_dialog(Panel& panel) {
  RenderRequest& request = panel.state.render;
  if (!begin_dialog(panel, "Render", request.shown, 480)) return;
  subject_row(panel, request);
  number_rows(panel, request);
  quality_row(panel, request);
  const bool entered = path_row(panel, request), left = escape_left_untyped();
  // A new scene has no path yet.
  const std::filesystem::path folder =
      std::filesystem::current_path() / std::filesystem::path(panel.input.scene_path).parent_path();
  const std::filesystem::path path = (folder / request.path).lexically_normal();
  hint(panel, path.string());
  tag_last_item(panel.tags, "render/whole_path", path.string());
  hint(panel, subject_of(request).hint);
  if (request.poster)
    hint(panel,
         "Poster: the mean of 48 pictures in high quality, with depth of field and motion blur, without legend.");
  ImGui::Spacing();
  const float width = 120 * ui_scale(panel);
  const bool rendered = (text_button(panel, "render/render", "Render", width) || entered) && !request.path.empty();
  ImGui::SameLine();
  const bool cancelled = text_button(panel, "render/cancel", "Cancel", width) || escape_pressed() || left;
  if (rendered) issue(panel, {.name = "file.write_pictures", .path = path});
  if (rendered || cancelled) {
    request.shown = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace griffith::ui
