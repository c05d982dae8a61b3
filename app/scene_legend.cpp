#include "app/scene_legend.h"

namespace griffith::app {

std::optional<ui::Legend> scene_legend(const render::DrawScene& picture, bool locked) {
  if (picture.surface.scalars.empty() && picture.embedded.scalars.empty()) return std::nullopt;
  const render::ScalarStyle& style = picture.surface.scalar_style;
  return ui::Legend{style.quantity, style.unit, style.minimum, style.maximum, render::color_table(style.color_map),
                    locked};
}

}  // namespace griffith::app
