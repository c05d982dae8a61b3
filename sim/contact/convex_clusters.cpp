#include "sim/contact/convex_clusters.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace griffith {
namespace {

struct Plane {
  Vec3 normal, place;  ///< outward; a point of the plane [m]

  double height(const Vec3& point) const { return normal.dot(point - place); }
};

/// Tets on both sides of a plane.
struct Cut {
  std::vector<int> above, below;
  int crossed = std::numeric_limits<int>::max();  ///< number of tets on both sides
  double notch = 0;                               ///< greatest height of a point above the plane [m]

  bool divides() const { return !above.empty() && !below.empty(); }
};

/// Planes of the faces of some tets, outward from one of them.
struct Planes {
  std::vector<Plane> outer, inner;  ///< planes of faces that one tet has; that two share
};

class Clustering {
 public:
  Clustering(std::span<const Vec3> points, std::span<const std::array<int, 4>> tets, double tolerance)
      : points_(points), tets_(tets), tolerance_(tolerance) {}

  /// Adds the clusters of some tets, ascending, to `found`.
  void divide(const std::vector<int>& cluster, std::vector<std::vector<int>>& found) const {
    const Planes planes = planes_of(cluster);
    const auto is_notch = [&](const Plane& plane) { return highest(cluster, plane) > tolerance_; };
    if (cluster.size() == 1 || std::ranges::none_of(planes.outer, is_notch)) return found.push_back(cluster);
    Cut cut = best_cut(cluster, planes.outer, tolerance_);
    if (!cut.divides()) cut = best_cut(cluster, planes.inner, 0);
    if (!cut.divides()) cut = halves(cluster);
    divide(cut.below, found);
    divide(cut.above, found);
  }

 private:
  Planes planes_of(const std::vector<int>& cluster) const {
    std::map<std::array<int, 3>, std::pair<int, Plane>> faces;
    for (const int tet : cluster)
      for (int i = 0; i < 4; ++i) {
        auto& [count, plane] = faces[face(tet, i)];
        if (count++ == 0) plane = outward_plane(tet, i);
      }
    Planes planes;
    for (const auto& [corners, face] : faces) (face.first == 1 ? planes.outer : planes.inner).push_back(face.second);
    return planes;
  }

  /// Returns the cut by one of some planes that are notches deeper than `least` [m].
  Cut best_cut(const std::vector<int>& cluster, const std::vector<Plane>& planes, double least) const {
    Cut best;
    for (const Plane& plane : planes) {
      const double notch = highest(cluster, plane);
      if (notch <= least) continue;
      if (Cut cut = cut_by(cluster, plane, notch); cut.divides() && is_better(cut, best)) best = std::move(cut);
    }
    return best;
  }

  /// True if a cut is better than the best so far. The first of equal cuts counts, whatever rounding makes of their
  /// notches: equal shapes have equal clusters.
  bool is_better(const Cut& cut, const Cut& best) const {
    return cut.crossed == best.crossed ? cut.notch > best.notch + tolerance_ : cut.crossed < best.crossed;
  }

  /// Returns the corners of the face of a tet opposite to its corner i, ascending.
  std::array<int, 3> face(int tet, int i) const {
    const std::array<int, 4>& corners = tets_[tet];
    std::array<int, 3> face = {corners[(i + 1) % 4], corners[(i + 2) % 4], corners[(i + 3) % 4]};
    std::ranges::sort(face);
    return face;
  }

  Plane outward_plane(int tet, int i) const {
    const auto [a, b, c] = face(tet, i);
    const Vec3 normal = (points_[b] - points_[a]).cross(points_[c] - points_[a]).normalized();
    const bool is_outward = normal.dot(points_[tets_[tet][i]] - points_[a]) < 0;
    return {is_outward ? normal : -normal, points_[a]};
  }

  double highest(const std::vector<int>& cluster, const Plane& plane) const {
    double height = 0;
    for (const int tet : cluster)
      for (const int corner : tets_[tet]) height = std::max(height, plane.height(points_[corner]));
    return height;
  }

  Cut cut_by(const std::vector<int>& cluster, const Plane& plane, double notch) const {
    Cut cut{{}, {}, 0, notch};
    for (const int tet : cluster) {
      double low = 0, high = 0, sum = 0;
      for (const int corner : tets_[tet]) {
        const double height = plane.height(points_[corner]);
        low = std::min(low, height), high = std::max(high, height), sum += height;
      }
      if (low < -tolerance_ && high > tolerance_) ++cut.crossed;
      (sum > tolerance_ ? cut.above : cut.below).push_back(tet);  // centroids on the plane lie on one side of it
    }
    return cut;
  }

  /// Divides tets that no plane does, since they overlap or are flat.
  Cut halves(const std::vector<int>& cluster) const {
    const auto middle = cluster.begin() + static_cast<std::ptrdiff_t>(cluster.size() / 2);
    return {{middle, cluster.end()}, {cluster.begin(), middle}};
  }

  std::span<const Vec3> points_;
  std::span<const std::array<int, 4>> tets_;
  double tolerance_;
};

}  // namespace

std::vector<std::vector<int>> convex_clusters(std::span<const Vec3> points, std::span<const std::array<int, 4>> tets,
                                              double tolerance) {
  std::vector<int> all(tets.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::vector<int>> found;
  if (!all.empty()) Clustering(points, tets, tolerance).divide(all, found);
  return found;
}

}  // namespace griffith
