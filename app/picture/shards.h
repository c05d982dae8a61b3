#pragma once

#include <array>
#include <span>
#include <vector>

#include "app/picture/body_shards.h"
#include "app/picture/skin.h"
#include "sim/core/monitor.h"
#include "sim/scene/scene.h"
#include "sim/splinters/splinters.h"
#include "sim/world/frame.h"

namespace griffith::app {

/// Splinters for pictures of bodies for which the scene has none, about one a tet, so that what breaks shows shards in
/// place of tets: long ones of wood, sectors and rings round the first crack of flat glass. The simulation knows
/// nothing of them. Bodies that are remeshed have none, nor have scenes of more than kMaxTets.
class Shards {
 public:
  static constexpr int kMaxTets = 10'000;

  Shards() = default;
  /// `frame`: before anything broke. Throws InputError when a surface cannot be read, Cancelled when the monitor says
  /// so.
  Shards(const Frame& frame, const Scene& scene, const Monitor& monitor = {});

  bool empty() const { return set_.splinters.empty(); }
  /// The splinters of the frame that they were made in, then all shards.
  const SplinterSet& set() const { return set_; }
  /// The surfaces that bodies were made from, parted by the shards of those that have them.
  const std::vector<Skin>& skins() const { return skins_; }
  /// What cracks have done to them. `frame`: any of the world's.
  SplinterState state(const Frame& frame) const;
  /// Whether some lie round another crack than the frame's first one. `frame`: any of the world's.
  bool are_behind(const Frame& frame, const Scene& scene) const;
  /// Makes those anew; whether there were any.
  bool follow(const Frame& frame, const Scene& scene);

 private:
  FirstCracks centers_in(const Frame& frame, const Scene& scene) const;
  void make(const Frame& frame, const Scene& scene, const Monitor& monitor);

  std::vector<std::array<TetId, 4>> neighbours_;  ///< of the first frame's tets
  std::vector<std::array<NodeId, 4>> tets_;       ///< their corners then
  FirstCracks centers_;                           ///< per scene body whose shards lie round its first crack
  std::vector<int> radial_;                       ///< these bodies
  SplinterSet set_;
  std::vector<Skin> skins_;
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
