#pragma once

#include <optional>
#include <string>

#include "app/picture/draw_scene_from_frame.h"
#include "renderer/renderer.h"
#include "sim/timeline/timeline.h"

namespace griffith::app {

/// Largest distance between two frames of one scene.
struct Gap {
  double distance = 0;        ///< distance of a node's two positions [m]
  int scene_body = -1;        ///< scene body of the node; -1: no difference
  Vec3 place = Vec3::Zero();  ///< position of the node in the first frame [m]
};
Gap largest_gap(const Frame& a, const Frame& b);

/// First difference of two runs with the same start.
struct Divergence {
  std::int64_t step = 0;
  double time = 0;  ///< [s]
  Gap gap;          ///< gap in that step
};
/// Returns the first difference of the branches of two timelines; empty if one continues the other as far as both go.
/// Recomputes steps to find it.
std::optional<Divergence> first_divergence(const Timeline& a, const Timeline& b);

/// Another branch of a timeline at the shown step, with its picture. Needs a current OpenGL context.
class ComparedBranch {
 public:
  /// `display`: of the timeline's world.
  ComparedBranch(Timeline timeline, int branch, EmbeddedDisplay display);

  int branch() const { return timeline_.branch(); }
  const Timeline& timeline() const { return timeline_; }
  Frame frame() const { return timeline_.world().frame(); }
  /// Goes to the shown step and finds its first difference from `shown`. Beyond the branch's recorded end its steps are
  /// computed, for a fraction of a drawn frame at a time.
  void follow(const Timeline& shown);
  /// True if it has not reached the shown step yet.
  bool is_behind(const Timeline& shown) const { return timeline_.step() < shown.step(); }
  /// Describes the place and time of the first difference from the shown branch, and the current distance.
  std::string difference(const Timeline& shown, const Scene& scene) const;

  void draw(const Scene& scene, const ViewSettings& view, const std::optional<Vec2>& range, const HiddenBodies& hidden,
            const render::Camera& camera, const render::RenderOptions& options);
  unsigned color_texture() const { return renderer_.color_texture(); }

 private:
  Timeline timeline_;
  EmbeddedDisplay display_;
  render::Renderer renderer_;
  std::optional<Divergence> divergence_;
  int shown_branch_ = -1;          ///< branch of the last comparison
  std::int64_t compared_to_ = -1;  ///< last step that both had at that time
};

}  // namespace griffith::app
