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

/// Adds the label of what broke while it was scaled, above the hints and the text of a comparison.
void add_scaling_label(ui::EditorInput& input, const Scene& scene, float height, bool compares) {
  if (height <= 0) return;                                   // before the first layout
  constexpr float kAboveHints = 56, kAboveComparison = 112;  // design pixels
  const float rise =
      (compares ? kAboveComparison : kAboveHints) * input.fonts.small->FontSize / ui::kSmallText / height;
  if (const auto label = scaling_label(scene, input.frame, 1 - rise)) input.views.front().labels.push_back(*label);
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
  for (Content& content : contents_) content.range.restart();
}

void Viewport::follow_step(const ShownWorld& world, std::optional<StepPicture> picture) {
  Content& content = contents_.front();
  if (!picture || picture->settings != settings(world.scene, 0))
    return content.range.follow(world.frame, state_.view.quantity);
  display_ = std::move(picture->display);
  content.range = std::move(picture->range);
  content.picture = std::move(picture->drawn);
  content.made_of = content_key(world.version, 0);
  ++content.revision;
}

void Viewport::update(const ShownWorld& world, int content) {
  Content& made = contents_[static_cast<std::size_t>(content)];
  ContentKey key = content_key(world.version, content);
  if (key == made.made_of) return;
  const PictureSettings now = settings(world.scene, content);
  made.picture = draw_next_step(world.frame, display_, made.range, now.scene, now.view, now.selection, now.hidden);
  made.made_of = std::move(key);
  ++made.revision;
}

bool Viewport::draw(const ShownWorld& world, std::optional<int> samples) {
  double seconds = 0;
  const bool drew = draw_view(world, 0, samples, seconds);
  for (int view = 1; view < state_.four_views.count(); ++view) draw_view(world, view, samples, seconds);
  if (seconds > 0) draft_.drew_full(seconds);
  return drew;
}

bool Viewport::draw_view(const ShownWorld& world, int view, std::optional<int> samples, double& seconds) {
  using Clock = std::chrono::steady_clock;
  PictureKey key = picture_key(world.version, view);
  PictureKey& drawn = drawn_[static_cast<std::size_t>(view)];
  if (key == drawn) return false;
  drawn = std::move(key);
  update(world, content_of(view));
  const Clock::time_point begun = Clock::now();
  render(view, drawn.draft, samples);
  if (!draft_.allowed() || drawn.draft) return true;
  glFinish();  // to measure the drawing, not its request
  seconds += std::chrono::duration<double>(Clock::now() - begun).count();
  return true;
}

void Viewport::render(int view, bool draft, std::optional<int> samples) {
  ViewSettings settings = view_settings(content_of(view));
  settings.quality = quality(settings, draft);
  render::RenderOptions options = picture_options(size(view).x(), size(view).y(), samples, settings);
  options.pixel_scale = picture_options(size(0).x(), size(0).y(), samples, settings).pixel_scale;
  const Content& content = contents_[static_cast<std::size_t>(content_of(view))];
  const Uploaded needed{content_of(view), content.revision, options.pixel_scale};
  if (needed != uploaded_) renderer_.upload(content.picture, options.pixel_scale);
  uploaded_ = needed;
  renderer_.draw(content.picture, picture_camera(view), options, static_cast<std::size_t>(view));
}

void Viewport::use_camera(const Scene& scene, const std::string& name) {
  camera_ = scene_camera(scene, name, picture(), aspect(0));
  if (scene.cameras.empty()) look_at(render::bounds(picture()));
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
  const render::Camera framed = render::frame_bounds(picture_camera(0), bounds, aspect(0));
  camera_.position = framed.position;  // the field of view is widened for the picture alone
  camera_.target = framed.target;
}

void Viewport::frame_all(const ShownWorld& world) {
  const Eigen::AlignedBox3f bulk =
      bulk_bounds(shown_mesh(world.frame, state_.view, {}, hidden_bodies(state_, world.scene)));
  look_at(bulk.isEmpty() ? render::bounds(picture()) : bulk);
}

void Viewport::reveal(const ShownWorld& world, const std::vector<std::string>& bodies) {
  if (bodies.empty()) return;
  const std::vector<BodyDescription>& described = world.scene.bodies;
  const ShownMesh shown = shown_mesh(world.frame, state_.view, {}, hidden_bodies(state_, world.scene));
  const std::vector<Eigen::AlignedBox3f> boxes = body_bounds(shown, described.size());
  Eigen::AlignedBox3f added;
  bool are_shown = true;
  for (std::size_t i = 0; i < described.size(); ++i) {
    if (boxes[i].isEmpty() || std::ranges::find(bodies, described[i].name) == bodies.end()) continue;
    are_shown &= render::shows(picture_camera(0), boxes[i], aspect(0));
    added.extend(boxes[i]);
  }
  if (!are_shown) look_at(added.merged(bulk_bounds(shown)));
}

void Viewport::follow_mouse(bool steps_lag) {
  const ui::CameraMotion motion = std::exchange(state_.camera_motion, {});
  draft_.follow(steps_lag || !(motion == ui::CameraMotion{}));
  if (motion == ui::CameraMotion{}) return;  // rounding errors alone would move a camera at rest
  move_camera(motion);
  if (state_.view.slice && (motion.slice_right != 0 || motion.slice_up != 0)) move_slice(motion);
}

void Viewport::move_camera(const ui::CameraMotion& motion) {
  const int view = state_.four_views.active;
  if (view == 0) camera_ = render::orbit(camera_, motion.yaw, motion.pitch);
  const render::Camera seen = camera_of(view), panned = render::pan(seen, motion.pan_right, motion.pan_up);
  if (view == 0) {
    camera_ = panned;
  } else {
    camera_.position += panned.target - seen.target;
    camera_.target = panned.target;
  }
  camera_ = render::zoom(camera_, motion.zoom);
}

void Viewport::move_slice(const ui::CameraMotion& motion) {
  constexpr double kFacing = 0.05;
  const render::Camera seen = camera_of(state_.four_views.active);
  const ui::ViewCamera axes = view_camera(seen);
  SlicePlane& slice = *state_.view.slice;
  const Vec3 normal = slice.normal.normalized();
  const Vec2 along(normal.dot(axes.right), normal.dot(axes.up)), drag(motion.slice_right, motion.slice_up);
  // A plane that faces the eye has no direction on the screen: up is toward the eye.
  const double fraction =
      along.squaredNorm() > kFacing ? drag.dot(along) / along.squaredNorm() : -normal.dot(axes.forward) * drag.y();
  slice.offset += fraction * static_cast<double>(render::height_at_target(seen));
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
    const render::ScalarStyle& style = picture().surface.scalar_style;
    state_.view.range = Vec2(style.minimum, style.maximum);
  }
}

void Viewport::describe(ui::EditorInput& input, const Scene& scene) {
  for (int view = 0; view < state_.four_views.count(); ++view)
    input.views[static_cast<std::size_t>(view)] = shown_view(view, input.fonts);
  add_scaling_label(input, scene, static_cast<float>(size(0).y()), state_.comparison.branch.has_value());
  input.toward_eye = (camera_.position - camera_.target).cast<double>();
  input.symbol_lines = symbol_lines(input.frame, scene);
  input.aim = aim(input.frame, scene);
  if (!state_.pointed_at) return;
  if (const TetId tet = tet_at(input.frame, point_at(*state_.pointed_at)); tet.valid())
    input.pointed = input.frame.elements.bodies[tet];
}

ui::ShownView Viewport::shown_view(int view, const ui::Fonts& fonts) {
  const auto index = static_cast<std::size_t>(view), content = static_cast<std::size_t>(content_of(view));
  const render::DrawScene& picture = contents_[content].picture;
  ui::ShownView shown;
  if (drawn_[index].width > 0)
    shown.picture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(renderer_.color_texture(index)));
  shown.camera = view_camera(picture_camera(view));
  shown.labels = scene_labels(picture, picture_camera(view), aspect(view));
  if (content == index) shown.legend = scene_legend(picture, view == 0 && state_.view.range.has_value());
  if (shown.legend && view == 0) place_legend(*shown.legend, fonts);
  return shown;
}

void Viewport::place_legend(ui::Legend& legend, const ui::Fonts& fonts) {
  legend.corner = legend_corner_;
  PictureKey key = picture_key({contents_.front().made_of.version.world, 0, 0, 0}, 0);
  key.content.selected = {};
  if (key == legend_placed_) return;
  const ImVec2 size(static_cast<float>(key.width), static_cast<float>(key.height));
  const float scale = fonts.small->FontSize / ui::kSmallText;
  legend_corner_ = legend.corner = legend_corner(picture(), picture_camera(0), legend, fonts, size, scale);
  legend_placed_ = std::move(key);
}

ExportedView Viewport::exported_view(const Scene& built) const {
  return {picture_camera(0), state_.view, hidden_bodies(state_, built), size(0).x(), size(0).y()};
}

ViewSettings Viewport::view_settings(int content) const {
  ViewSettings view = state_.view;
  if (content == 0) return view;
  view.quantity = state_.four_views.quantities[static_cast<std::size_t>(content)];
  view.range.reset();
  return view;
}

PictureSettings Viewport::settings(const Scene& built, int content) const {
  return {built, view_settings(content), state_.selection, hidden_bodies(state_, built)};
}

Viewport::ContentKey Viewport::content_key(const WorldVersion& version, int content) const {
  return {version, view_settings(content), state_.selection, state_.hidden_bodies};
}

Viewport::PictureKey Viewport::picture_key(const WorldVersion& version, int view) const {
  const ui::Comparison& compared = state_.comparison;
  const render::Camera camera = camera_of(view);
  return {content_key(version, content_of(view)),
          size(view).x(),
          size(view).y(),
          compared.branch.value_or(-1),
          compared.step,
          draft_.on(),
          camera.position,
          camera.target};
}

ImVec2 Viewport::viewport_size() const {
  return state_.viewport_size.x > 0 ? state_.viewport_size : ImVec2(kFirstWidth, kFirstHeight);
}

Eigen::Vector2i Viewport::size(int view) const {
  const ImVec2 size = ui::area_of(state_.four_views, view, viewport_size()).size;
  return {static_cast<int>(std::lround(size.x)), static_cast<int>(std::lround(size.y))};
}

float Viewport::aspect(int view) const {
  return static_cast<float>(size(view).x()) / static_cast<float>(size(view).y());
}

render::Camera Viewport::camera_of(int view) const {
  const ui::ViewSide side = state_.four_views.sides[static_cast<std::size_t>(view)];
  return side == ui::ViewSide::camera ? camera_ : render::far_camera(camera_, ui::toward_side(side).cast<float>());
}

}  // namespace griffith::app
