#pragma once

#include <vector>

#include "renderer/camera.h"
#include "renderer/image.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// One of many pictures whose mean is a poster: through a point of the lens, at a time while the shutter is open.
struct Exposure {
  Eigen::Vector2f lens;   ///< point of the unit disc
  Eigen::Vector2f pixel;  ///< offset of the picture [pixels], -0.5..0.5
  double time = 0;        ///< as a part of the shutter's time, -1..0
};

/// Number of exposures of a poster, and of their times.
inline constexpr int kPosterExposures = 48, kPosterTimes = 12;
/// Fraction of a time step for which the shutter of a poster is open: half a turn.
inline constexpr double kShutter = 0.5;

/// Returns exposures in the order of their times, of which there are `times`; `count` is a multiple of it. They are the
/// same in every run.
std::vector<Exposure> exposures(int count, int times);

/// Returns the radius of a poster's lens [m]: a part of what is in view, and no larger than a camera's.
float lens_radius(const render::Camera& camera);

/// Moves the camera to the exposure's point of its lens. Everything as far as the target stays in its place, but for
/// the offset of the pixel. `height`: of the picture [pixels].
render::Camera exposed(const render::Camera& camera, const Exposure& exposure, int height);

/// A frame as it is some time later, if everything keeps its velocity. `frame` must outlive it.
class LaterFrame {
 public:
  /// `time`: may be negative [s].
  LaterFrame(const Frame& frame, double time);
  const Frame& frame() const { return moved_; }

 private:
  Frame moved_;
  std::vector<Vec3> positions_;
  std::vector<ProjectileView> projectiles_;
};

/// Sum of pictures in linear light.
class ImageSum {
 public:
  void add(const render::Image& image);
  /// Returns the mean of at least one picture.
  render::Image mean() const;

 private:
  int width_ = 0, height_ = 0, count_ = 0;
  std::vector<float> sums_;
};

}  // namespace griffith::app
