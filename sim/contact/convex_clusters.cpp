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
  bool operator<(const Cut& other) const { return std::pair(crossed, -notch) < std::pair(other.crossed, -other.notch); }
};

class Clustering {
 public:
  Clustering(std::span<const Vec3> points, std::span<const std::array<int, 4>> tets, double tolerance)
      : points_(points), tets_(tets), tolerance_(tolerance) {}

  /// Adds the clusters of some tets, ascending, to `found`.
  void divide(const std::vector<int>& cluster, std::vector<std::vector<int>>& found) const {
    Cut best;
    bool is_convex = true;
    for (const Plane& plane : surface(cluster)) {
      const double notch = highest(cluster, plane);
      if (notch <= tolerance_) continue;
      is_convex = false;
      if (Cut cut = cut_by(cluster, plane, notch); cut.divides() && cut < best) best = std::move(cut);
    }
    if (is_convex) return found.push_back(cluster);
    if (!best.divides()) best = halves(cluster);
    divide(best.below, found);
    divide(best.above, found);
  }

 private:
  /// Returns the planes of the faces that only one of some tets has.
  std::vector<Plane> surface(const std::vector<int>& cluster) const {
    std::map<std::array<int, 3>, std::pair<int, Plane>> faces;
    for (const int tet : cluster)
      for (int i = 0; i < 4; ++i) {
        auto& [count, plane] = faces[face(tet, i)];
        if (count++ == 0) plane = outward_plane(tet, i);
      }
    std::vector<Plane> planes;
    for (const auto& [corners, face] : faces)
      if (face.first == 1) planes.push_back(face.second);
    return planes;
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
      (sum > 0 ? cut.above : cut.below).push_back(tet);
    }
    return cut;
  }

  /// Cuts at the median of the centroids along an axis, for tets that no plane of their surface divides.
  Cut halves(const std::vector<int>& cluster) const {
    Eigen::AlignedBox3d box;
    for (const int tet : cluster) box.extend(sum_of_corners(tet));
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    std::vector<int> sorted = cluster;
    std::ranges::stable_sort(sorted, {}, [&](int tet) { return sum_of_corners(tet)[axis]; });
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    Cut cut{{middle, sorted.end()}, {sorted.begin(), middle}};
    std::ranges::sort(cut.above), std::ranges::sort(cut.below);
    return cut;
  }

  Vec3 sum_of_corners(int tet) const {
    const auto [a, b, c, d] = tets_[tet];
    return points_[a] + points_[b] + points_[c] + points_[d];
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
