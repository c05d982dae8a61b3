#include "sim/contact/hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace griffith::contact {
namespace {

using Loop = std::vector<int>;
/// Face on the left of each directed edge.
using FaceAt = std::map<std::pair<int, int>, int>;

/// Returns a vector of twice the area.
Vec3 doubled_area(const std::vector<Vec3>& corners, const Loop& loop) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < loop.size(); ++i)
    sum += (corners[loop[i - 1]] - corners[loop[0]]).cross(corners[loop[i]] - corners[loop[0]]);
  return sum;
}

FaceAt face_at_edges(const std::vector<Loop>& loops) {
  FaceAt face_at;
  for (std::size_t face = 0; face < loops.size(); ++face)
    for (std::size_t i = 0; i < loops[face].size(); ++i)
      face_at[{loops[face][i], loops[face][(i + 1) % loops[face].size()]}] = static_cast<int>(face);
  return face_at;
}

/// Returns the edges between faces; none unless every edge has two.
std::vector<Hull::Edge> edges_of(const std::vector<Loop>& loops) {
  const FaceAt face_at = face_at_edges(loops);
  std::vector<Hull::Edge> edges;
  for (const auto& [ends, face] : face_at) {
    const auto other = face_at.find({ends.second, ends.first});
    if (other == face_at.end()) return {};
    if (ends.first < ends.second) edges.push_back({ends.first, ends.second, face, other->second});
  }
  return edges;
}

/// Joins nearly coplanar faces of a flat side, as rounding or slight deformation makes them, with the narrow ones at
/// its rim.
class FlatSides {
 public:
  FlatSides(const std::vector<Vec3>& corners, const std::vector<Loop>& loops, double size)
      : corners_(corners), loops_(loops), face_at_(face_at_edges(loops)), side_of_(loops.size(), -1), size_(size) {}

  std::vector<Loop> joined() {
    std::vector<int> order(loops_.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::ranges::greater(),
                             [&](int face) { return doubled_area(corners_, loops_[face]).norm(); });
    std::vector<Loop> sides;
    for (const int face : order) {
      if (side_of_[face] >= 0) continue;
      const std::vector<int> faces = faces_of_side(face);
      if (const std::optional<Loop> outline = outline_of(faces)) {
        sides.push_back(*outline);
      } else {
        for (const int part : faces) sides.push_back(loops_[part]);
      }
    }
    return sides;
  }

 private:
  /// Returns the faces around one that lie in its plane.
  std::vector<int> faces_of_side(int seed) {
    std::vector<int> faces = {seed};
    side_of_[seed] = seed;
    const Vec3 normal = doubled_area(corners_, loops_[seed]).normalized();
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Loop& loop = loops_[faces[i]];
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const auto next = face_at_.find({loop[(k + 1) % loop.size()], loop[k]});
        if (next == face_at_.end() || side_of_[next->second] >= 0 || !lies_in(next->second, normal, loops_[seed][0]))
          continue;
        side_of_[next->second] = seed;
        faces.push_back(next->second);
      }
    }
    return faces;
  }

  bool lies_in(int face, const Vec3& normal, int origin) const {
    constexpr double kAlike = 1 - 1e-4;  // the cosine
    const Vec3 area = doubled_area(corners_, loops_[face]);
    return (normal.dot(area.normalized()) > kAlike || is_narrow(face, area.norm())) &&
           std::ranges::all_of(loops_[face], [&](int corner) {
             return std::abs(normal.dot(corners_[corner] - corners_[origin])) < kFlat * size_;
           });
  }

  /// True for a face as narrow as a side may be uneven, between corners nearly in a line: its normal says nothing.
  bool is_narrow(int face, double doubled_area) const {
    double longest = 0;
    for (const int from : loops_[face])
      for (const int to : loops_[face]) longest = std::max(longest, (corners_[to] - corners_[from]).norm());
    return doubled_area < kFlat * size_ * longest;
  }

  /// Returns the outline of some faces if it is a single one.
  std::optional<Loop> outline_of(const std::vector<int>& faces) const {
    std::map<int, int> next;
    std::size_t count = 0;
    for (const int face : faces)
      for (std::size_t k = 0; k < loops_[face].size(); ++k) {
        const int from = loops_[face][k], to = loops_[face][(k + 1) % loops_[face].size()];
        const auto other = face_at_.find({to, from});
        if (other != face_at_.end() && side_of_[other->second] == side_of_[face]) continue;
        next[from] = to;
        ++count;
      }
    if (next.size() != count || count < 3) return {};
    Loop outline;
    for (int corner = next.begin()->first; outline.empty() || corner != outline[0]; corner = next.at(corner)) {
      outline.push_back(corner);
      if (outline.size() > count || !next.contains(corner)) return {};
    }
    return outline.size() == count ? std::optional(outline) : std::nullopt;
  }

  static constexpr double kFlat = 1e-3;  // share of the size
  const std::vector<Vec3>& corners_;
  const std::vector<Loop>& loops_;
  FaceAt face_at_;
  std::vector<int> side_of_;  // per face: the first of its side
  double size_;
};

/// True if a face has an area, and so a normal.
bool has_normal(const std::vector<Vec3>& corners, const Loop& loop, double size) {
  return doubled_area(corners, loop).norm() > 1e-9 * size * size;
}

/// Returns a face with no corner above it, also with its rounded normal.
Hull::Face face_of(const std::vector<Vec3>& corners, const Loop& loop, int first) {
  const Vec3 normal = doubled_area(corners, loop).normalized();
  double offset = normal.dot(corners[loop[0]]);
  for (const Vec3& corner : corners) offset = std::max(offset, normal.dot(corner));
  return {normal, offset, first, static_cast<int>(loop.size())};
}

}  // namespace

Hull::Hull(const ConvexHull& hull) : corners(hull.corners) {
  Eigen::AlignedBox3d box;
  for (const Vec3& corner : corners) {
    box.extend(corner);
    center += corner / static_cast<double>(corners.size());
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t lane = i % simd::kDoubleLanes;
    if (lane == 0) fours_.emplace_back();
    for (std::size_t rest = lane; rest < simd::kDoubleLanes; ++rest) {
      fours_.back().x[rest] = corners[i].x();
      fours_.back().y[rest] = corners[i].y();
      fours_.back().z[rest] = corners[i].z();
    }
  }
  box_center = box.center();
  box_half = 0.5 * box.sizes();
  const double size = box.diagonal().norm();
  if (!(hull.volume > 1e-9 * size * size * size)) return;
  const std::vector<Loop> sides = FlatSides(corners, hull.faces, size).joined();
  if (!std::ranges::all_of(sides, [&](const Loop& loop) { return has_normal(corners, loop, size); })) return;
  edges = edges_of(sides);
  if (edges.empty()) return;
  for (const Loop& loop : sides) {
    faces.push_back(face_of(corners, loop, static_cast<int>(loops.size())));
    loops.insert(loops.end(), loop.begin(), loop.end());
  }
  inner_radius = size;
  for (const Face& face : faces) inner_radius = std::min(inner_radius, face.offset - face.normal.dot(center));
}

double Hull::lowest(const Vec3& direction) const {
  const double x = direction.x(), y = direction.y(), z = direction.z();
  simd::DoubleLanes least = x * fours_[0].x + y * fours_[0].y + z * fours_[0].z;
  for (std::size_t i = 1; i < fours_.size(); ++i) {
    const simd::DoubleLanes along = x * fours_[i].x + y * fours_[i].y + z * fours_[i].z;
    least = along < least ? along : least;
  }
  const double first = std::min(least[0], least[1]), second = std::min(least[2], least[3]);
  return std::min(first, second);
}

}  // namespace griffith::contact
