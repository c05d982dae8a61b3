#include "sim/meshing/self_intersection.h"

#include <algorithm>
#include <optional>

#include "sim/core/parallel.h"
#include "sim/meshing/triangle_tree.h"

namespace griffith {
namespace {

/// Two neighbors overlap if the sine of the angle between them is smaller.
constexpr double kFoldedSine = 1e-6;
/// Tolerance of coplanar triangles, relative to the longest edge.
constexpr double kPlaneTolerance = 1e-9;
constexpr int kMaxPairs = 100;  ///< limit per triangle, with those of higher numbers

using CornerPositions = std::array<Vec3, 3>;

/// Returns the point where the segment from p to q crosses the interior of a triangle.
std::optional<Vec3> crossing(const Vec3& p, const Vec3& q, const CornerPositions& triangle, double tolerance) {
  const Vec3 normal = area_vector(triangle).normalized();
  const double above = normal.dot(p - triangle[0]), below = normal.dot(q - triangle[0]);
  if (!(std::min(above, below) < -tolerance && std::max(above, below) > tolerance)) return std::nullopt;
  const Vec3 place = p + above / (above - below) * (q - p);
  for (int i = 0; i < 3; ++i) {
    const Vec3 edge = triangle[(i + 1) % 3] - triangle[i];
    if (normal.dot(edge.cross(place - triangle[i])) <= tolerance * edge.norm()) return std::nullopt;
  }
  return place;
}

/// True if two coplanar triangles with this normal overlap: no edge of either separates them (separating axes).
bool overlap_in_plane(const CornerPositions& a, const CornerPositions& b, const Vec3& normal, double tolerance) {
  for (const CornerPositions* corners : {&a, &b})
    for (int i = 0; i < 3; ++i) {
      const Vec3 axis = normal.cross((*corners)[(i + 1) % 3] - (*corners)[i]).normalized();
      const std::array of_a = {axis.dot(a[0]), axis.dot(a[1]), axis.dot(a[2])};
      const std::array of_b = {axis.dot(b[0]), axis.dot(b[1]), axis.dot(b[2])};
      const auto [low_a, high_a] = std::minmax_element(of_a.begin(), of_a.end());
      const auto [low_b, high_b] = std::minmax_element(of_b.begin(), of_b.end());
      if (*high_a <= *low_b + tolerance || *high_b <= *low_a + tolerance) return false;
    }
  return true;
}

double longest_edge(const CornerPositions& corners) {
  return std::max(
      {(corners[1] - corners[0]).norm(), (corners[2] - corners[1]).norm(), (corners[0] - corners[2]).norm()});
}

/// Returns a common point of two triangles beyond the `shared` corners, which come first in both.
std::optional<Vec3> common_point(const CornerPositions& a, const CornerPositions& b, int shared) {
  const Vec3 normal = area_vector(a).normalized();
  const double tolerance = kPlaneTolerance * std::max(longest_edge(a), longest_edge(b));
  if (shared == 2) {  // neighbors: either folded onto each other, or without an intersection
    const Vec3 edge = (a[1] - a[0]).normalized();
    const Vec3 to_a = (a[2] - a[0]) - edge * edge.dot(a[2] - a[0]);
    const Vec3 to_b = (b[2] - b[0]) - edge * edge.dot(b[2] - b[0]);
    const bool folded = to_a.dot(to_b) > 0 && to_a.cross(to_b).norm() < kFoldedSine * to_a.norm() * to_b.norm();
    return folded ? std::optional(Vec3((a[0] + a[1]) / 2)) : std::nullopt;
  }
  double farthest = 0;
  for (const Vec3& corner : b) farthest = std::max(farthest, std::abs(normal.dot(corner - a[0])));
  if (farthest <= tolerance)
    return overlap_in_plane(a, b, normal, tolerance) ? std::optional(Vec3((a[0] + a[1] + a[2]) / 3)) : std::nullopt;
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3;
    if (shared == 1 && (i == 0 || next == 0)) continue;  // an edge at the shared corner ends in the other's border
    if (const auto place = crossing(a[i], a[next], b, tolerance)) return place;
    if (const auto place = crossing(b[i], b[next], a, tolerance)) return place;
  }
  return std::nullopt;
}

/// Moves the corners of both triangles to the front, in the same order. Returns their number.
int align_shared(std::array<int, 3>& a, std::array<int, 3>& b) {
  int shared = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = shared; j < 3; ++j) {
      if (a[i] != b[j]) continue;
      std::swap(a[shared], a[i]);
      std::swap(b[shared], b[j]);
      ++shared;
      break;
    }
  return shared;
}

std::optional<Vec3> common_point(const TriangleSurface& surface, int first, int second) {
  auto a = surface.triangles[first], b = surface.triangles[second];
  const int shared = align_shared(a, b);
  if (shared == 3) return std::nullopt;  // a duplicate, counted separately
  const auto corners = [&](const auto& t) {
    return CornerPositions{surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]};
  };
  return common_point(corners(a), corners(b), shared);
}

}  // namespace

SelfIntersections find_self_intersections(const TriangleSurface& surface) {
  const TriangleTree tree(surface);
  const int count = static_cast<int>(surface.triangles.size());
  std::vector<SelfIntersections> found(count);
  parallel_for(count, 64, [&](int begin, int end) {
    for (int triangle = begin; triangle < end; ++triangle) {
      Eigen::AlignedBox3d box;
      for (const Vec3& corner : corners_of(surface, triangle)) box.extend(corner);
      SelfIntersections& mine = found[triangle];
      mine.all_known = tree.visit_box(box, [&, triangle](int other) {
        if (other <= triangle) return true;
        const auto place = common_point(surface, triangle, other);
        if (!place) return true;
        if (mine.pairs++ == 0 || other < mine.first[1]) mine.first = {triangle, other}, mine.place = *place;
        return mine.pairs < kMaxPairs;
      });
    }
  });
  SelfIntersections sum;
  for (const SelfIntersections& mine : found) {
    if (sum.pairs == 0 && mine.pairs > 0) sum.first = mine.first, sum.place = mine.place;
    sum.pairs += mine.pairs;
    sum.all_known = sum.all_known && mine.all_known;
  }
  return sum;
}

}  // namespace griffith
