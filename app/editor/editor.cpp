#include "app/editor/editor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/picture/bounds_of.h"
#include "app/picture/named_view.h"
#include "app/picture/picture_options.h"
#include "app/picture/scene_camera.h"
#include "app/picture/scene_legend.h"
#include "app/shared/scene_files.h"
#include "app/shared/scene_warnings.h"
#include "app/shared/scene_world.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

constexpr std::size_t kMaxLogLines = 5000;
/// Size of the picture before the panels are laid out [pixels].
constexpr int kFirstWidth = 640, kFirstHeight = 480;

ProjectileBurst first_shot(const Scene& scene) {
  ProjectileBurst shot = scene.projectiles.empty() ? ProjectileBurst{} : scene.projectiles.front();
  shot.count = 1;
  return shot;
}

ui::ViewCamera view_camera(const render::Camera& camera) {
  const Mat3 axes = render::view_matrix(camera).topLeftCorner<3, 3>().cast<double>();
  return {.eye = camera.position.cast<double>(),
          .right = axes.row(0),
          .up = axes.row(1),
          .forward = -axes.row(2),
          .tangent = std::tan(static_cast<double>(camera.vertical_fov) * std::numbers::pi / 360)};
}

/// Sets the bounding box of the deformable bodies, however they are drawn.
void set_bounds(ui::EditorInput& input) {
  const Eigen::AlignedBox3d box = bounds_of(input.frame);
  if (box.isEmpty()) return;
  input.low = box.min();
  input.high = box.max();
}

}  // namespace

Editor::Editor(Scene scene, std::filesystem::path path, const Scene* edited)
    : history_(scene),
      file_time_(time_of_file(path)),
      timeline_(make_world(edited ? *edited : scene, path)),
      display_(embedded_display(world().frame(), edited ? *edited : scene)),
      warnings_(scene_warnings(edited ? *edited : scene, world())) {
  show_scene(std::move(scene), std::move(path), edited);
}

void Editor::show_scene(Scene scene, std::filesystem::path path, const Scene* edited) {
  state_.running = false;
  state_.view = (edited ? *edited : scene).view;
  state_.shot = first_shot(edited ? *edited : scene);
  state_.selected_body = 0;
  state_.entries.clear();
  state_.hidden_bodies.clear();
  state_.renamed.reset();
  state_.selection = {};
  state_.last_shot.reset();
  history_ = ui::EditHistory(std::move(scene));
  if (edited) {
    history_.change("Unsaved edits", [&](Scene& changed) { changed = *edited; });
    history_.finish();
  }
  copied_revision_ = -1;
  path_ = std::move(path);
  scene_files_ = scene_files(path_);
  outdated_ = path_.empty() ? std::vector<InputError>() : outdated_names(path_);
  restart();
  use_camera("");
  log(ui::LogLevel::info, "Opened \"" + history_.scene().name + "\". Press Space to run, right-click to fire.");
}

void Editor::restart() {
  travel_.reset();
  built_ = history_.scene();
  seen_revision_ = -1;
  history_of_utilizations_.clear();
  run_history_.restart(world().frame());
  leave_state();
  remember();
  compared_.reset();
  state_.comparison.branch.reset();
  reset_pace();
  step_seconds_ = 0;
  ++world_count_;
  range_.restart();
  list_problems();
  update_picture();
}

PictureSettings Editor::picture_settings() const { return {built_, state_.view, state_.selection, hidden_bodies()}; }

bool Editor::take_picture(StepPicture picture) {
  if (picture.settings != picture_settings()) return false;
  display_ = std::move(picture.display);
  range_ = std::move(picture.range);
  picture_ = std::move(picture.drawn);
  made_of_ = content_key();
  return true;
}

void Editor::update_picture() {
  ContentKey key = content_key();
  if (key == made_of_) return;
  picture_ = draw_next_step(world().frame(), display_, range_, built_, state_.view, state_.selection, hidden_bodies());
  made_of_ = std::move(key);
}

HiddenBodies Editor::hidden_bodies() const {
  HiddenBodies hidden;
  for (std::size_t i = 0; i < built_.bodies.size(); ++i)
    if (state_.hidden_bodies.contains(built_.bodies[i].name)) hidden.insert(static_cast<int>(i));
  return hidden;
}

void Editor::remember() {
  const Frame frame = world().frame();
  history_of_utilizations_.record(frame);
  run_history_.record(timeline_);
  select(ui::follow(state_.selection, frame));
}

void Editor::use_camera(const std::string& name) {
  camera_ = scene_camera(history_.scene(), name, picture_, aspect());
  if (history_.scene().cameras.empty()) look_at(render::bounds(picture_));
}

void Editor::look_at(const Eigen::AlignedBox3f& bounds) {
  const render::Camera framed = render::frame_bounds(picture_camera(), bounds, aspect());
  camera_.position = framed.position;  // the field of view is widened for the picture alone
  camera_.target = framed.target;
}

void Editor::frame_for_layout() {
  if (laid_out_ || state_.viewport_size.x <= 0) return;
  laid_out_ = true;
  if (history_.scene().cameras.empty()) use_camera("");
}

void Editor::use_view(const std::string& names) {
  use_named_view(state_.view, names, world().frame(), (camera_.position - camera_.target).cast<double>());
}

Editor::ContentKey Editor::content_key() const {
  return {world_count_, timeline_.revision(), history_.revision(), arrivals_,
          state_.view,  state_.selection,     state_.hidden_bodies};
}

Editor::PictureKey Editor::picture_key() const {
  const bool laid_out = state_.viewport_size.x > 0;
  return {content_key(),
          laid_out ? static_cast<int>(std::lround(state_.viewport_size.x)) : kFirstWidth,
          laid_out ? static_cast<int>(std::lround(state_.viewport_size.y)) : kFirstHeight,
          state_.comparison.branch.value_or(-1),
          camera_.position,
          camera_.target};
}

void Editor::draw_picture(std::optional<int> samples) {
  constexpr double kMegabyte = 1 << 20;
  timeline_.limit_memory(static_cast<std::size_t>(state_.preferences.past_memory * kMegabyte));
  receive_world();  // before the picture, which would otherwise show another world than the panels
  frame_for_layout();
  follow_comparison();
  const PictureKey key = picture_key();
  if (key == drawn_) return;
  drawn_ = key;
  update_picture();
  renderer_.render(picture_, picture_camera(), picture_options(key.width, key.height, samples, state_.view));
  draw_comparison(key, samples);
}

void Editor::add_scaling_label(const ui::Fonts& fonts, ui::EditorInput& input) const {
  if (state_.viewport_size.y <= 0) return;  // before the first layout
  constexpr float kAboveHints = 56;         // design pixels
  const float rise = kAboveHints * fonts.small->FontSize / ui::kSmallText / state_.viewport_size.y;
  if (const auto label = scaling_label(history_.scene(), input.frame, 1 - rise)) input.labels.push_back(*label);
}

void Editor::draw_panels(const ui::Fonts& fonts) {
  ui::EditorInput input;
  input.frame = world().frame();
  input.fonts = fonts;
  input.picture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(renderer_.color_texture()));
  input.legend = scene_legend(picture_, state_.view.range.has_value());
  if (input.legend) place_legend(*input.legend, fonts);
  input.labels = scene_labels(picture_, picture_camera(), aspect());
  add_scaling_label(fonts, input);
  utilizations_ = utilizations_of_node();
  input.utilizations = utilizations_;
  set_bounds(input);
  input.camera = view_camera(picture_camera());
  input.aim = aim();
  input.toward_eye = (camera_.position - camera_.target).cast<double>();
  input.scene_files = scene_files_;
  follow_browser();
  if (gallery_) input.scene_cards = gallery_->cards();
  input.macros = macros_;
  input.recent_files = recent_.files();
  input.problems = problems_;
  input.scene_path = path_;
  input.time = time_view();
  input.comparison = comparison_view();
  input.series = run_history_.series();
  if (state_.plots.shown) input.curves = plotted_curves();
  input.time_step = history_.scene().simulation.time_step;
  input.step_milliseconds = 1000 * step_seconds_;
  input.step_in_progress = background_.age();
  input.frames_per_second = pictures_drawn_.rate();
  input.reached_speed = time_made_.rate();
  input.falling_behind = pacer_.falling_behind();
  for (const ui::Command& command : ui::draw_editor(input, state_, history_, tags_)) execute(command);
  note_for_macro();
  follow_edits();
  move_camera();
}

void Editor::place_legend(ui::Legend& legend, const ui::Fonts& fonts) {
  legend.corner = legend_corner_;
  PictureKey key = picture_key();
  ContentKey& content = key.content;
  content.world_revision = content.scene_revision = content.arrivals = 0;
  content.selected = {};
  if (key != legend_placed_) {
    const ImVec2 size(static_cast<float>(key.width), static_cast<float>(key.height));
    const float scale = fonts.small->FontSize / ui::kSmallText;
    legend_corner_ = legend.corner = legend_corner(picture_, picture_camera(), legend, fonts, size, scale);
    legend_placed_ = key;
  }
}

void Editor::move_camera() {
  const ui::CameraMotion motion = std::exchange(state_.camera_motion, {});
  if (motion == ui::CameraMotion{}) return;  // rounding errors alone would move a camera at rest
  camera_ = render::orbit(camera_, motion.yaw, motion.pitch);
  camera_ = render::pan(camera_, motion.pan_right, motion.pan_up);
  camera_ = render::zoom(camera_, motion.zoom);
  if (state_.view.slice && (motion.slice_right != 0 || motion.slice_up != 0)) move_slice(motion);
}

void Editor::move_slice(const ui::CameraMotion& motion) {
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

float Editor::aspect() const {
  const PictureKey key = picture_key();
  return static_cast<float>(key.width) / static_cast<float>(key.height);
}

render::Camera Editor::picture_camera() const { return render::widen(camera_, aspect()); }

void Editor::log(ui::LogLevel level, std::string text, ui::LogSpan span) {
  if (state_.log.size() >= kMaxLogLines) {
    state_.log.erase(state_.log.begin());
    for (std::size_t* older : {&state_.log_seen, &state_.log_passed}) *older -= *older > 0;
  }
  state_.log.push_back({level, std::move(text), span});
}

std::string Editor::title() const {
  return history_.scene().name + (history_.modified() ? " * - Griffith" : " - Griffith");
}

bool Editor::take_screenshot_request() { return std::exchange(screenshot_requested_, false); }

}  // namespace griffith::app
