#include "app/scene_legend.h"

#include <cmath>

namespace griffith::app {

std::optional<ui::Legend> scene_legend(const render::DrawScene& picture, bool locked) {
  const render::ScalarStyle& style = picture.surface.scalar_style;
  if (style.quantity.empty()) return std::nullopt;
  ui::Legend legend{style.quantity, style.unit,     style.minimum, style.maximum, render::color_table(style.color_map),
                    locked,         style.histogram};
  const auto byte = [](float c) { return static_cast<std::uint8_t>(std::lround(255 * c)); };
  if (style.has_nan)
    legend.nan_color = {{byte(render::kNanColor.r), byte(render::kNanColor.g), byte(render::kNanColor.b)}};
  return legend;
}

std::vector<ui::PictureLabel> scene_labels(const render::DrawScene& picture, const render::Camera& camera,
                                           float aspect) {
  const Eigen::Matrix4f projection =
      render::projection_matrix(camera, aspect, render::bounds(picture)) * render::view_matrix(camera);
  std::vector<ui::PictureLabel> labels;
  for (const render::Label& label : picture.labels) {
    const Eigen::Vector4f clip = projection * label.position.homogeneous();
    if (!(clip.w() > 0)) continue;
    labels.push_back({0.5f + 0.5f * clip.x() / clip.w(), 0.5f - 0.5f * clip.y() / clip.w(), label.text, label.rise});
  }
  return labels;
}

}  // namespace griffith::app
