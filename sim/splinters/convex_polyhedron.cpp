#include "sim/splinters/convex_polyhedron.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/mesh/tet_mesh.h"

namespace griffith {
namespace {

enum Side : signed char { kInside = -1, kOn = 0, kOutside = 1 };

/// Cut of a polyhedron by a plane.
class Cut {
 public:
  Cut(ConvexPolyhedron& polyhedron, const HalfSpace& inside, double tolerance) : polyhedron_(polyhedron) {
    const std::size_t most = 2 * polyhedron.corners.size();  // room for crossings
    distances_.reserve(most), sides_.reserve(most), polyhedron.corners.reserve(most);
    for (const Vec3& corner : polyhedron.corners) {
      const double distance = inside.distance(corner);
      distances_.push_back(distance);
      sides_.push_back(distance > tolerance ? kOutside : distance < -tolerance ? kInside : kOn);
    }
  }

  /// True if a corner of a face lies on this side.
  bool reaches(Side side) const {
    return std::ranges::any_of(polyhedron_.faces, [&](const PolyhedronFace& face) { return reaches(face, side); });
  }
  bool reaches(const PolyhedronFace& face, Side side) const {
    return std::ranges::any_of(face.corners, [&](int corner) { return sides_[corner] == side; });
  }
  bool lies_in_plane(const PolyhedronFace& face) const { return !reaches(face, kInside) && !reaches(face, kOutside); }

  void trim(PolyhedronFace& face) {
    std::vector<int> kept;
    kept.reserve(face.corners.size() + 1);
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const int corner = face.corners[i], next = face.corners[(i + 1) % face.corners.size()];
      if (sides_[corner] != kOutside) kept.push_back(corner);
      if (sides_[corner] * sides_[next] < 0) kept.push_back(crossing(std::min(corner, next), std::max(corner, next)));
    }
    face.corners = std::move(kept);
  }

  /// Returns the corners in the plane in order around `normal`.
  std::vector<int> cap(const Vec3& normal) const {
    std::vector<int> corners;
    for (const PolyhedronFace& face : polyhedron_.faces)
      for (const int corner : face.corners)
        if (sides_[corner] == kOn && std::ranges::find(corners, corner) == corners.end()) corners.push_back(corner);
    Vec3 center = Vec3::Zero();
    for (const int corner : corners) center += polyhedron_.corners[corner] / double(corners.size());
    const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
    const auto angle = [&](int corner) {
      const Vec3 arm = polyhedron_.corners[corner] - center;
      return std::atan2(arm.dot(y), arm.dot(x));
    };
    std::ranges::sort(corners, {}, angle);
    return corners;
  }

 private:
  struct Crossing {
    int a, b, corner;
  };

  /// Returns the crossing of the edge from a to b: one new corner for both faces at the edge.
  int crossing(int a, int b) {
    for (const Crossing& known : crossings_)
      if (known.a == a && known.b == b) return known.corner;
    const double fraction = distances_[a] / (distances_[a] - distances_[b]);
    const Vec3 point = polyhedron_.corners[a] + fraction * (polyhedron_.corners[b] - polyhedron_.corners[a]);
    crossings_.push_back({a, b, static_cast<int>(polyhedron_.corners.size())});
    polyhedron_.corners.push_back(point);
    sides_.push_back(kOn);
    distances_.push_back(0);
    return crossings_.back().corner;
  }

  ConvexPolyhedron& polyhedron_;
  std::vector<double> distances_;
  std::vector<Side> sides_;
  std::vector<Crossing> crossings_;
};

}  // namespace

ConvexPolyhedron tet_polyhedron(const std::array<Vec3, 4>& corners) {
  ConvexPolyhedron tet;
  tet.corners.assign(corners.begin(), corners.end());
  for (int face = 0; face < 4; ++face)
    tet.faces.push_back({{kTetFaces[face].begin(), kTetFaces[face].end()}, face, -1});
  return tet;
}

void clip(ConvexPolyhedron& polyhedron, const HalfSpace& inside, int wall, double tolerance) {
  const auto is_inside = [&](const Vec3& corner) { return inside.distance(corner) < -tolerance; };
  if (std::ranges::all_of(polyhedron.corners, is_inside)) return;  // as behind most walls
  Cut cut(polyhedron, inside, tolerance);
  if (!cut.reaches(kInside)) return polyhedron.faces.clear();
  bool capped = false;
  for (PolyhedronFace& face : polyhedron.faces) {
    if (cut.lies_in_plane(face)) {
      if (face.wall < 0) face.wall = wall;
      capped = true;
    }
  }
  if (!cut.reaches(kOutside)) return;
  for (PolyhedronFace& face : polyhedron.faces)
    if (cut.reaches(face, kOutside)) cut.trim(face);
  // A face that touched the plane from outside is now an edge or a corner.
  std::erase_if(polyhedron.faces, [&](const PolyhedronFace& face) { return face.corners.size() < 3; });
  if (capped) return;
  std::vector<int> cap = cut.cap(inside.normal);
  if (cap.size() >= 3) polyhedron.faces.push_back({std::move(cap), -1, wall});
}

Vec3 area_vector(const ConvexPolyhedron& polyhedron, const PolyhedronFace& face) {
  const Vec3& origin = polyhedron.corners[face.corners[0]];
  Vec3 doubled = Vec3::Zero();
  for (std::size_t i = 2; i < face.corners.size(); ++i)
    doubled += (polyhedron.corners[face.corners[i - 1]] - origin).cross(polyhedron.corners[face.corners[i]] - origin);
  return doubled / 2;
}

double volume(const ConvexPolyhedron& polyhedron) {
  if (polyhedron.empty()) return 0;
  const Vec3& origin = polyhedron.corners[polyhedron.faces[0].corners[0]];
  double tripled = 0;
  for (const PolyhedronFace& face : polyhedron.faces)
    tripled += area_vector(polyhedron, face).dot(polyhedron.corners[face.corners[0]] - origin);
  return tripled / 3;
}

std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, const HalfSpace& inside) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
    const double a = inside.distance(here), b = inside.distance(next);
    if (a <= 0) kept.push_back(here);
    if ((a < 0 && b > 0) || (a > 0 && b < 0)) kept.push_back(here + a / (a - b) * (next - here));
  }
  return kept;
}

Vec3 area_vector(const std::vector<Vec3>& polygon) {
  Vec3 doubled = Vec3::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i)
    doubled += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
  return doubled / 2;
}

}  // namespace griffith
