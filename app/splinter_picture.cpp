#include "app/splinter_picture.h"

#include "app/natural_materials.h"

namespace griffith::app {
namespace {

render::EmbeddedStyle style_of(const Frame& frame, const SplinterFace& face) {
  const SplinterId splinter = frame.splinter_parts[static_cast<std::size_t>(face.part)].splinter;
  const bool inner = face.beyond >= 0;
  const Look look = face.matter == SplinterMatter::mortar ? Look::mortar : inner ? Look::inside : Look::outside;
  render::EmbeddedStyle style;
  style.material = look_index(frame.splinters[static_cast<std::size_t>(splinter.value)].scene_body, look);
  style.tet_face = inner ? -1 : face.tet_face;
  style.inner = inner;
  return style;
}

}  // namespace

std::shared_ptr<const render::EmbeddedMesh> splinter_mesh(const Frame& frame) {
  if (frame.splinters.empty()) return nullptr;
  auto mesh = std::make_shared<render::EmbeddedMesh>();
  mesh->corners.reserve(frame.splinter_corners.size());
  for (const SplinterFace& face : frame.splinter_faces) {
    const SplinterPart& part = frame.splinter_parts[static_cast<std::size_t>(face.part)];
    const std::int32_t style = style_of(frame, face).packed();
    if (face.beyond < 0) mesh->outer.push_back(static_cast<std::int32_t>(mesh->polygons.size()));
    mesh->polygons.push_back({face.first_corner, face.corners});
    for (int i = face.first_corner; i < face.first_corner + face.corners; ++i) {
      const SplinterCorner& corner = frame.splinter_corners[static_cast<std::size_t>(i)];
      mesh->corners.push_back(
          {corner.rest, corner.weights, corner.owner_weights, part.tet.value, face.part, part.splinter.value, style});
    }
  }
  return mesh;
}

render::EmbeddedSurface splinter_surface(const Frame& frame, std::shared_ptr<const render::EmbeddedMesh> mesh) {
  render::EmbeddedSurface surface;
  surface.mesh = std::move(mesh);
  for (const Vec3& position : frame.positions) surface.points.push_back(position.cast<float>());
  for (const auto& tet : frame.tets) surface.tets.push_back({tet[0].value, tet[1].value, tet[2].value, tet[3].value});
  for (std::size_t i = 0; i < frame.splinter_parts.size(); ++i) {
    const SplinterPart& part = frame.splinter_parts[i];
    const Splinter& splinter = frame.splinters[static_cast<std::size_t>(part.splinter.value)];
    surface.carriers.push_back(frame.attached_parts[i] ? part.tet.value : splinter.owner.value);
  }
  surface.opened.assign(frame.open_walls.begin(), frame.open_walls.end());
  return surface;
}

}  // namespace griffith::app
