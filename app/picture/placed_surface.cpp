#include "app/picture/placed_surface.h"

#include "sim/core/file_path.h"
#include "sim/scene/body_pose.h"

namespace griffith::app {

bool shows_surface(const BodyDescription& body) {
  return std::holds_alternative<SurfaceShape>(body.shape) && !body.splinters && !body.remeshing;
}

TriangleSurface placed_surface(const Scene& scene, const BodyDescription& body) {
  const SurfaceShape& shape = std::get<SurfaceShape>(body.shape);
  TriangleSurface surface = read_surface(file_path(scene.folder, shape.path), shape.scale);
  const Pose pose = pose_of(body);
  for (Vec3& point : surface.points) point = pose.to_world(point);
  for (std::array<Vec3, 3>& normals : surface.normals)
    for (Vec3& normal : normals) normal = pose.rotation * normal;
  return surface;
}

}  // namespace griffith::app
