#include "app/picture/skin.h"

#include "app/picture/placed_tets.h"
#include "sim/core/file_path.h"
#include "sim/meshing/embedding.h"
#include "sim/scene/body_pose.h"

namespace griffith::app {
namespace {

TriangleSurface placed_surface(const Scene& scene, const BodyDescription& body) {
  const SurfaceShape& shape = std::get<SurfaceShape>(body.shape);
  TriangleSurface surface = read_surface(file_path(scene.folder, shape.path), shape.scale);
  const Pose pose = pose_of(body);
  for (Vec3& point : surface.points) point = pose.to_world(point);
  for (std::array<Vec3, 3>& normals : surface.normals)
    for (Vec3& normal : normals) normal = pose.rotation * normal;
  return surface;
}

Skin make_skin(const Frame& frame, const Scene& scene, int scene_body) {
  const TriangleSurface surface = placed_surface(scene, scene.bodies[scene_body]);
  const PlacedTets placed = placed_tets(frame, scene_body);
  const Embedding embedding = embed(surface, placed.soup);
  const std::vector<std::array<Vec3, 3>> normals = smooth_normals(surface);
  Skin skin{scene_body, !surface.uvs.empty(), {}};
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const int index = surface.triangles[t][i];
      const EmbeddedPoint& point = embedding.points[index];
      const EmbeddedTriangle& triangle = embedding.triangles[t];
      SkinCorner& corner = skin.corners.emplace_back();
      corner.part = {placed.tets[point.tet], placed.tets[triangle.tet]};
      corner.weights = point.weights;
      corner.triangle_weights = triangle.weights[i];
      corner.rest = surface.points[index];
      corner.normal = normals[t][i];
      if (skin.has_uvs) corner.uv = surface.uvs[t][i];
    }
  return skin;
}

}  // namespace

TetId skin_carrier(const Frame& frame, const SkinPart& part) {
  return frame.elements.bodies[part.tet] == frame.elements.bodies[part.triangle_tet] ? part.tet : part.triangle_tet;
}

Vec3 skin_position(const Frame& frame, const SkinCorner& corner) {
  const TetId tet = skin_carrier(frame, corner.part);
  const std::array<double, 4>& weights = tet == corner.part.tet ? corner.weights : corner.triangle_weights;
  Vec3 position = Vec3::Zero();
  for (int i = 0; i < 4; ++i) position += weights[i] * frame.nodes.positions[frame.elements.tets[tet][i]];
  return position;
}

std::vector<Skin> make_skins(const Frame& frame, const Scene& scene) {
  std::vector<Skin> skins;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const BodyDescription& body = scene.bodies[i];
    if (std::holds_alternative<SurfaceShape>(body.shape) && !body.splinters && !body.remeshing)
      skins.push_back(make_skin(frame, scene, static_cast<int>(i)));
  }
  return skins;
}

}  // namespace griffith::app
