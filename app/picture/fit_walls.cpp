#include "app/picture/fit_walls.h"

#include <algorithm>
#include <cmath>

#include "sim/mesh/topology.h"
#include "sim/meshing/tet_locator.h"
#include "sim/meshing/triangle_tree.h"
#include "sim/splinters/convex_polyhedron.h"

namespace griffith::app {
namespace {

/// A corner of a wall being moved to the surface.
struct WallCorner {
  Vec3 place;
  bool starts_rim = false;  ///< the edge from it to the next corner lies on the boundary of the tets
};

double mean_edge(const TriangleSurface& surface) {
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles) sum += (surface.points[a] - surface.points[b]).norm();
  return sum / static_cast<double>(surface.triangles.size());
}

class WallFitter {
 public:
  WallFitter(const SplinterSet& set, const TetSoup& soup, const TriangleSurface& surface)
      : set_(set), mesh_(build_mesh(soup)), locator_(soup), tree_(surface), spacing_(mean_edge(surface)) {}

  /// Returns the corners of the fitted face with their carriers.
  std::vector<SplinterCorner> corners(const SplinterFace& face) const {
    const auto old = std::span(set_.corners).subspan(face.first_corner, face.corners);
    std::vector<WallCorner> outline = outline_of(face, old);
    const auto on_rim = [](const WallCorner& corner) { return corner.starts_rim; };
    if (face.beyond < 0 || std::ranges::none_of(outline, on_rim) || !has_plane(outline))
      return {old.begin(), old.end()};
    begin_opposite_to_rim(outline);
    std::vector<SplinterCorner> fitted;
    for (const Vec3& place : fitted_outline(outline, reach_of(set_.parts[face.part].tet)))
      fitted.push_back(carried(face, place));
    return fitted;
  }

 private:
  std::vector<WallCorner> outline_of(const SplinterFace& face, std::span<const SplinterCorner> corners) const {
    const std::array<TetId, 4>& neighbors = mesh_.neighbors[set_.parts[face.part].tet];
    std::vector<WallCorner> outline;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      constexpr float kTolerance = 1e-5f;
      const SplinterCorner &corner = corners[i], &next = corners[(i + 1) % corners.size()];
      bool on_rim = false;
      for (int f = 0; f < 4; ++f)
        on_rim |= !neighbors[f].valid() && corner.weights[f] < kTolerance && next.weights[f] < kTolerance;
      outline.push_back({corner.rest.cast<double>(), on_rim});
    }
    return outline;
  }

  /// True if the outline has a well-defined plane; slivers do not.
  static bool has_plane(const std::vector<WallCorner>& outline) {
    constexpr double kThinnest = 1e-3;  // area over the square of the length
    std::vector<Vec3> places;
    double length = 0;
    for (const WallCorner& corner : outline) {
      if (!places.empty()) length += (corner.place - places.back()).norm();
      places.push_back(corner.place);
    }
    return area_vector(places).norm() > kThinnest * length * length;
  }

  /// Rotates the outline to begin opposite to the rim: polygons are drawn as fans from the first corner, which must see
  /// all of the rim.
  static void begin_opposite_to_rim(std::vector<WallCorner>& outline) {
    const auto distance_to_rim = [&](const WallCorner& corner) {
      double minimum = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < outline.size(); ++i) {
        if (!outline[i].starts_rim) continue;
        const Vec3 &a = outline[i].place, &b = outline[(i + 1) % outline.size()].place;
        minimum = std::min(minimum, (b - a).cross(corner.place - a).norm() / (b - a).norm());
      }
      return minimum;
    };
    std::ranges::rotate(outline, std::ranges::max_element(outline, {}, distance_to_rim));
  }

  std::vector<Vec3> fitted_outline(const std::vector<WallCorner>& outline, double reach) const {
    constexpr double kMostSegments = 8;
    std::vector<Vec3> places;
    for (const WallCorner& corner : outline) places.push_back(corner.place);
    const Vec3 normal = area_vector(places).normalized();
    std::vector<Vec3> fitted;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec3 &a = outline[i].place, &b = outline[(i + 1) % outline.size()].place;
      const bool after_rim = outline[(i + outline.size() - 1) % outline.size()].starts_rim;
      fitted.push_back(outline[i].starts_rim || after_rim ? on_surface(a, normal, reach) : a);
      if (!outline[i].starts_rim) continue;
      const double segments = std::clamp(std::ceil((b - a).norm() / spacing_), 1.0, kMostSegments);
      for (double s = 1; s < segments; ++s) fitted.push_back(on_surface(a + s / segments * (b - a), normal, reach));
    }
    return fitted;
  }

  /// Returns the point of the surface nearest to a point of a wall, in the wall's plane, by alternating projections.
  /// Returns the point itself if they do not meet within `reach`.
  Vec3 on_surface(const Vec3& place, const Vec3& normal, double reach) const {
    constexpr int kRounds = 6;
    Vec3 point = place;
    for (int i = 0; i < kRounds; ++i) {
      point = tree_.nearest(point).point;
      point -= normal.dot(point - place) * normal;
    }
    return (point - place).norm() <= reach ? point : place;
  }

  /// Returns the largest distance from the boundary of a tet at which the surface still belongs to the tet [m].
  double reach_of(TetId tet) const {
    constexpr double kShare = 0.4;  // fraction of its longest edge
    double longest = 0;
    for (const NodeId a : mesh_.tets[tet])
      for (const NodeId b : mesh_.tets[tet])
        longest = std::max(longest, (mesh_.rest_positions[a] - mesh_.rest_positions[b]).norm());
    return kShare * longest;
  }

  SplinterCorner carried(const SplinterFace& face, const Vec3& place) const {
    const SplinterPart& part = set_.parts[face.part];
    const auto weights = [&](TetId tet) {
      const std::array<double, 4> in_tet = locator_.weights_in(tet.index(), place);
      return Eigen::Map<const Eigen::Vector4d>(in_tet.data()).cast<float>().eval();
    };
    return {place.cast<float>(), weights(part.tet), weights(set_.splinters[part.splinter].owner)};
  }

  const SplinterSet& set_;
  TetMesh mesh_;
  TetLocator locator_;
  TriangleTree tree_;
  double spacing_;  ///< spacing of the surface's points [m]
};

}  // namespace

void fit_walls(SplinterSet& splinters, const TetSoup& soup, const TriangleSurface& surface) {
  const WallFitter fitter(splinters, soup, surface);
  std::vector<SplinterFace> faces = splinters.faces;
  std::vector<SplinterCorner> corners;
  for (SplinterFace& face : faces) {
    const std::vector<SplinterCorner> fitted = fitter.corners(face);
    face.first_corner = static_cast<int>(corners.size());
    face.corners = static_cast<int>(fitted.size());
    corners.insert(corners.end(), fitted.begin(), fitted.end());
  }
  splinters.faces = std::move(faces);
  splinters.corners = std::move(corners);
}

}  // namespace griffith::app
