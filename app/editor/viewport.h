#pragma once

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "app/editor/draft_quality.h"
#include "app/editor/run_export.h"
#include "app/editor/step_picture.h"
#include "renderer/camera.h"
#include "renderer/renderer.h"
#include "ui/model/four_views.h"
#include "ui/model/region_outline.h"
#include "ui/panels/editor_layout.h"

namespace griffith::app {

/// Counters of everything outside the viewport on which a picture depends.
struct WorldVersion {
  std::int64_t world = -1, revision = -1, scene_revision = -1, arrivals = 0;
  bool operator==(const WorldVersion&) const = default;
};

/// World of a picture.
struct ShownWorld {
  Frame frame;
  const Scene& scene;  ///< scene from which the world was built, with its current materials
  WorldVersion version;
};

/// Projectile that would be fired at a point of the view, with its target.
struct AimedShot {
  ProjectileBurst shot;
  Vec3 target;
};

/// Returns the hidden bodies by index in the scene.
HiddenBodies hidden_bodies(const ui::EditorState& state, const Scene& scene);

/// Camera and pictures of the world, one or four, and what is found under the cursor in them. Points of the viewport
/// are given from its top left corner, 0..1. Needs a current OpenGL context.
class Viewport {
 public:
  explicit Viewport(ui::EditorState& state) : state_(state) {}

  /// Begins with the first frame of another world.
  void begin(EmbeddedDisplay display);
  /// Lets the color range begin with the next picture.
  void restart_range() { contents_.front().range.restart(); }
  /// Returns the input for a picture of the step after the shown one.
  StepPicture next_picture(const Scene& built) const { return {settings(built, 0), display_, contents_.front().range}; }
  /// Follows a step. `picture`: of that step, which is taken over if it shows the current view.
  void follow_step(const ShownWorld& world, std::optional<StepPicture> picture);
  /// Makes the content of the camera's picture unless it exists.
  void update(const ShownWorld& world) { update(world, 0); }
  /// Draws the pictures that have changed, in the size that the panels left for them. False if that of the camera has
  /// not. `samples`: per pixel; those of the quality if absent.
  bool draw(const ShownWorld& world, std::optional<int> samples);

  /// Looks through a camera of the scene. Throws InputError if there is none of that name.
  void use_camera(const Scene& scene, const std::string& name);
  /// Frames a scene without cameras again once the panels are laid out.
  void frame_for_layout(const Scene& scene);
  /// Changes the view by names of named_view.h. Throws InputError for unknown ones.
  void use_view(const std::string& names, const Frame& frame);
  void look_from(const Vec3& eye, const Vec3& target);
  void frame_all(const ShownWorld& world);
  /// Frames all, and bodies of the scene by name, if one of those is out of the camera's picture. Unknown and hidden
  /// ones count for nothing.
  void reveal(const ShownWorld& world, const std::vector<std::string>& bodies);
  /// Moves camera and slice as the mouse did. `steps_lag`: the simulation runs and cannot keep up.
  void follow_mouse(bool steps_lag);
  /// Lets pictures that take longer than `smooth` [s] be drafts while the camera moves or steps lag.
  void allow_drafts(double smooth = 0.03) { draft_.allow(smooth); }
  /// Draws no picture in a higher quality than this one, whatever the view has: for tests and slow renderers.
  void limit_quality(PictureQuality highest) { highest_quality_ = highest; }
  /// True if the next picture is a draft, to be drawn again in full.
  bool draws_draft() const { return draft_.on(); }
  /// Returns the quality of the last picture of the camera.
  PictureQuality drawn_quality() const { return quality(state_.view, drawn_.front().draft); }
  void toggle_slice(const Frame& frame);
  void toggle_range_lock();

  /// Selects the symbol of a layer, or the element, at a point of the viewport.
  void pick(const ShownWorld& world, const Vec2& cursor);
  /// Returns a grab of the material at a point of the viewport; empty if there is none.
  std::optional<Grab> grabbed_at(const ShownWorld& world, const Vec2& cursor);
  /// Returns a push of the material at a point of the viewport along the line of sight; empty if there is none.
  std::optional<Push> pushed_at(const ShownWorld& world, const Vec2& cursor) const;
  /// Returns the target of a grab at `target` after the mouse has come to a point of the viewport: on a plane parallel
  /// to the picture in which the piece was grabbed.
  Vec3 dragged_to(const Vec3& target, const Vec2& cursor) const;
  /// Returns the shot of the projectile tool at a point of the viewport. `scene`: the edited one.
  AimedShot aimed_at(const Frame& frame, const Scene& scene, const Vec2& cursor) const;
  /// Returns the flight of the shot being aimed; empty if there is none.
  ui::Aim aim(const Frame& frame, const Scene& scene) const;

  /// Adds the views and what is in them to the input of the panels.
  void describe(ui::EditorInput& input, const Scene& scene);

  /// Returns the last picture of the camera as passed to the renderer.
  const render::DrawScene& picture() const { return contents_.front().picture; }
  bool has_legend() const { return !picture().surface.scalar_style.quantity.empty(); }
  const EmbeddedDisplay& display() const { return display_; }
  std::optional<Vec2> range() const { return contents_.front().range.range(); }
  const render::Camera& camera() const { return camera_; }
  /// Returns the view of the picture: the camera, widened so that a narrow picture shows as much horizontally as a wide
  /// one.
  ExportedView exported_view(const Scene& built) const;

 private:
  /// Input of the picture's content; equal keys give equal pictures.
  struct ContentKey {
    WorldVersion version;
    ViewSettings view;
    ui::Selection selected;
    std::set<std::string> hidden;
    bool operator==(const ContentKey&) const = default;
  };
  /// Input of the drawing; equal keys need no new drawing.
  struct PictureKey {
    ContentKey content;
    int width = 0, height = 0;
    int compared = -1;  ///< compared branch; -1: none
    std::int64_t compared_step = 0;
    bool draft = false;
    Eigen::Vector3f position = Eigen::Vector3f::Zero(), target = Eigen::Vector3f::Zero();
    bool operator==(const PictureKey&) const = default;
  };
  /// Picture content of the views of one quantity.
  struct Content {
    ContentKey made_of;
    render::DrawScene picture;
    SteadyRange range;
    std::int64_t revision = 0;  ///< counts its pictures
  };
  /// Content in the renderer's buffers.
  struct Uploaded {
    int content = -1;
    std::int64_t revision = 0;
    float pixel_scale = 1;
    bool operator==(const Uploaded&) const = default;
  };

  /// Returns the index of a view's content: that of the first view with its quantity.
  int content_of(int view) const {
    return state_.four_views.quantities[static_cast<std::size_t>(view)].empty() ? 0 : view;
  }
  ViewSettings view_settings(int content) const;
  PictureQuality quality(const ViewSettings& view, bool draft) const {
    return draft ? PictureQuality::draft : std::min(view.quality, highest_quality_);
  }
  PictureSettings settings(const Scene& built, int content) const;
  ContentKey content_key(const WorldVersion& version, int content) const;
  PictureKey picture_key(const WorldVersion& version, int view) const;
  void update(const ShownWorld& world, int content);

  /// Size of the viewport, also before it is laid out [pixels].
  ImVec2 viewport_size() const;
  Eigen::Vector2i size(int view) const;
  float aspect(int view) const;
  /// Returns the camera of a view, and as it is widened for its picture.
  render::Camera camera_of(int view) const;
  render::Camera picture_camera(int view) const { return render::widen(camera_of(view), aspect(view)); }
  /// Draws a view if it has changed. False if it has not. Adds the time of drawing in full to `seconds` if drafts are
  /// allowed.
  bool draw_view(const ShownWorld& world, int view, std::optional<int> samples, double& seconds);
  /// Draws the current content of a view in full or draft quality.
  void render(int view, bool draft, std::optional<int> samples);
  ui::ShownView shown_view(int view, const ui::Fonts& fonts);

  ui::ViewPoint point_at(const Vec2& cursor) const { return ui::view_at(state_.four_views, cursor, viewport_size()); }
  render::Ray ray_at(const ui::ViewPoint& point) const;
  /// Returns the drawn tet at a point; invalid if there is none.
  TetId tet_at(const Frame& frame, const ui::ViewPoint& point) const;
  /// Selects the symbol of a layer that the ray at a point meets first, in front of `tet` if bodies are opaque, with
  /// its node or element. False if there is none.
  bool pick_symbol(const ShownMesh& shown, TetId tet, const ui::ViewPoint& point);
  /// Returns the outline of the picked symbol.
  std::vector<ui::RegionLine> symbol_lines(const Frame& frame, const Scene& scene) const;
  /// Moves the camera along its line of sight and sideways until the picture shows all of the box.
  void look_at(const Eigen::AlignedBox3f& bounds);
  void move_camera(const ui::CameraMotion& motion);
  void move_slice(const ui::CameraMotion& motion);
  /// Moves the legend of the camera's picture to a free corner, once for each camera, size and view, but not after a
  /// step.
  void place_legend(ui::Legend& legend, const ui::Fonts& fonts);

  ui::EditorState& state_;
  CopyOnWrite<EmbeddedDisplay> display_;
  render::Camera camera_;
  render::Renderer renderer_;
  DraftQuality draft_;
  PictureQuality highest_quality_ = PictureQuality::high;
  std::array<Content, ui::kMaxViews> contents_;  ///< by the first view that shows it
  std::array<PictureKey, ui::kMaxViews> drawn_;  ///< keys of the views
  Uploaded uploaded_;
  PictureKey legend_placed_;  ///< picture for which the legend was placed
  ui::LegendCorner legend_corner_ = {};
  int grab_view_ = 0;  ///< view in which the piece was grabbed
  Vec3 grab_offset_ =
      Vec3::Zero();        ///< displacement of the grabbed point in the picture, as pieces are moved apart [m]
  bool laid_out_ = false;  ///< the size of the picture is known
};

}  // namespace griffith::app
