#include "sim/world/setup/place_splinters.h"

#include <algorithm>
#include <cstdio>

#include "sim/core/error.h"
#include "sim/mesh/topology.h"
#include "sim/splinters/splinters.h"
#include "sim/world/state/world_state.h"

namespace griffith {
namespace {

/// Cells from a file need not fill the body.
void require_covered(const TetMesh& mesh, const SplinterSet& splinters, const std::string& where) {
  constexpr double kFraction = 1e-6;
  double volume = 0;
  for (const TetId tet : IdRange<TetId>(0, mesh.tet_count())) volume += rest_volume(mesh, tet);
  const Uncovered uncovered = uncovered_part(mesh, splinters);
  if (uncovered.volume <= kFraction * volume) return;
  char text[160];
  std::snprintf(text, sizeof text, "leave %.3g %% of the body without a cell, most near (%.4g, %.4g, %.4g)",
                100 * uncovered.volume / volume, uncovered.place.x(), uncovered.place.y(), uncovered.place.z());
  throw InputError(where, text, "let the outer cells reach beyond the body's surface, and fill gaps between cells");
}

/// Checks for a whole scene the limits of each body.
void require_few_in_all(const SplinterSet& splinters, const CellPartition& cells, const std::string& where) {
  if (static_cast<double>(splinters.splinters.size() + cells.size()) > kMaxSplinterCells)
    throw InputError(where, "brings the scene to more than 2 million splinters",
                     "take larger ones, or fewer bodies that have any");
}

}  // namespace

void place_splinters(Model& model, int scene_body, const RestBody& body, const Monitor& monitor) {
  const std::optional<SplinterPattern>& pattern = model.scene.bodies[scene_body].splinters;
  if (!pattern) return;
  Eigen::AlignedBox3d bounds;
  for (const Vec3& position : body.mesh.rest_positions) bounds.extend(position);
  const std::string where = "#/bodies/" + std::to_string(scene_body) + "/splinters";
  const CellPartition cells = make_cells(*pattern, bounds, model.scene.folder, where);
  require_few_in_all(model.splinters, cells, where);
  const SplinterSet splinters = make_splinters(body.mesh, cells, monitor);
  require_covered(body.mesh, splinters, where);
  append(model.splinters, splinters, body.range.first_tet, scene_body);
}

void close_splinters(Model& model) {
  const auto collides = [](const BodyDescription& body) { return body.collision == CollisionShape::splinters; };
  if (std::ranges::any_of(model.scene.bodies, collides)) model.splinter_hulls = hull_corners(model.splinters);
}

}  // namespace griffith
