#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "app/picture/placed_tets.h"
#include "sim/core/monitor.h"
#include "sim/meshing/surface.h"
#include "sim/scene/scene.h"
#include "sim/splinters/splinters.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Everything that determines the shards of a body for which the scene has no splinters.
struct ShardOrder {
  TetSoup soup;                                         ///< the body at rest, in its initial placement
  std::variant<ShardPattern, RadialSplinters> pattern;  ///< radial around the first crack: panes and plates of glass
  std::optional<TriangleSurface> surface;  ///< surface shown by the body, in its placement; none: faces of its tets

  bool is_radial() const { return std::holds_alternative<RadialSplinters>(pattern); }
  bool operator==(const ShardOrder&) const = default;
};

/// Shards of a body.
struct BodyShards {
  ShardOrder order;
  CellPartition cells;  ///< in the placed rest space
  SplinterSet set;      ///< tets are numbered as those of the soup; walls end on the surface
};

/// Shards that were made before, for bodies that stay as they are.
using KnownShards = std::vector<std::shared_ptr<const BodyShards>>;

/// True if pictures may split a body into shards: it has no splinters of its own, and keeps its tets.
bool may_have_shards(const BodyDescription& body);

/// Place of the first crack of each scene body, in the placed rest space [m].
using FirstCracks = std::vector<std::optional<Vec3>>;
FirstCracks first_cracks(const Frame& frame, std::size_t scene_bodies);

/// Returns the shards of a body with the tets `soup`, taken from `known` if they are there. `first_crack`: of that
/// body, if known. Throws InputError if a surface cannot be read, Cancelled by the monitor.
std::shared_ptr<const BodyShards> body_shards(const Frame& frame, const Scene& scene, int scene_body,
                                              const TetSoup& soup, const std::optional<Vec3>& first_crack,
                                              const KnownShards& known, const Monitor& monitor);

}  // namespace griffith::app
