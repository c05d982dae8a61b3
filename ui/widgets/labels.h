#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "ui/widgets/fonts.h"

namespace griffith::ui {

/// A short text at a point of a picture.
struct PictureLabel {
  float x = 0, y = 0;  ///< fractions of the picture's width and height, from its top left corner
  std::string text;
  float rise = 0;  ///< height of its center above the point [heights of a line]
};

/// Draws labels over the picture in the rectangle. `scale`: screen pixels per design pixel.
void draw_labels(ImDrawList* list, const std::vector<PictureLabel>& labels, const Fonts& fonts, ImVec2 minimum,
                 ImVec2 maximum, float scale);

}  // namespace griffith::ui
