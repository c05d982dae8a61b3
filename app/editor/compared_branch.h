#pragma once

#include <optional>
#include <string>

#include "app/picture/draw_scene_from_frame.h"
#include "renderer/renderer.h"
#include "sim/timeline/timeline.h"

namespace griffith::app {

/// How far two frames of one scene are apart, where that is most.
struct Gap {
  double distance = 0;        ///< of a node's places [m]
  int scene_body = -1;        ///< the node's; -1: all are in the same place
  Vec3 place = Vec3::Zero();  ///< of the node in the first frame [m]
};
Gap largest_gap(const Frame& a, const Frame& b);

/// Where two runs from one start differ first.
struct Divergence {
  std::int64_t step = 0;
  double time = 0;  ///< [s]
  Gap gap;          ///< in that step
};
/// Between the branches that the two timelines are in; nothing where one goes on as the other, as far as both go. Makes
/// steps again to find out.
std::optional<Divergence> first_divergence(const Timeline& a, const Timeline& b);

/// Another branch of a timeline, at the step that is shown, and its picture. Needs a current OpenGL context.
class ComparedBranch {
 public:
  /// `display`: of the timeline's world.
  ComparedBranch(Timeline timeline, int branch, EmbeddedDisplay display);

  int branch() const { return timeline_.branch(); }
  const Timeline& timeline() const { return timeline_; }
  Frame frame() const { return timeline_.world().frame(); }
  /// Goes to the step, or to the branch's last one, and finds out where it parted from `shown`.
  void follow(const Timeline& shown);
  /// Where and when it differs first from what is shown, and how far it is off now.
  std::string difference(const Timeline& shown, const Scene& scene) const;

  void draw(const Scene& scene, const ViewSettings& view, const std::optional<Vec2>& range, const HiddenBodies& hidden,
            const render::Camera& camera, const render::RenderOptions& options);
  unsigned color_texture() const { return renderer_.color_texture(); }

 private:
  Timeline timeline_;
  EmbeddedDisplay display_;
  render::Renderer renderer_;
  std::optional<Divergence> divergence_;
  int shown_branch_ = -1;          ///< with which it was compared
  std::int64_t compared_to_ = -1;  ///< the last step that both were known to have
};

}  // namespace griffith::app
