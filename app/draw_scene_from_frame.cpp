#include "app/draw_scene_from_frame.h"

#include <algorithm>
#include <cmath>

#include "app/carried_points.h"
#include "app/natural_materials.h"
#include "app/quantities.h"
#include "app/skin_picture.h"
#include "app/splinter_picture.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/scene/view_quantity.h"

namespace griffith::app {
namespace {

constexpr render::Rgb kProjectileColor = {0.24f, 0.27f, 0.31f};

/// Whether a picture shows tets, or what is embedded in them.
class TetFilter {
 public:
  TetFilter(const Frame& frame, const EmbeddedDisplay& display, const ViewSettings& view)
      : frame_(frame), display_(display), embedded_(view.splinters && display.mesh) {}

  bool shows_embedded() const { return embedded_; }
  /// Whether a face without a neighbour is shown: of a body with a skin, what cracks have laid bare.
  bool shows(std::size_t tet, std::size_t face) const {
    if (!embedded_) return true;
    const auto body = static_cast<std::size_t>(frame_.tet_bodies[tet].value);
    const auto scene_body = static_cast<std::size_t>(frame_.bodies[body].scene_body);
    const bool is_crack = !(frame_.first_surface[tet] >> face & 1);
    return !display_.splintered[scene_body] && (is_crack || !display_.skinned[scene_body]);
  }

 private:
  const Frame& frame_;
  const EmbeddedDisplay& display_;
  bool embedded_;
};

template <class Visit>
void for_each_surface_face(const Frame& frame, const Visit& visit) {
  for (std::size_t tet = 0; tet < frame.tets.size(); ++tet) {
    for (std::size_t face = 0; face < 4; ++face) {
      if (!frame.neighbours[tet][face].valid()) visit(tet, face);
    }
  }
}

/// A light, saturated colour of its own for each id; neighbours in number are far apart in hue.
render::Rgb id_color(std::int32_t id) {
  constexpr double kGoldenRatio = 0.6180339887498949, kStart = 0.07;
  const double hue = std::fmod(kStart + kGoldenRatio * id, 1.0);
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

BodyId body_of_splinter(const Frame& frame, const Splinter& splinter) {
  return frame.tet_bodies[static_cast<std::size_t>(splinter.owner.value)];
}

void color_by_id(render::DrawScene& picture, const Frame& frame, const EmbeddedDisplay& display,
                 const ViewSettings& view) {
  for (const std::int32_t tet : picture.surface.ids)
    picture.surface.colors.push_back(id_color(frame.tet_bodies[static_cast<std::size_t>(tet)].value));
  if (!picture.embedded.mesh) return;
  for (std::size_t i = 0; i < frame.splinters.size(); ++i) {
    const bool by_body = view.quantity == "body";
    const std::int32_t id = by_body ? body_of_splinter(frame, frame.splinters[i]).value : static_cast<std::int32_t>(i);
    picture.embedded.piece_colors.push_back(id_color(id));
  }
  for (const SkinPart& part : display.skin_parts)
    picture.embedded.piece_colors.push_back(
        id_color(frame.tet_bodies[static_cast<std::size_t>(part.triangle_tet.value)].value));
}

void color_by_material(render::DrawScene& picture, const Frame& frame) {
  for (std::size_t i = 0; i < picture.surface.ids.size(); ++i) {
    const auto tet = static_cast<std::size_t>(picture.surface.ids[i]);
    const auto body = static_cast<std::size_t>(frame.tet_bodies[tet].value);
    const Look look = picture.surface.flags[i] & render::kCrackFace ? Look::inside : Look::outside;
    const auto index = static_cast<std::size_t>(look_index(frame.bodies[body].scene_body, look));
    picture.surface.colors.push_back(picture.embedded.materials[index].color);
  }
}

void add_scalars(render::Surface& surface, const Frame& frame, const TetFilter& filter, const QuantityValues& values) {
  for_each_surface_face(frame, [&](std::size_t tet, std::size_t face) {
    if (!filter.shows(tet, face)) return;
    if (!values.per_node) return surface.scalars.push_back(values.values[tet]);
    for (const int corner : kTetFaces[face]) {
      const NodeId node = frame.tets[tet][static_cast<std::size_t>(corner)];
      surface.scalars.push_back(values.values[static_cast<std::size_t>(node.value)]);
    }
  });
}

void color_by_scalar(render::DrawScene& picture, const Frame& frame, const TetFilter& filter,
                     const ViewSettings& view) {
  QuantityValues values = quantity_values(frame, view.quantity);
  add_scalars(picture.surface, frame, filter, values);
  const Vec2 range = view.range.value_or(automatic_range(frame, view.quantity, values));
  render::ScalarStyle& style = picture.surface.scalar_style;
  style.color_map = render::find_color_map(view.color_map).value_or(render::ColorMap::kViridis);
  style.minimum = static_cast<float>(range[0]);
  style.maximum = static_cast<float>(range[1]);
  for (const ViewQuantity& quantity : view_quantities()) {
    if (quantity.key != view.quantity) continue;
    style.quantity = quantity.label;
    style.unit = quantity.unit;
  }
  picture.embedded.scalars_per_point = values.per_node;
  picture.embedded.scalars = std::move(values.values);
}

void add_colors(render::DrawScene& picture, const Frame& frame, const EmbeddedDisplay& display, const TetFilter& filter,
                const ViewSettings& view) {
  if (view.quantity == "body" || view.quantity == "splinter") {
    color_by_id(picture, frame, display, view);
  } else if (view.quantity == "material" || view.quantity == "texture") {
    picture.embedded.checker = view.quantity == "texture";
    color_by_material(picture, frame);
  } else {
    color_by_scalar(picture, frame, filter, view);
  }
}

render::EmbeddedSurface embedded_surface(const Frame& frame, const EmbeddedDisplay& display) {
  render::EmbeddedSurface surface;
  surface.mesh = display.mesh;
  surface.points.reserve(frame.positions.size());
  for (const Vec3& position : frame.positions) surface.points.push_back(position.cast<float>());
  surface.tets = ordered_tets(frame, display.orders);
  add_carriers(frame, surface.carriers);
  for (const SkinPart& part : display.skin_parts) surface.carriers.push_back(skin_carrier(frame, part).value);
  surface.opened.assign(frame.open_walls.begin(), frame.open_walls.end());
  return surface;
}

/// A power of ten that puts some ten lines beside the bodies.
float grid_spacing(const Eigen::AlignedBox3f& box) {
  const float size = box.isEmpty() ? 1 : std::max(box.diagonal().norm(), 1e-3f);
  return std::pow(10.0f, std::floor(std::log10(size / 2)));
}

}  // namespace

EmbeddedDisplay embedded_display(const Frame& frame, const Scene& scene) {
  EmbeddedDisplay display;
  display.splintered.resize(scene.bodies.size(), 0);
  display.skinned.resize(scene.bodies.size(), 0);
  for (const Splinter& splinter : frame.splinters)
    display.splintered[static_cast<std::size_t>(splinter.scene_body)] = 1;
  auto mesh = std::make_shared<render::EmbeddedMesh>();
  add_splinters(frame, *mesh);
  for (const Skin& skin : make_skins(frame, scene)) {
    const auto parts = static_cast<int>(display.skin_parts.size());
    add_skin(frame, skin, static_cast<int>(frame.splinter_parts.size()) + parts,
             static_cast<int>(frame.splinters.size()) + parts, *mesh);
    for (const SkinCorner& corner : skin.corners) display.skin_parts.push_back(corner.part);
    display.skinned[static_cast<std::size_t>(skin.scene_body)] = 1;
  }
  if (mesh->polygons.empty()) return display;
  display.mesh = std::move(mesh);
  display.orders = summation_orders(frame);
  return display;
}

render::DrawScene draw_scene_from_frame(const Frame& frame, const EmbeddedDisplay& display, const Scene& scene,
                                        const ViewSettings& view, TetId selected) {
  render::DrawScene result;
  const TetFilter filter(frame, display, view);
  for_each_surface_face(frame, [&](std::size_t tet, std::size_t face) {
    if (filter.shows(tet, face)) add_triangle(result.surface, frame, tet, face, selected);
  });
  if (filter.shows_embedded()) result.embedded = embedded_surface(frame, display);
  result.embedded.materials = natural_materials(scene);
  result.embedded.selected_tet = selected.value;
  add_colors(result, frame, display, filter, view);
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
