#pragma once

#include <imgui.h>

#include <string_view>

namespace griffith::ui {

/// A rectangle on the screen [pixels].
struct Box {
  ImVec2 low, high;
};

/// Placement of text about an item: next to the item's window if a side has room, else below or above the item; on the
/// screen, and never over the item.
class BubblePlace {
 public:
  /// `em`: font size. `screen`: its lower right corner.
  BubblePlace(const Box& item, const Box& window, ImVec2 screen, float em);

  /// Largest width of the text.
  float text_width() const { return text_width_; }
  /// Returns the box of the bubble for a text of that size.
  Box box(ImVec2 text_size) const;
  /// Distance between the bubble's border and its text.
  float padding() const { return em_ / 2; }

 private:
  Box item_, window_;
  ImVec2 screen_;
  float em_, text_width_;
  bool to_the_right_ = false, beside_ = false;
};

/// Draws text next to the last item, over everything else, with a border of that color.
void draw_bubble(std::string_view text, ImU32 border);

/// Shows `text` next to the last item while the mouse rests on it.
void tooltip(std::string_view text);

}  // namespace griffith::ui
