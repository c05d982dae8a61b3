#include "app/editor/viewport.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "app/editor/picking.h"
#include "app/editor/shooting.h"
#include "app/editor/symbol_picking.h"
#include "app/picture/bulk_bounds.h"
#include "app/picture/named_view.h"
#include "app/picture/picture_options.h"
#include "app/picture/scene_camera.h"
#include "app/picture/scene_legend.h"

namespace griffith::app {
namespace {

/// Size of the picture before the panels are laid out [pixels].
constexpr int kFirstWidth = 640, kFirstHeight = 480;

ui::ViewCamera view_camera(const render::Camera& camera) {
  const Mat3 axes = render::view_matrix(camera).topLeftCorner<3, 3>().cast<double>();
  return {.eye = camera.position.cast<double>(),
          .right = axes.row(0),
          .up = axes.row(1),
          .forward = -axes.row(2),
          .tangent = std::tan(static_cast<double>(camera.vertical_fov) * std::numbers::pi / 360)};
}

/// Adds the label of what broke while it was scaled, above the hints.
void add_scaling_label(ui::EditorInput& input, const Scene& scene, float height) {
  if (height <= 0) return;           // before the first layout
  constexpr float kAboveHints = 56;  // design pixels
  const float rise = kAboveHints * input.fonts.small->FontSize / ui::kSmallText / height;
  if (const auto label = scaling_label(scene, input.frame, 1 - rise)) input.labels.push_back(*label);
}

/// Returns a point of a tet, with the weights of its corners 1 to 3, in given positions of nodes [m].
Vec3 point_in(const std::array<NodeId, 4>& corners, const Vec3& weights, std::span<const Vec3> positions) {
  Vec3 point = (1 - weights.sum()) * positions[corners[0]];
  for (int i = 0; i < 3; ++i) point += weights[i] * positions[corners[i + 1]];
  return point;
}

}  // namespace

HiddenBodies hidden_bodies(const ui::EditorState& state, const Scene& scene) {
  HiddenBodies hidden;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (state.hidden_bodies.contains(scene.bodies[i].name)) hidden.insert(static_cast<int>(i));
  return hidden;
}

void Viewport::begin(EmbeddedDisplay display) {
  display_ = CopyOnWrite(std::move(display));
  range_.restart();
}

void Viewport::follow_step(const ShownWorld& world, std::optional<StepPicture> picture) {
  if (!picture || picture->settings != settings(world.scene)) return range_.follow(world.frame, state_.view.quantity);
  display_ = std::move(picture->display);
  range_ = std::move(picture->range);
  picture_ = std::move(picture->drawn);
  made_of_ = content_key(world.version);
}

void Viewport::update(const ShownWorld& world) {
  ContentKey key = content_key(world.version);
  if (key == made_of_) return;
  const PictureSettings now = settings(world.scene);
  picture_ = draw_next_step(world.frame, display_, range_, now.scene, now.view, now.selection, now.hidden);
  made_of_ = std::move(key);
}

bool Viewport::draw(const ShownWorld& world, std::optional<int> samples) {
  PictureKey key = picture_key(world.version);
  if (key == drawn_) return false;
  drawn_ = std::move(key);
  update(world);
  render(drawn_.draft, samples);
  return true;
}

void Viewport::render(bool draft, std::optional<int> samples) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begun = Clock::now();
  ViewSettings view = state_.view;
  if (draft) view.quality = PictureQuality::draft;
  renderer_.render(picture_, picture_camera(), picture_options(size().x(), size().y(), samples, view));
  if (!draft_.allowed() || draft) return;
  glFinish();  // to measure the drawing, not its request
  draft_.drew_full(std::chrono::duration<double>(Clock::now() - begun).count());
}

void Viewport::use_camera(const Scene& scene, const std::string& name) {
  camera_ = scene_camera(scene, name, picture_, aspect());
  if (scene.cameras.empty()) look_at(render::bounds(picture_));
}

void Viewport::frame_for_layout(const Scene& scene) {
  if (laid_out_ || state_.viewport_size.x <= 0) return;
  laid_out_ = true;
  if (scene.cameras.empty()) use_camera(scene, "");
}

void Viewport::use_view(const std::string& names, const Frame& frame) {
  use_named_view(state_.view, names, frame, (camera_.position - camera_.target).cast<double>());
}

void Viewport::look_from(const Vec3& eye, const Vec3& target) {
  camera_.position = eye.cast<float>();
  camera_.target = target.cast<float>();
}

void Viewport::look_at(const Eigen::AlignedBox3f& bounds) {
  const render::Camera framed = render::frame_bounds(picture_camera(), bounds, aspect());
  camera_.position = framed.position;  // the field of view is widened for the picture alone
  camera_.target = framed.target;
}

void Viewport::frame_all(const ShownWorld& world) {
  const Eigen::AlignedBox3f bulk =
      bulk_bounds(shown_mesh(world.frame, state_.view, {}, hidden_bodies(state_, world.scene)));
  look_at(bulk.isEmpty() ? render::bounds(picture_) : bulk);
}

void Viewport::follow_mouse(bool steps_lag) {
  const ui::CameraMotion motion = std::exchange(state_.camera_motion, {});
  draft_.follow(steps_lag || !(motion == ui::CameraMotion{}));
  if (motion == ui::CameraMotion{}) return;  // rounding errors alone would move a camera at rest
  camera_ = render::orbit(camera_, motion.yaw, motion.pitch);
  camera_ = render::pan(camera_, motion.pan_right, motion.pan_up);
  camera_ = render::zoom(camera_, motion.zoom);
  if (state_.view.slice && (motion.slice_right != 0 || motion.slice_up != 0)) move_slice(motion);
}

void Viewport::move_slice(const ui::CameraMotion& motion) {
  constexpr double kFacing = 0.05;
  const Vec3 sight = (camera_.target - camera_.position).cast<double>();
  const Vec3 right = sight.cross(Vec3::UnitY()).normalized(), up = right.cross(sight).normalized();
  SlicePlane& slice = *state_.view.slice;
  const Vec3 normal = slice.normal.normalized();
  const Vec2 along(normal.dot(right), normal.dot(up)), drag(motion.slice_right, motion.slice_up);
  // A plane that faces the eye has no direction on the screen: up is toward the eye.
  const double fraction = along.squaredNorm() > kFacing ? drag.dot(along) / along.squaredNorm()
                                                        : -normal.dot(sight.normalized()) * drag.y();
  slice.offset += fraction * static_cast<double>(render::height_at_target(camera_));
}

void Viewport::toggle_slice(const Frame& frame) {
  if (state_.view.slice) {
    state_.view.slice.reset();
  } else {
    use_view("slice", frame);
  }
}

void Viewport::toggle_range_lock() {
  if (state_.view.range) {
    state_.view.range.reset();
  } else if (has_legend()) {
    const render::ScalarStyle& style = picture_.surface.scalar_style;
    state_.view.range = Vec2(style.minimum, style.maximum);
  }
}

render::Ray Viewport::ray_at(const Vec2& cursor, int width, int height) const {
  return render::pixel_ray(picture_camera(), static_cast<float>(cursor.x() * width),
                           static_cast<float>(cursor.y() * height), width, height);
}

TetId Viewport::tet_at(const Frame& frame, const Vec2& cursor) const {
  const std::int32_t id =
      renderer_.id_at(static_cast<int>(cursor.x() * drawn_.width), static_cast<int>(cursor.y() * drawn_.height));
  return id >= 0 && static_cast<std::size_t>(id) < frame.elements.tets.size() ? TetId(id) : TetId();
}

void Viewport::pick(const ShownWorld& world, const Vec2& cursor) {
  state_.entries.clear();
  state_.selection = {};
  state_.symbol.reset();
  const Frame& frame = world.frame;
  const TetId tet = tet_at(frame, cursor);
  const ShownMesh shown = shown_mesh(frame, state_.view, {}, hidden_bodies(state_, world.scene));
  const render::Ray ray = ray_at(cursor, drawn_.width, drawn_.height);
  if (!pick_symbol(shown, tet, ray) && tet.valid())
    select(state_, frame, ui::select(frame, tet, nearest_corner(shown, tet, ray)));
}

bool Viewport::pick_symbol(const ShownMesh& shown, TetId tet, const render::Ray& ray) {
  constexpr double kSlack = 5;  // [design pixels]
  const double pixel = 2 * std::tan(picture_camera().vertical_fov * std::numbers::pi / 360) / drawn_.height;
  const bool opaque = tet.valid() && picture_.surface.opacity == 1;
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
  const TetId tet = tet_at(world.frame, cursor);
  if (!tet.valid()) return std::nullopt;
  const ShownMesh shown = shown_mesh(world.frame, state_.view, {}, hidden_bodies(state_, world.scene));
  const std::array<NodeId, 4>& corners = world.frame.elements.tets[tet];
  Grab grab{.tet = tet.index(),
            .weights = seen_weights(shown, tet, ray_at(cursor, drawn_.width, drawn_.height)),
            .spring = state_.grab_spring};
  grab.target = point_in(corners, grab.weights, world.frame.nodes.positions);
  grab_offset_ = point_in(corners, grab.weights, shown.positions) - grab.target;
  return grab;
}

std::optional<Push> Viewport::pushed_at(const ShownWorld& world, const Vec2& cursor) const {
  const TetId tet = tet_at(world.frame, cursor);
  if (!tet.valid()) return std::nullopt;
  const ShownMesh shown = shown_mesh(world.frame, state_.view, {}, hidden_bodies(state_, world.scene));
  const render::Ray ray = ray_at(cursor, drawn_.width, drawn_.height);
  return Push{tet.index(), seen_weights(shown, tet, ray),
              state_.push_impulse * ray.direction.cast<double>().normalized()};
}

Vec3 Viewport::dragged_to(const Vec3& target, const Vec2& cursor) const {
  const render::Ray ray = ray_at(cursor, size().x(), size().y());
  const Vec3 eye = ray.origin.cast<double>(), direction = ray.direction.cast<double>();
  const Vec3 sight = (camera_.target - camera_.position).cast<double>();
  const double depth = sight.dot(target + grab_offset_ - eye) / sight.dot(direction);
  return eye + depth * direction - grab_offset_;
}

AimedShot Viewport::aimed_at(const Frame& frame, const Scene& scene, const Vec2& cursor) const {
  const render::Ray ray = ray_at(cursor, size().x(), size().y());
  const Vec3 direction = ray.direction.cast<double>(), eye = ray.origin.cast<double>();
  const double way =
      surface_hit(frame, scene.ground, eye, direction).value_or((camera_.target - camera_.position).norm());
  // It starts below the eye, far enough ahead not to cover the picture.
  const double ahead = std::min(4 * state_.shot.radius, way / 2);
  const Vec3 muzzle = eye + ahead * direction - 2 * state_.shot.radius * Vec3::UnitY();
  const Vec3 target = eye + way * direction;
  return {aimed_shot(state_.shot, muzzle, target, scene.gravity), target};
}

ui::Aim Viewport::aim(const Frame& frame, const Scene& scene) const {
  if (!state_.aimed_at) return {};
  const auto [shot, target] = aimed_at(frame, scene, *state_.aimed_at);
  return flight_of(shot, target, scene.gravity, frame, scene.ground);
}

void Viewport::describe(ui::EditorInput& input, const Scene& scene) {
  input.picture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(renderer_.color_texture()));
  input.legend = scene_legend(picture_, state_.view.range.has_value());
  if (input.legend) place_legend(*input.legend, input.fonts);
  input.labels = scene_labels(picture_, picture_camera(), aspect());
  add_scaling_label(input, scene, state_.viewport_size.y);
  input.camera = view_camera(picture_camera());
  input.toward_eye = (camera_.position - camera_.target).cast<double>();
  input.symbol_lines = symbol_lines(input.frame, scene);
  input.aim = aim(input.frame, scene);
  if (const TetId tet = state_.pointed_at ? tet_at(input.frame, *state_.pointed_at) : TetId(); tet.valid())
    input.pointed = input.frame.elements.bodies[tet];
}

void Viewport::place_legend(ui::Legend& legend, const ui::Fonts& fonts) {
  legend.corner = legend_corner_;
  PictureKey key = picture_key({made_of_.version.world, 0, 0, 0});
  key.content.selected = {};
  if (key == legend_placed_) return;
  const ImVec2 size(static_cast<float>(key.width), static_cast<float>(key.height));
  const float scale = fonts.small->FontSize / ui::kSmallText;
  legend_corner_ = legend.corner = legend_corner(picture_, picture_camera(), legend, fonts, size, scale);
  legend_placed_ = std::move(key);
}

ExportedView Viewport::exported_view(const Scene& built) const {
  return {picture_camera(), state_.view, hidden_bodies(state_, built), size().x(), size().y()};
}

PictureSettings Viewport::settings(const Scene& built) const {
  return {built, state_.view, state_.selection, hidden_bodies(state_, built)};
}

Viewport::ContentKey Viewport::content_key(const WorldVersion& version) const {
  return {version, state_.view, state_.selection, state_.hidden_bodies};
}

Viewport::PictureKey Viewport::picture_key(const WorldVersion& version) const {
  const ui::Comparison& compared = state_.comparison;
  return {content_key(version), size().x(),  size().y(),       compared.branch.value_or(-1),
          compared.step,        draft_.on(), camera_.position, camera_.target};
}

Eigen::Vector2i Viewport::size() const {
  if (state_.viewport_size.x <= 0) return {kFirstWidth, kFirstHeight};
  return {static_cast<int>(std::lround(state_.viewport_size.x)), static_cast<int>(std::lround(state_.viewport_size.y))};
}

float Viewport::aspect() const { return static_cast<float>(size().x()) / static_cast<float>(size().y()); }

}  // namespace griffith::app
