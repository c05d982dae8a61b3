#include "app/draw_scene_from_frame.h"

#include <algorithm>
#include <cmath>

#include "app/quantities.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/scene/view_quantity.h"

namespace griffith::app {
namespace {

constexpr render::Rgb kProjectileColor = {0.24f, 0.27f, 0.31f};

template <class Visit>
void for_each_surface_face(const Frame& frame, const Visit& visit) {
  for (std::size_t tet = 0; tet < frame.tets.size(); ++tet) {
    for (std::size_t face = 0; face < 4; ++face) {
      if (!frame.neighbours[tet][face].valid()) visit(tet, face);
    }
  }
}

/// A light, saturated colour of its own for each id; neighbours in number are far apart in hue.
render::Rgb body_color(BodyId body) {
  constexpr double kGoldenRatio = 0.6180339887498949, kStart = 0.07;
  const double hue = std::fmod(kStart + kGoldenRatio * body.value, 1.0);
  const auto channel = [hue](double offset) {
    const double k = std::fmod(offset + 12 * hue, 12);
    return static_cast<float>(0.66 - 0.2 * std::clamp(std::min(k - 3, 9 - k), -1.0, 1.0));
  };
  return {channel(0), channel(8), channel(4)};
}

void add_triangle(render::Surface& surface, const Frame& frame, std::size_t tet, std::size_t face, TetId selected) {
  for (const int corner : kTetFaces[face]) {
    const NodeId node = frame.tets[tet][static_cast<std::size_t>(corner)];
    surface.positions.push_back(frame.positions[static_cast<std::size_t>(node.value)].cast<float>());
  }
  std::uint8_t flags = render::kAllEdges;
  if (!(frame.first_surface[tet] >> face & 1)) flags |= render::kCrackFace;
  if (static_cast<std::int32_t>(tet) == selected.value) flags |= render::kSelected;
  surface.flags.push_back(flags);
  surface.ids.push_back(static_cast<std::int32_t>(tet));
}

void color_by_body(render::Surface& surface, const Frame& frame) {
  for (const std::int32_t tet : surface.ids) {
    surface.colors.push_back(body_color(frame.tet_bodies[static_cast<std::size_t>(tet)]));
  }
}

void color_by_scalar(render::Surface& surface, const Frame& frame, const ViewSettings& view) {
  const QuantityValues values = quantity_values(frame, view.quantity);
  for_each_surface_face(frame, [&](std::size_t tet, std::size_t face) {
    if (!values.per_node) return surface.scalars.push_back(values.values[tet]);
    for (const int corner : kTetFaces[face]) {
      const NodeId node = frame.tets[tet][static_cast<std::size_t>(corner)];
      surface.scalars.push_back(values.values[static_cast<std::size_t>(node.value)]);
    }
  });
  const Vec2 range = view.range.value_or(automatic_range(frame, view.quantity, values));
  render::ScalarStyle& style = surface.scalar_style;
  style.color_map = render::find_color_map(view.color_map).value_or(render::ColorMap::kViridis);
  style.minimum = static_cast<float>(range[0]);
  style.maximum = static_cast<float>(range[1]);
  for (const ViewQuantity& quantity : view_quantities()) {
    if (quantity.key != view.quantity) continue;
    style.quantity = quantity.label;
    style.unit = quantity.unit;
  }
}

/// A power of ten that puts some ten lines beside the bodies.
float grid_spacing(const Eigen::AlignedBox3f& box) {
  const float size = box.isEmpty() ? 1 : std::max(box.diagonal().norm(), 1e-3f);
  return std::pow(10.0f, std::floor(std::log10(size / 2)));
}

}  // namespace

render::DrawScene draw_scene_from_frame(const Frame& frame, const Scene& scene, const ViewSettings& view,
                                        TetId selected) {
  render::DrawScene result;
  for_each_surface_face(frame, [&](std::size_t tet, std::size_t face) {
    add_triangle(result.surface, frame, tet, face, selected);
  });
  if (view.quantity == "body") {
    color_by_body(result.surface, frame);
  } else {
    color_by_scalar(result.surface, frame, view);
  }
  const float spacing = grid_spacing(bounds(result));
  for (const ProjectileView& projectile : frame.projectiles) {
    result.spheres.push_back(
        {projectile.position.cast<float>(), static_cast<float>(projectile.radius), kProjectileColor, render::kNoId});
  }
  if (scene.ground) {
    render::Ground ground;
    ground.height = static_cast<float>(scene.ground->height);
    ground.grid_spacing = spacing;
    result.ground = ground;
  }
  return result;
}

}  // namespace griffith::app
