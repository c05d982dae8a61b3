#include "app/picture/splinter_picture.h"

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

}  // namespace griffith::app
