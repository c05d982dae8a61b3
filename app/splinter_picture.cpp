#include "app/splinter_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/natural_materials.h"

namespace griffith::app {
namespace {

/// The corners of a tet by their rest positions. Summed in this order, a point of a face comes out the same to the bit
/// from both tets at the face, so that no background shines through between their polygons. Cracks do not change it: a
/// copy of a node has its rest position.
std::array<int, 4> summation_order(const Frame& frame, const std::array<NodeId, 4>& tet) {
  std::array<int, 4> order = {0, 1, 2, 3};
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const Vec3& at_a = frame.rest_positions[static_cast<std::size_t>(tet[static_cast<std::size_t>(a)].value)];
    const Vec3& at_b = frame.rest_positions[static_cast<std::size_t>(tet[static_cast<std::size_t>(b)].value)];
    return std::lexicographical_compare(at_a.begin(), at_a.end(), at_b.begin(), at_b.end());
  });
  return order;
}

std::vector<std::array<int, 4>> summation_orders(const Frame& frame) {
  std::vector<std::array<int, 4>> orders;
  for (const auto& tet : frame.tets) orders.push_back(summation_order(frame, tet));
  return orders;
}

/// Weights in that order, without what is rounding alone.
render::Weights ordered(const Weights& weights, const std::array<int, 4>& order) {
  constexpr float kRounding = 1e-7f;
  render::Weights result;
  for (int i = 0; i < 4; ++i) {
    const float weight = weights[order[static_cast<std::size_t>(i)]];
    result[i] = std::abs(weight) < kRounding ? 0 : weight;
  }
  return result;
}

render::EmbeddedStyle style_of(const Frame& frame, const SplinterFace& face, const std::array<int, 4>& order) {
  const SplinterId splinter = frame.splinter_parts[static_cast<std::size_t>(face.part)].splinter;
  const bool inner = face.beyond >= 0;
  const Look look = face.matter == SplinterMatter::mortar ? Look::mortar : inner ? Look::inside : Look::outside;
  render::EmbeddedStyle style;
  style.material = look_index(frame.splinters[static_cast<std::size_t>(splinter.value)].scene_body, look);
  if (!inner) style.tet_face = static_cast<int>(std::find(order.begin(), order.end(), face.tet_face) - order.begin());
  style.inner = inner;
  return style;
}

}  // namespace

std::shared_ptr<const render::EmbeddedMesh> splinter_mesh(const Frame& frame) {
  if (frame.splinters.empty()) return nullptr;
  auto mesh = std::make_shared<render::EmbeddedMesh>();
  const std::vector<std::array<int, 4>> orders = summation_orders(frame);
  mesh->corners.reserve(frame.splinter_corners.size());
  for (const SplinterFace& face : frame.splinter_faces) {
    const SplinterPart& part = frame.splinter_parts[static_cast<std::size_t>(face.part)];
    const TetId owner = frame.splinters[static_cast<std::size_t>(part.splinter.value)].owner;
    const std::array<int, 4>& order = orders[static_cast<std::size_t>(part.tet.value)];
    const std::array<int, 4>& owner_order = orders[static_cast<std::size_t>(owner.value)];
    const std::int32_t style = style_of(frame, face, order).packed();
    if (face.beyond < 0) mesh->outer.push_back(static_cast<std::int32_t>(mesh->polygons.size()));
    mesh->polygons.push_back({face.first_corner, face.corners});
    for (int i = face.first_corner; i < face.first_corner + face.corners; ++i) {
      const SplinterCorner& corner = frame.splinter_corners[static_cast<std::size_t>(i)];
      mesh->corners.push_back({corner.rest, ordered(corner.weights, order), ordered(corner.owner_weights, owner_order),
                               part.tet.value, face.part, part.splinter.value, style});
    }
  }
  return mesh;
}

render::EmbeddedSurface splinter_surface(const Frame& frame, std::shared_ptr<const render::EmbeddedMesh> mesh) {
  render::EmbeddedSurface surface;
  surface.mesh = std::move(mesh);
  for (const Vec3& position : frame.positions) surface.points.push_back(position.cast<float>());
  for (const auto& tet : frame.tets) {
    std::array<std::int32_t, 4>& ordered_tet = surface.tets.emplace_back();
    const std::array<int, 4> order = summation_order(frame, tet);
    for (std::size_t i = 0; i < 4; ++i) ordered_tet[i] = tet[static_cast<std::size_t>(order[i])].value;
  }
  for (std::size_t i = 0; i < frame.splinter_parts.size(); ++i) {
    const SplinterPart& part = frame.splinter_parts[i];
    const Splinter& splinter = frame.splinters[static_cast<std::size_t>(part.splinter.value)];
    surface.carriers.push_back(frame.attached_parts[i] ? part.tet.value : splinter.owner.value);
  }
  surface.opened.assign(frame.open_walls.begin(), frame.open_walls.end());
  return surface;
}

}  // namespace griffith::app
