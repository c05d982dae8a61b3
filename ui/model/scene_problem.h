#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ui/model/scene_entry.h"

namespace griffith::ui {

/// What should be known about a part of the scene.
struct SceneProblem {
  std::string pointer;  ///< JSON pointer to the part: "/bodies/0/loads/1/region"
  std::string text, remedy;
};

/// What is shown of the problems.
struct ProblemView {
  bool shown = false;
  float height = 0;  ///< of the panel [pixels]; 0: not laid out yet
};

/// Where the editor shows what a JSON pointer names.
struct FieldPlace {
  std::optional<SceneEntry> entry;  ///< to be chosen in the outliner; nothing: a field of the scene itself
  std::string tag;                  ///< of the field: "entry/region"
  bool operator==(const FieldPlace&) const = default;
};
FieldPlace field_place(const Scene& scene, std::string_view pointer);

/// "Load 2 of wall: region"; the names of fields alone where it is a part of the scene itself.
std::string place_text(const Scene& scene, std::string_view pointer);

/// A field that the panels unfold and scroll to, for as many frames as that takes.
struct SoughtField {
  std::string tag;
  int frames = 0;  ///< left
};
/// Whether the sought field is the one of this tag, or a part of it.
bool is_within(std::string_view sought, std::string_view tag);

}  // namespace griffith::ui
