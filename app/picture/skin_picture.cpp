#include "app/picture/skin_picture.h"

#include "app/picture/carried_points.h"
#include "app/picture/natural_materials.h"

namespace griffith::app {
namespace {

Weights single(const std::array<double, 4>& weights) {
  return Weights(float(weights[0]), float(weights[1]), float(weights[2]), float(weights[3]));
}

/// Returns a normal in the form of the renderer: its products with the edges from the first point of its tet.
render::CarriedNormal carried_normal(const Frame& frame, const Vec3& normal, TetId tet,
                                     const std::array<int, 4>& order) {
  const auto place = [&](int i) -> const Vec3& {
    return frame.nodes.rest_positions[frame.elements.tets[tet][order[i]]];
  };
  Vec3 products;
  for (int i = 0; i < 3; ++i) products[i] = normal.dot(place(i + 1) - place(0));
  return render::CarriedNormal(products.cast<float>());
}

}  // namespace

void add_skin(const Frame& frame, std::span<const std::array<int, 4>> orders, const Skin& skin, int first_part,
              int first_piece, render::EmbeddedMesh& mesh) {
  render::EmbeddedStyle style;
  style.material = look_index(skin.scene_body, Look::outside);
  style.textured = skin.has_uvs;
  for (int polygon = 0; polygon < skin.polygons(); ++polygon) {
    mesh.outer.push_back(static_cast<std::int32_t>(mesh.polygons.size()));
    mesh.polygons.push_back(
        {static_cast<std::int32_t>(mesh.corners.size()), static_cast<std::int32_t>(skin.polygon(polygon).size())});
    for (const SkinCorner& corner : skin.polygon(polygon)) {
      const auto [tet, owner] = corner.part;
      render::EmbeddedCorner drawn{corner.rest.cast<float>(),
                                   ordered(single(corner.weights), orders[tet]),
                                   ordered(single(corner.owner_weights), orders[owner]),
                                   tet.index(),
                                   first_part++,
                                   first_piece++,
                                   style.packed()};
      drawn.normal = carried_normal(frame, corner.normal, tet, orders[tet]);
      drawn.other_normal = carried_normal(frame, corner.normal, owner, orders[owner]);
      drawn.uv = corner.uv.cast<float>();
      mesh.corners.push_back(drawn);
    }
  }
}

}  // namespace griffith::app
