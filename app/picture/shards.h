#pragma once

#include <array>
#include <span>
#include <vector>

#include "app/picture/body_shards.h"
#include "app/picture/skin.h"
#include "sim/core/monitor.h"
#include "sim/scene/scene.h"
#include "sim/splinters/splinters.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Splinters for pictures of bodies for which the scene has none, about one per tet, so that fracture shows shards
/// instead of tets: long ones in wood, sectors and rings around the first crack of flat glass. The simulation does not
/// know them. Remeshed bodies and scenes of more than kMaxTets have none.
class Shards {
 public:
  static constexpr int kMaxTets = 10'000;

  Shards() = default;
  /// `frame`: before any fracture. Takes shards of unchanged bodies from `known`. Throws InputError if a surface cannot
  /// be read, Cancelled by the monitor.
  Shards(const Frame& frame, const Scene& scene, const Monitor& monitor = {}, const KnownShards& known = {});

  bool empty() const { return set_.splinters.empty(); }
  /// Returns the splinters of the initial frame, followed by all shards.
  const SplinterSet& set() const { return set_; }
  /// Returns the original surfaces of bodies, split by their shards if they have any.
  const std::vector<Skin>& skins() const { return skins_; }
  /// Returns the shards of each body that has any.
  const KnownShards& bodies() const { return bodies_; }
  /// Returns the state of the shards after the cracks of `frame`, any frame of the world.
  SplinterState state(const Frame& frame) const;
  /// True if some shards lie around another crack than the frame's first one. `frame`: any of the world's.
  bool are_behind(const Frame& frame, const Scene& scene) const;
  /// Remakes those shards, and no others. True if there were any.
  bool follow(const Frame& frame, const Scene& scene);

 private:
  FirstCracks centers_in(const Frame& frame, const Scene& scene) const;
  void make(const Frame& frame, const Scene& scene, const Monitor& monitor, const KnownShards& known);

  std::vector<std::array<TetId, 4>> neighbors_;  ///< neighbors of the first frame's tets
  std::vector<std::array<NodeId, 4>> tets_;      ///< corners of the first frame's tets
  FirstCracks centers_;                          ///< per scene body whose shards lie around its first crack
  std::vector<int> radial_;                      ///< indices of these bodies
  KnownShards bodies_;
  SplinterSet set_;
  std::vector<Skin> skins_;
};

/// A frame whose splinters are the scene's and the shards. `frame` and `shards` must outlive it.
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
