#pragma once

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

namespace griffith::ui {

/// Position and content of a drawn widget, by which tests and scripts find and drive it.
struct WidgetTag {
  std::string name;         ///< "material/young_modulus"
  ImVec2 minimum, maximum;  ///< rectangle on the screen [pixels]
  std::string value;        ///< shown value
  bool enabled = true;
  ImU32 color = 0;  ///< color of its text, if it has a meaning

  ImVec2 center() const { return {(minimum.x + maximum.x) / 2, (minimum.y + maximum.y) / 2}; }
};

/// The widgets of one drawn frame, in drawing order.
using WidgetTags = std::vector<WidgetTag>;

/// Returns the tag of that name, or nullptr.
inline const WidgetTag* find_tag(const WidgetTags& tags, std::string_view name) {
  for (const WidgetTag& tag : tags) {
    if (tag.name == name) return &tag;
  }
  return nullptr;
}

/// Tags the ImGui item that was submitted last.
inline void tag_last_item(WidgetTags& tags, std::string name, std::string value = {}, bool enabled = true) {
  tags.push_back({std::move(name), ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), std::move(value), enabled});
}

}  // namespace griffith::ui
