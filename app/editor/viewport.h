#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "app/editor/draft_quality.h"
#include "app/editor/run_export.h"
#include "app/editor/step_picture.h"
#include "renderer/camera.h"
#include "renderer/renderer.h"
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

/// Camera and picture of the world, and what is found under the cursor in it. Needs a current OpenGL context.
class Viewport {
 public:
  explicit Viewport(ui::EditorState& state) : state_(state) {}

  /// Begins with the first frame of another world.
  void begin(EmbeddedDisplay display);
  /// Lets the color range begin with the next picture.
  void restart_range() { range_.restart(); }
  /// Returns the input for a picture of the step after the shown one.
  StepPicture next_picture(const Scene& built) const { return {settings(built), display_, range_}; }
  /// Follows a step. `picture`: of that step, which is taken over if it shows the current view.
  void follow_step(const ShownWorld& world, std::optional<StepPicture> picture);
  /// Makes the picture of the world unless it exists.
  void update(const ShownWorld& world);
  /// Draws the picture in the size that the panels left for it. False if it has not changed. `samples`: per pixel;
  /// those of the quality if absent.
  bool draw(const ShownWorld& world, std::optional<int> samples);

  /// Looks through a camera of the scene. Throws InputError if there is none of that name.
  void use_camera(const Scene& scene, const std::string& name);
  /// Frames a scene without cameras again once the panels are laid out.
  void frame_for_layout(const Scene& scene);
  /// Changes the view by names of named_view.h. Throws InputError for unknown ones.
  void use_view(const std::string& names, const Frame& frame);
  void look_from(const Vec3& eye, const Vec3& target);
  void frame_all(const ShownWorld& world);
  /// Moves camera and slice as the mouse did. `steps_lag`: the simulation runs and cannot keep up.
  void follow_mouse(bool steps_lag);
  /// Lets pictures that take longer than `smooth` [s] be drafts while the camera moves or steps lag.
  void allow_drafts(double smooth = 0.03) { draft_.allow(smooth); }
  /// True if the next picture is a draft, to be drawn again in full.
  bool draws_draft() const { return draft_.on(); }
  void toggle_slice(const Frame& frame);
  void toggle_range_lock();

  /// Selects the symbol of a layer, or the element, at a point of the view, from its top left corner, 0..1.
  void pick(const ShownWorld& world, const Vec2& cursor);
  /// Returns a grab of the material at a point of the view; empty if there is none.
  std::optional<Grab> grabbed_at(const ShownWorld& world, const Vec2& cursor);
  /// Returns a push of the material at a point of the view along the line of sight; empty if there is none.
  std::optional<Push> pushed_at(const ShownWorld& world, const Vec2& cursor) const;
  /// Returns the target of a grab at `target` after the mouse has come to a point of the view: on a plane parallel to
  /// the picture.
  Vec3 dragged_to(const Vec3& target, const Vec2& cursor) const;
  /// Returns the shot of the projectile tool at a point of the view. `scene`: the edited one.
  AimedShot aimed_at(const Frame& frame, const Scene& scene, const Vec2& cursor) const;
  /// Returns the flight of the shot being aimed; empty if there is none.
  ui::Aim aim(const Frame& frame, const Scene& scene) const;

  /// Adds camera, picture, legend and labels to the input of the panels.
  void describe(ui::EditorInput& input, const Scene& scene);

  /// Returns the last picture as passed to the renderer.
  const render::DrawScene& picture() const { return picture_; }
  bool has_legend() const { return !picture_.surface.scalar_style.quantity.empty(); }
  const EmbeddedDisplay& display() const { return display_; }
  std::optional<Vec2> range() const { return range_.range(); }
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
  PictureSettings settings(const Scene& built) const;
  ContentKey content_key(const WorldVersion& version) const;
  PictureKey picture_key(const WorldVersion& version) const;
  Eigen::Vector2i size() const;
  float aspect() const;
  render::Camera picture_camera() const { return render::widen(camera_, aspect()); }
  /// Draws the current picture in full or draft quality.
  void render(bool draft, std::optional<int> samples);
  /// Returns the drawn tet at a point of the view; invalid if there is none.
  TetId tet_at(const Frame& frame, const Vec2& cursor) const;
  /// Selects the symbol of a layer that a ray meets first, in front of `tet` if bodies are opaque, with its node or
  /// element. False if there is none.
  bool pick_symbol(const ShownMesh& shown, TetId tet, const render::Ray& ray);
  /// Returns the outline of the picked symbol.
  std::vector<ui::RegionLine> symbol_lines(const Frame& frame, const Scene& scene) const;
  render::Ray ray_at(const Vec2& cursor, int width, int height) const;
  /// Moves the camera along its line of sight and sideways until the picture shows all of the box.
  void look_at(const Eigen::AlignedBox3f& bounds);
  void move_slice(const ui::CameraMotion& motion);
  /// Moves the legend to a free corner, once for each camera, size and view, but not after a step.
  void place_legend(ui::Legend& legend, const ui::Fonts& fonts);

  ui::EditorState& state_;
  CopyOnWrite<EmbeddedDisplay> display_;
  SteadyRange range_;
  render::Camera camera_;
  render::Renderer renderer_;
  DraftQuality draft_;
  render::DrawScene picture_;
  ContentKey made_of_;  ///< input of the current picture
  PictureKey drawn_;
  PictureKey legend_placed_;  ///< picture for which the legend was placed
  ui::LegendCorner legend_corner_ = {};
  Vec3 grab_offset_ =
      Vec3::Zero();        ///< displacement of the grabbed point in the picture, as pieces are moved apart [m]
  bool laid_out_ = false;  ///< the size of the picture is known
};

}  // namespace griffith::app
