#include "app/picture/scene_legend.h"

#include <algorithm>
#include <bitset>
#include <cmath>

#include "sim/world/output/scaled_breaks.h"

namespace griffith::app {
namespace {

using Eigen::AlignedBox2f, Eigen::Vector2f, Eigen::Vector3f;

/// Projection of points to fractions of the picture's width and height, from its top left corner.
class Projection {
 public:
  Projection(const render::Camera& camera, float aspect)
      : matrix_(render::projection_matrix(camera, aspect, {}) * render::view_matrix(camera)) {}

  /// Returns the projected point; empty behind the camera.
  std::optional<Vector2f> operator()(const Vector3f& place) const {
    const Eigen::Vector4f clip = matrix_ * place.homogeneous();
    if (!(clip.w() > 0)) return std::nullopt;
    return Vector2f(0.5f + 0.5f * clip.x() / clip.w(), 0.5f - 0.5f * clip.y() / clip.w());
  }
  /// Returns the projected size of a length at a point, along both edges of the picture.
  Vector2f extent(const Vector3f& place, float length) const {
    const float w = matrix_.row(3).dot(place.homogeneous());
    return 0.5f * length / w * Vector2f(matrix_.row(0).head<3>().norm(), matrix_.row(1).head<3>().norm());
  }

 private:
  Eigen::Matrix4f matrix_;
};

/// Cells of a part of the picture that contain something visible.
class CoveredCells {
 public:
  explicit CoveredCells(const AlignedBox2f& part) : part_(part), cell_(part.sizes() / kCells) {}

  void add(const Vector2f& place) {
    if (!part_.contains(place)) return;
    const Eigen::Vector2i cell = ((place - part_.min()).cwiseQuotient(cell_)).cast<int>().cwiseMin(kCells - 1);
    cells_.set(static_cast<std::size_t>(cell.y() * kCells + cell.x()));
  }
  /// Adds a triangle, by points at a spacing of about a cell.
  void add(const Vector2f& a, const Vector2f& b, const Vector2f& c) {
    constexpr float kMaximum = 128;
    AlignedBox2f box(a);
    box.extend(b).extend(c);
    if (!part_.intersects(box)) return;
    const int parts = static_cast<int>(std::ceil(std::min(box.sizes().cwiseQuotient(cell_).maxCoeff(), kMaximum)));
    for (int i = 0; i <= parts; ++i)
      for (int j = 0; i + j <= parts; ++j)
        add(a + (i * (b - a) + j * (c - a)) / static_cast<float>(std::max(parts, 1)));
  }
  float fraction() const { return static_cast<float>(cells_.count()) / (kCells * kCells); }

 private:
  static constexpr int kCells = 16;
  AlignedBox2f part_;
  Vector2f cell_;
  std::bitset<kCells * kCells> cells_;
};

void add_sphere(const render::Sphere& sphere, const Projection& seen, CoveredCells& cells) {
  const std::optional<Vector2f> center = seen(sphere.center);
  if (!center) return;
  const Vector2f reach = seen.extent(sphere.center, sphere.radius), across(reach.x(), -reach.y());
  cells.add(*center - reach, *center + across, *center - across);
  cells.add(*center + reach, *center + across, *center - across);
}

}  // namespace

std::optional<ui::Legend> scene_legend(const render::DrawScene& picture, bool locked) {
  const render::ScalarStyle& style = picture.surface.scalar_style;
  if (style.quantity.empty()) return std::nullopt;
  ui::Legend legend{style.quantity, style.unit,     style.minimum, style.maximum, render::color_table(style.color_map),
                    locked,         style.histogram};
  const auto add = [&](const render::Rgb& color, const std::string& meaning) {
    const auto byte = [](float c) { return static_cast<std::uint8_t>(std::lround(255 * c)); };
    legend.samples.push_back({{byte(color.r), byte(color.g), byte(color.b)}, meaning});
  };
  if (style.has_nan) add(render::kNanColor, "not a number");
  if (!style.plain.empty()) add(picture.surface.color, style.plain);
  return legend;
}

float covered_fraction(const render::DrawScene& picture, const render::Camera& camera, float aspect,
                       const AlignedBox2f& part) {
  const Projection seen(camera, aspect);
  CoveredCells cells(part);
  const std::vector<Vector3f>& corners = picture.surface.positions;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const auto a = seen(corners[i]), b = seen(corners[i + 1]), c = seen(corners[i + 2]);
    if (a && b && c) cells.add(*a, *b, *c);
  }
  for (const Vector3f& point : picture.embedded.points)
    if (const auto place = seen(point)) cells.add(*place);
  for (const render::Line& line : picture.lines) {
    const auto start = seen(line.start), end = seen(line.end);
    if (start && end) cells.add(*start, *end, *end);
  }
  for (const render::Sphere& sphere : picture.spheres) add_sphere(sphere, seen, cells);
  return cells.fraction();
}

ui::LegendCorner legend_corner(const render::DrawScene& picture, const render::Camera& camera, const ui::Legend& legend,
                               const ui::Fonts& fonts, ImVec2 size, float scale) {
  const auto covered = [&](ui::LegendCorner corner) {
    const auto [low, high] = ui::legend_card(legend, corner, fonts, {{0, 0}, size}, scale);
    const AlignedBox2f part(Vector2f(low.x / size.x, low.y / size.y), Vector2f(high.x / size.x, high.y / size.y));
    return covered_fraction(picture, camera, size.x / size.y, part);
  };
  const float now = covered(legend.corner);
  if (now == 0) return legend.corner;
  const ui::LegendCorner best = *std::ranges::min_element(ui::kLegendCorners, {}, covered);
  return covered(best) < 0.5f * now ? best : legend.corner;
}

std::optional<ui::PictureLabel> scaling_label(const Scene& scene, const Frame& frame, float y) {
  const std::vector<ScaledBreak> breaks = scaled_breaks(frame);
  if (breaks.empty()) return std::nullopt;
  const auto least = std::ranges::min_element(breaks, {}, [](const ScaledBreak& one) { return one.least.factor; });
  const auto body = static_cast<std::size_t>(least->scene_body);
  const bool named = breaks.size() == 1 && body < scene.bodies.size();
  const std::string what =
      named ? scene.bodies[body].name + " broke at " : std::to_string(breaks.size()) + " bodies broke scaled, down to ";
  return ui::PictureLabel{0.5f, y, what + scale_text(least->least)};
}

std::vector<ui::PictureLabel> scene_labels(const render::DrawScene& picture, const render::Camera& camera,
                                           float aspect) {
  const Projection seen(camera, aspect);
  std::vector<ui::PictureLabel> labels;
  for (const render::Label& label : picture.labels)
    if (const auto place = seen(label.position)) labels.push_back({place->x(), place->y(), label.text, label.rise});
  return labels;
}

}  // namespace griffith::app
