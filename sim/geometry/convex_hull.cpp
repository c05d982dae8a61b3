#include "sim/geometry/convex_hull.h"

#include <LinearMath/btConvexHullComputer.h>

#include <Eigen/Cholesky>
#include <algorithm>

namespace griffith {
namespace {

std::vector<std::vector<int>> face_polygons(const btConvexHullComputer& computer) {
  std::vector<std::vector<int>> faces(computer.faces.size());
  for (int face = 0; face < computer.faces.size(); ++face) {
    const btConvexHullComputer::Edge* first = &computer.edges[computer.faces[face]];
    const btConvexHullComputer::Edge* edge = first;
    do {
      faces[face].push_back(edge->getSourceVertex());
      edge = edge->getNextEdgeOfFace();
    } while (edge != first);
  }
  return faces;
}

/// Returns twice the polygon's area times its outward unit normal.
Vec3 area_vector(const std::vector<Vec3>& corners, const std::vector<int>& face) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < face.size(); ++i)
    sum += (corners[face[i - 1]] - corners[face[0]]).cross(corners[face[i]] - corners[face[0]]);
  return sum;
}

/// Sums volume and area. Reverses the faces if all of them face inward.
void measure(ConvexHull& hull) {
  for (const std::vector<int>& face : hull.faces) {
    const Vec3 doubled_area = area_vector(hull.corners, face);
    hull.volume += doubled_area.dot(hull.corners[face[0]] - hull.corners[0]) / 6;
    hull.area += doubled_area.norm() / 2;
  }
  if (hull.volume >= 0) return;
  hull.volume = -hull.volume;
  for (std::vector<int>& face : hull.faces) std::reverse(face.begin(), face.end());
}

}  // namespace

ConvexHull convex_hull(std::span<const Vec3> points) {
  if (points.empty()) return {};
  btConvexHullComputer computer;
  computer.compute(points.front().data(), sizeof(Vec3), static_cast<int>(points.size()), 0, 0);
  ConvexHull hull;
  for (int i = 0; i < computer.original_vertex_index.size(); ++i)
    hull.corners.push_back(points[computer.original_vertex_index[i]]);
  hull.faces = face_polygons(computer);
  measure(hull);
  return hull;
}

std::vector<Vec3> shrunken_corners(const ConvexHull& hull, double distance) {
  // The shift d of a corner minimizes the sum of (n·d + distance)² over the normals n of its faces.
  std::vector<Mat3> matrices(hull.corners.size(), Mat3::Zero());
  std::vector<Vec3> sums(hull.corners.size(), Vec3::Zero());
  for (const std::vector<int>& face : hull.faces) {
    const Vec3 doubled_area = area_vector(hull.corners, face);
    const double length = doubled_area.norm();
    if (length < 1e-12 * hull.area) continue;
    const Vec3 normal = doubled_area / length;
    for (int corner : face) {
      matrices[corner] += normal * normal.transpose();
      sums[corner] += normal;
    }
  }
  std::vector<Vec3> corners = hull.corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Mat3 regularized = matrices[i] + 1e-9 * Mat3::Identity();
    corners[i] -= regularized.ldlt().solve(distance * sums[i]);
  }
  return corners;
}

}  // namespace griffith
