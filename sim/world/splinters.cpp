#include "sim/splinters/splinters.h"

#include "sim/world/phases.h"

namespace griffith {

void place_splinters(WorldState& world, int scene_body, const RestBody& body) {
  const std::optional<SplinterPattern>& pattern = world.scene.bodies[scene_body].splinters;
  if (!pattern) return;
  const TetMesh mesh = build_mesh(body.soup);
  Eigen::AlignedBox3d bounds;
  for (const Vec3& position : mesh.rest_positions) bounds.extend(position);
  const std::string where = "#/bodies/" + std::to_string(scene_body) + "/splinters";
  const CellPartition cells = make_cells(*pattern, bounds, world.scene.folder, where);
  append(world.splinters, make_splinters(mesh, cells), body.range.first_tet, scene_body);
  world.splinter_state = intact_state(world.splinters);
}

}  // namespace griffith
