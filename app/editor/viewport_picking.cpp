#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "app/editor/picking.h"
#include "app/editor/shooting.h"
#include "app/editor/symbol_picking.h"
#include "app/editor/viewport.h"

namespace griffith::app {
namespace {

/// Returns a point of a tet, with the weights of its corners 1 to 3, in given positions of nodes [m].
Vec3 point_in(const std::array<NodeId, 4>& corners, const Vec3& weights, std::span<const Vec3> positions) {
  Vec3 point = (1 - weights.sum()) * positions[corners[0]];
  for (int i = 0; i < 3; ++i) point += weights[i] * positions[corners[i + 1]];
  return point;
}

}  // namespace

render::Ray Viewport::ray_at(const ui::ViewPoint& point) const {
  const Eigen::Vector2i pixels = size(point.view);
  return render::pixel_ray(picture_camera(point.view), static_cast<float>(point.place.x() * pixels.x()),
                           static_cast<float>(point.place.y() * pixels.y()), pixels.x(), pixels.y());
}

TetId Viewport::tet_at(const Frame& frame, const ui::ViewPoint& point) const {
  const auto view = static_cast<std::size_t>(point.view);
  const PictureKey& drawn = drawn_[view];
  if (drawn.width == 0) return TetId();
  const std::int32_t id = renderer_.id_at(static_cast<int>(point.place.x() * drawn.width),
                                          static_cast<int>(point.place.y() * drawn.height), view);
  return id >= 0 && static_cast<std::size_t>(id) < frame.elements.tets.size() ? TetId(id) : TetId();
}

void Viewport::pick(const ShownWorld& world, const Vec2& cursor) {
  state_.entries.clear();
  state_.selection = {};
  state_.symbol.reset();
  const Frame& frame = world.frame;
  const ui::ViewPoint point = point_at(cursor);
  const TetId tet = tet_at(frame, point);
  const ShownMesh shown = shown_mesh(frame, state_.view, {}, hidden_bodies(state_, world.scene));
  if (!pick_symbol(shown, tet, point) && tet.valid())
    select(state_, frame, ui::select(frame, tet, nearest_corner(shown, tet, ray_at(point))));
}

bool Viewport::pick_symbol(const ShownMesh& shown, TetId tet, const ui::ViewPoint& point) {
  constexpr double kSlack = 5;  // [design pixels]
  const render::Ray ray = ray_at(point);
  const double angle = picture_camera(point.view).vertical_fov * std::numbers::pi / 180;
  const double pixel = 2 * std::tan(angle / 2) / size(point.view).y();
  const bool opaque = tet.valid() && picture().surface.opacity == 1;
  const double limit =
      opaque ? seen_distance(shown, tet, ray) + 0.25 * shown.element_size : std::numeric_limits<double>::infinity();
  const std::vector<LayerSymbol> symbols = layer_symbols(shown);
  const LayerSymbol* found = symbol_on(ray, symbols, kSlack * pixel, limit);
  if (!found) return false;
  state_.symbol = found->symbol;
  const int index = found->symbol.index;
  const Frame& frame = shown.frame;
  switch (found->symbol.kind) {
    case ui::SymbolKind::fracture_plane:
      select_node(state_, frame, frame.crack_events[static_cast<std::size_t>(index)].node);
      break;
    case ui::SymbolKind::separation_axis:
      select_node(state_, frame, NodeId(index));
      break;
    case ui::SymbolKind::stress_axis:
      select(state_, frame, ui::select(frame, TetId(index), nearest_corner(shown, TetId(index), ray)));
      break;
    case ui::SymbolKind::contact:
      break;
  }
  return true;
}

std::vector<ui::RegionLine> Viewport::symbol_lines(const Frame& frame, const Scene& scene) const {
  if (!state_.symbol) return {};
  const ShownMesh shown = shown_mesh(frame, state_.view, {}, hidden_bodies(state_, scene));
  const std::vector<LayerSymbol> symbols = layer_symbols(shown);
  const auto found = std::ranges::find(symbols, *state_.symbol, &LayerSymbol::symbol);
  if (found == symbols.end()) return {};
  if (found->symbol.kind != ui::SymbolKind::fracture_plane)
    return {{found->place - found->arm, found->place + found->arm}};
  const Vec3 across = found->arm.unitOrthogonal() * found->arm.norm();
  std::vector<ui::RegionLine> lines = ui::circle_lines(found->place, across, found->arm.normalized().cross(across));
  lines.push_back({found->place, found->place + found->arm});
  return lines;
}

std::optional<Grab> Viewport::grabbed_at(const ShownWorld& world, const Vec2& cursor) {
  const ui::ViewPoint point = point_at(cursor);
  const TetId tet = tet_at(world.frame, point);
  if (!tet.valid()) return std::nullopt;
  const ShownMesh shown = shown_mesh(world.frame, state_.view, {}, hidden_bodies(state_, world.scene));
  const std::array<NodeId, 4>& corners = world.frame.elements.tets[tet];
  Grab grab{.tet = tet.index(), .weights = seen_weights(shown, tet, ray_at(point)), .spring = state_.grab_spring};
  grab_view_ = point.view;
  grab.target = point_in(corners, grab.weights, world.frame.nodes.positions);
  grab_offset_ = point_in(corners, grab.weights, shown.positions) - grab.target;
  return grab;
}

std::optional<Push> Viewport::pushed_at(const ShownWorld& world, const Vec2& cursor) const {
  const ui::ViewPoint point = point_at(cursor);
  const TetId tet = tet_at(world.frame, point);
  if (!tet.valid()) return std::nullopt;
  const ShownMesh shown = shown_mesh(world.frame, state_.view, {}, hidden_bodies(state_, world.scene));
  const render::Ray ray = ray_at(point);
  const double impulse = state_.push_speed * world.frame.bodies[world.frame.elements.bodies[tet]].mass;
  return Push{tet.index(), seen_weights(shown, tet, ray), impulse * ray.direction.cast<double>().normalized()};
}

Vec3 Viewport::dragged_to(const Vec3& target, const Vec2& cursor) const {
  const render::Ray ray = ray_at({grab_view_, ui::place_in(state_.four_views, grab_view_, cursor, viewport_size())});
  const render::Camera camera = camera_of(grab_view_);
  const Vec3 eye = ray.origin.cast<double>(), direction = ray.direction.cast<double>();
  const Vec3 sight = (camera.target - camera.position).cast<double>();
  const double depth = sight.dot(target + grab_offset_ - eye) / sight.dot(direction);
  return eye + depth * direction - grab_offset_;
}

AimedShot Viewport::aimed_at(const Frame& frame, const Scene& scene, const Vec2& cursor) const {
  const ui::ViewPoint point = point_at(cursor);
  const render::Ray ray = ray_at(point);
  const render::Camera camera = camera_of(point.view);
  const Vec3 direction = ray.direction.cast<double>(), eye = ray.origin.cast<double>();
  const double way =
      surface_hit(frame, scene.ground, eye, direction).value_or((camera.target - camera.position).norm());
  // It starts below the eye, far enough ahead not to cover the picture, and near enough for views from far away.
  const double near = point.view == 0 ? 0 : way - 2 * static_cast<double>(render::height_at_target(camera));
  const double ahead = std::max(std::min(4 * state_.shot.radius, way / 2), near);
  const Vec3 muzzle = eye + ahead * direction - 2 * state_.shot.radius * Vec3::UnitY();
  const Vec3 target = eye + way * direction;
  return {aimed_shot(state_.shot, muzzle, target, scene.gravity), target};
}

ui::Aim Viewport::aim(const Frame& frame, const Scene& scene) const {
  if (!state_.aimed_at) return {};
  const auto [shot, target] = aimed_at(frame, scene, *state_.aimed_at);
  return flight_of(shot, target, scene.gravity, frame, scene.ground);
}

}  // namespace griffith::app
