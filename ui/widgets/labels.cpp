#include "ui/widgets/labels.h"

#include "ui/widgets/style.h"

namespace griffith::ui {

void draw_labels(ImDrawList* list, const std::vector<PictureLabel>& labels, const Fonts& fonts, ImVec2 minimum,
                 ImVec2 maximum, float scale) {
  const float size = kSmallText * scale, pad = 4 * scale;
  for (const PictureLabel& label : labels) {
    const ImVec2 extent = fonts.small->CalcTextSizeA(size, FLT_MAX, 0, label.text.c_str());
    const ImVec2 center = {minimum.x + label.x * (maximum.x - minimum.x),
                           minimum.y + label.y * (maximum.y - minimum.y)};
    const ImVec2 low = {center.x - extent.x / 2, center.y - (0.5f + label.rise) * extent.y};
    list->AddRectFilled({low.x - pad, low.y - pad / 2}, {low.x + extent.x + pad, low.y + extent.y + pad / 2},
                        IM_COL32(24, 27, 32, 200), 4 * scale);
    list->AddText(fonts.small, size, low, palette::kText, label.text.c_str());
  }
}

}  // namespace griffith::ui
