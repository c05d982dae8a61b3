#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "ui/widgets/fonts.h"

namespace griffith::ui {

/// A few words at a place of a picture.
struct PictureLabel {
  float x = 0, y = 0;  ///< shares of the picture's width and height, from its top left corner
  std::string text;
  float rise = 0;  ///< how far its middle is above the place [heights of a line]
};

/// Writes labels over the picture that fills the rectangle. `scale`: screen pixels per design pixel.
void draw_labels(ImDrawList* list, const std::vector<PictureLabel>& labels, const Fonts& fonts, ImVec2 minimum,
                 ImVec2 maximum, float scale);

}  // namespace griffith::ui
