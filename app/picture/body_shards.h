#pragma once

#include <array>
#include <optional>
#include <span>

#include "app/picture/placed_tets.h"
#include "sim/core/monitor.h"
#include "sim/meshing/surface.h"
#include "sim/scene/scene.h"
#include "sim/splinters/splinters.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Shards of a body for which the scene has no splinters.
struct BodyShards {
  int scene_body = 0;
  PlacedTets placed;    ///< the body at rest
  CellPartition cells;  ///< in the placed rest space
  SplinterSet set;      ///< tets are numbered as those of `placed`; walls end on `surface`
  std::optional<TriangleSurface> surface =
      {};                  ///< surface shown by the body, in its placement; none: faces of its tets
  bool is_radial = false;  ///< arranged around the body's first crack: panes and plates of glass
};

/// True if pictures may split a body into shards: it has no splinters of its own, and keeps its tets.
bool may_have_shards(const BodyDescription& body);

/// Place of the first crack of each scene body, in the placed rest space [m].
using FirstCracks = std::vector<std::optional<Vec3>>;
FirstCracks first_cracks(const Frame& frame, std::size_t scene_bodies);

/// Makes the shards of a body. `first_crack`: of that body, if known. Throws InputError if a surface cannot be read,
/// Cancelled by the monitor.
BodyShards make_body_shards(const Frame& frame, const Scene& scene, int scene_body, PlacedTets placed,
                            const std::optional<Vec3>& first_crack, const Monitor& monitor);

}  // namespace griffith::app
