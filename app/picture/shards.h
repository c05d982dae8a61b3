#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/picture/placed_tets.h"
#include "sim/core/monitor.h"
#include "sim/scene/scene.h"
#include "sim/splinters/splinters.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// The shards of a body for which the scene has no splinters.
struct BodyShards {
  int scene_body = 0;
  PlacedTets placed;    ///< the body at rest
  CellPartition cells;  ///< in the placed rest space
  SplinterSet set;      ///< tets are numbered as those of `placed`; walls end on the surface that the body shows
};

/// Splinters for pictures of bodies for which the scene has none, one a tet and about as large, so that what breaks
/// shows shards in place of tets. Wood's are long. The simulation knows nothing of them. Bodies that are remeshed have
/// none, nor have scenes of more than kMaxTets.
class Shards {
 public:
  static constexpr int kMaxTets = 30'000;

  Shards() = default;
  /// `frame`: before anything broke. Throws InputError when a surface cannot be read, Cancelled when the monitor says
  /// so.
  Shards(const Frame& frame, const Scene& scene, const Monitor& monitor = {});

  std::span<const BodyShards> bodies() const { return bodies_; }
  bool empty() const { return bodies_.empty(); }
  /// The splinters of the frame that they were made in, then all shards.
  const SplinterSet& set() const { return set_; }
  /// What cracks have done to them. `frame`: any of the world's.
  SplinterState state(const Frame& frame) const;

 private:
  std::vector<BodyShards> bodies_;
  SplinterSet set_;
  std::vector<std::array<TetId, 4>> neighbours_;  ///< of the first frame's tets
};

/// A frame whose splinters are the scene's and the shards, if there are any. `frame` and `shards` must outlive it.
class FrameWithShards {
 public:
  FrameWithShards(const Frame& frame, const Shards& shards);
  FrameWithShards(const FrameWithShards&) = delete;
  FrameWithShards& operator=(const FrameWithShards&) = delete;

  const Frame& frame() const { return frame_; }

 private:
  SplinterState state_;
  Frame frame_;
};

}  // namespace griffith::app
