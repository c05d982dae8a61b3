#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ui/model/scene_entry.h"

namespace griffith::ui {

/// A warning about a part of the scene.
struct SceneProblem {
  std::string pointer;  ///< JSON pointer to the part: "/bodies/0/loads/1/region"
  std::string text, remedy;
};

/// State of the problem panel.
struct ProblemView {
  bool shown = false;
  float height = 0;  ///< height of the panel [pixels]; 0: not laid out yet
};

/// Place in the editor that a JSON pointer names.
struct FieldPlace {
  std::optional<SceneEntry> entry;  ///< entry to select in the outliner; none: a field of the scene itself
  std::string tag;                  ///< tag of the field: "entry/region"
  bool operator==(const FieldPlace&) const = default;
};
FieldPlace field_place(const Scene& scene, std::string_view pointer);

/// Describes the place: "Load 2 of wall: region"; only field names for a part of the scene itself.
std::string place_text(const Scene& scene, std::string_view pointer);

/// A field that the panels unfold and scroll to within a few frames.
struct SoughtField {
  std::string tag;
  int frames = 0;  ///< remaining frames
};
/// True if the sought field has this tag or is a part of it.
bool is_within(std::string_view sought, std::string_view tag);

}  // namespace griffith::ui
