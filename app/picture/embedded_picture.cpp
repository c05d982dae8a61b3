#include "app/picture/embedded_picture.h"

#include <algorithm>
#include <array>

#include "app/picture/carried_points.h"
#include "app/picture/natural_materials.h"
#include "sim/splinters/carried_corner.h"

namespace griffith::app {
namespace {

render::EmbeddedStyle style_of(const Frame& frame, const SplinterFace& face, const std::array<int, 4>& order) {
  const SplinterId splinter = frame.splinters.parts[static_cast<std::size_t>(face.part)].splinter;
  const bool inner = face.beyond >= 0;
  render::EmbeddedStyle style;
  style.material = look_index(frame.splinters.splinters[splinter].scene_body, look_of(face));
  if (!inner) style.tet_face = static_cast<int>(std::find(order.begin(), order.end(), face.tet_face) - order.begin());
  style.inner = inner;
  return style;
}

}  // namespace

void add_splinters(const Frame& frame, std::span<const std::array<int, 4>> orders,
                   std::span<const std::uint8_t> skinned, render::EmbeddedMesh& mesh) {
  mesh.corners.reserve(frame.splinters.corners.size());
  for (const SplinterFace& face : frame.splinters.faces) {
    const SplinterPart& part = frame.splinters.parts[static_cast<std::size_t>(face.part)];
    const auto& [owner, scene_body, first_part, parts, volume] = frame.splinters.splinters[part.splinter];
    const std::array<int, 4>& order = orders[part.tet];
    const std::array<int, 4>& owner_order = orders[owner];
    const std::int32_t style = style_of(frame, face, order).packed();
    if (face.beyond < 0 && !skinned[scene_body]) mesh.outer.push_back(static_cast<std::int32_t>(mesh.polygons.size()));
    mesh.polygons.push_back({face.first_corner, face.corners});
    for (int i = face.first_corner; i < face.first_corner + face.corners; ++i) {
      const SplinterCorner& corner = frame.splinters.corners[static_cast<std::size_t>(i)];
      mesh.corners.push_back({corner.rest, ordered(corner.weights, order), ordered(corner.owner_weights, owner_order),
                              part.tet.index(), face.part, part.splinter.index(), style});
    }
  }
}

void add_carriers(const Frame& frame, std::vector<std::int32_t>& carriers) {
  for (int part = 0; part < static_cast<int>(frame.splinters.parts.size()); ++part)
    carriers.push_back(
        carrier(frame.splinters.splinters, frame.splinters.parts, frame.splinters.attached, part).index());
}

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
