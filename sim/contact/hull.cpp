#include "sim/contact/hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>

namespace griffith::contact {
namespace {

/// Newell's normal, as long as twice the area.
Vec3 doubled_area(const std::vector<Vec3>& corners, const std::vector<int>& loop) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < loop.size(); ++i)
    sum += (corners[loop[i - 1]] - corners[loop[0]]).cross(corners[loop[i]] - corners[loop[0]]);
  return sum;
}

/// Whether a face has an area by which it tells which way it looks.
bool has_normal(const std::vector<Vec3>& corners, const std::vector<int>& loop, double size) {
  return doubled_area(corners, loop).norm() > 1e-9 * size * size;
}

Hull::Face face_of(const std::vector<Vec3>& corners, const std::vector<int>& loop, int first) {
  const Vec3 normal = doubled_area(corners, loop).normalized();
  double offset = 0;
  for (const int corner : loop) offset += normal.dot(corners[corner]) / static_cast<double>(loop.size());
  return {normal, offset, first, static_cast<int>(loop.size())};
}

/// The edges between faces; none unless every edge has two.
std::vector<Hull::Edge> edges_of(const std::vector<std::vector<int>>& loops) {
  std::map<std::pair<int, int>, int> face_at;
  for (std::size_t face = 0; face < loops.size(); ++face)
    for (std::size_t i = 0; i < loops[face].size(); ++i)
      face_at[{loops[face][i], loops[face][(i + 1) % loops[face].size()]}] = static_cast<int>(face);
  std::vector<Hull::Edge> edges;
  for (const auto& [ends, face] : face_at) {
    const auto other = face_at.find({ends.second, ends.first});
    if (other == face_at.end()) return {};
    if (ends.first < ends.second) edges.push_back({ends.first, ends.second, face, other->second});
  }
  return edges;
}

}  // namespace

Hull::Hull(const ConvexHull& hull) : corners(hull.corners) {
  Eigen::AlignedBox3d box;
  for (const Vec3& corner : corners) {
    box.extend(corner);
    center += corner / static_cast<double>(corners.size());
  }
  box_center = box.center();
  box_half = 0.5 * box.sizes();
  const double size = box.diagonal().norm();
  if (!(hull.volume > 1e-9 * size * size * size)) return;
  if (!std::ranges::all_of(hull.faces, [&](const auto& loop) { return has_normal(corners, loop, size); })) return;
  edges = edges_of(hull.faces);
  if (edges.empty()) return;
  for (const std::vector<int>& loop : hull.faces) {
    faces.push_back(face_of(corners, loop, static_cast<int>(loops.size())));
    loops.insert(loops.end(), loop.begin(), loop.end());
  }
}

}  // namespace griffith::contact
