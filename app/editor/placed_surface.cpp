#include "app/editor/placed_surface.h"

#include <algorithm>

#include "sim/mesh/tet_mesh.h"
#include "sim/scene/body_pose.h"
#include "sim/world/setup/shape_mesh.h"

namespace griffith::app {
namespace {

/// Returns the faces that only one tet has.
std::vector<std::array<int, 3>> single_faces(const std::vector<std::array<int, 4>>& tets) {
  std::vector<std::array<int, 3>> faces, single;
  for (const std::array<int, 4>& tet : tets)
    for (const auto& corners : kTetFaces) {
      faces.push_back({tet[corners[0]], tet[corners[1]], tet[corners[2]]});
      std::ranges::sort(faces.back());
    }
  std::ranges::sort(faces);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool as_last = i > 0 && faces[i] == faces[i - 1];
    const bool as_next = i + 1 < faces.size() && faces[i] == faces[i + 1];
    if (!as_last && !as_next) single.push_back(faces[i]);
  }
  return single;
}

}  // namespace

Eigen::AlignedBox3d placed_box(const BodyDescription& body, const std::filesystem::path& folder) {
  const Pose pose = pose_of(body);
  Eigen::AlignedBox3d box;
  for (const Vec3& point : make_soup(body.shape, folder).points) box.extend(pose.to_world(point));
  return box;
}

ui::PlacedSurface placed_surface(const BodyDescription& body, const std::filesystem::path& folder) {
  const TetSoup soup = make_soup(body.shape, folder);
  const Pose pose = pose_of(body);
  ui::PlacedSurface surface;
  surface.triangles = single_faces(soup.tets);
  for (const Vec3& point : soup.points) surface.points.push_back(pose.to_world(point));
  for (const std::array<int, 3>& triangle : surface.triangles)
    for (const int point : triangle) surface.box.extend(surface.points[point]);
  return surface;
}

}  // namespace griffith::app
