#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

#include "sim/contact/contact_world.h"
#include "sim/contact/convex_clusters.h"
#include "sim/contact/convex_pieces.h"
#include "sim/core/parallel.h"
#include "sim/core/sort_unique.h"
#include "sim/geometry/convex_hull.h"

namespace griffith {
namespace {

/// Fraction of the body's volume below which a part is not halved: it limits the number of parts.
constexpr double kSmallestFraction = 1.0 / 32;

/// Points of all pieces in sequence, now and at rest, and data of each piece at rest.
struct Body {
  std::span<const Vec3> points, rest_points;
  double fill;
  int max_corners;  ///< largest number of corners of a part
  std::vector<int> corners = {};
  std::vector<std::size_t> first = {0};  ///< per piece, and the end
  std::vector<double> volumes = {};
  std::vector<Vec3> centers = {};
  double volume = 0;

  void add(std::span<const int> piece, double piece_volume) {
    Vec3 center = Vec3::Zero();
    for (const int corner : piece) center += rest_points[corner] / static_cast<double>(piece.size());
    corners.insert(corners.end(), piece.begin(), piece.end());
    first.push_back(corners.size());
    volumes.push_back(piece_volume);
    centers.push_back(center);
    volume += piece_volume;
  }
};

/// Returns those of the body's points that some pieces use, each once.
std::vector<Vec3> used_points(const Body& body, std::span<const int> pieces, std::span<const Vec3> all_points) {
  std::vector<int> nodes;
  for (const int piece : pieces)
    nodes.insert(nodes.end(), body.corners.begin() + static_cast<std::ptrdiff_t>(body.first[piece]),
                 body.corners.begin() + static_cast<std::ptrdiff_t>(body.first[piece + 1]));
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::vector<Vec3> points;
  for (int node : nodes) points.push_back(all_points[node]);
  return points;
}

/// Keeps the points that are extreme in `count` directions, spread evenly over the sphere and stretched with the part
/// so that thin parts keep their edges.
std::vector<Vec3> extreme_points(const std::vector<Vec3>& points, int count) {
  if (points.size() <= static_cast<std::size_t>(count)) return points;
  Vec3 minimum = points[0], maximum = points[0];
  for (const Vec3& point : points) {
    minimum = minimum.cwiseMin(point);
    maximum = maximum.cwiseMax(point);
  }
  const Vec3 scale = (maximum - minimum).cwiseMax(1e-9).cwiseInverse();
  std::vector<bool> kept(points.size(), false);
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const Vec3 direction =
        Vec3(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z).cwiseProduct(scale);
    std::size_t best = 0;
    for (std::size_t j = 1; j < points.size(); ++j)
      if (points[j].dot(direction) > points[best].dot(direction)) best = j;
    kept[best] = true;
  }
  std::vector<Vec3> extreme;
  for (std::size_t j = 0; j < points.size(); ++j)
    if (kept[j]) extreme.push_back(points[j]);
  return extreme;
}

/// Sorts the pieces into the two halves of their extent's longest axis and returns where the second half starts.
std::size_t halve(const Body& body, std::span<int> pieces, const std::vector<Vec3>& points) {
  Vec3 minimum = points[0], maximum = points[0];
  for (const Vec3& point : points) {
    minimum = minimum.cwiseMin(point);
    maximum = maximum.cwiseMax(point);
  }
  int axis = 0;
  (maximum - minimum).maxCoeff(&axis);
  const double middle = (minimum[axis] + maximum[axis]) / 2;
  const auto second = std::stable_partition(pieces.begin(), pieces.end(),
                                            [&](int piece) { return body.centers[piece][axis] < middle; });
  const std::size_t half = second - pieces.begin();
  return half == 0 || half == pieces.size() ? pieces.size() / 2 : half;
}

/// True if some pieces, which have these points at rest, make one part.
bool are_one_part(const Body& body, std::span<const int> pieces, const std::vector<Vec3>& points) {
  if (pieces.size() == 1) return true;
  double volume = 0;
  for (int piece : pieces) volume += body.volumes[piece];
  return volume < kSmallestFraction * body.volume ||
         volume >= (body.fill - 1e-9) * convex_hull(extreme_points(points, body.max_corners)).volume;
}

/// Returns the parts of some pieces, whose order it changes.
std::vector<ConvexPart> parts_of(const Body& body, std::span<int> pieces) {
  constexpr std::size_t kTetCorners = 4, kWorthAThread = 32;
  const std::vector<Vec3> rest_points = used_points(body, pieces, body.rest_points);
  if (rest_points.size() <= kTetCorners || are_one_part(body, pieces, rest_points)) {
    const std::vector<Vec3> points = used_points(body, pieces, body.points);
    if (points.size() <= kTetCorners) return {points};
    return {convex_hull(extreme_points(points, body.max_corners)).corners};
  }
  const std::size_t half = halve(body, pieces, rest_points);
  std::array<std::vector<ConvexPart>, 2> parts;
  parallel_for(2, pieces.size() < kWorthAThread ? 2 : 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) parts[i] = parts_of(body, i == 0 ? pieces.first(half) : pieces.subspan(half));
  });
  std::move(parts[1].begin(), parts[1].end(), std::back_inserter(parts[0]));
  return std::move(parts[0]);
}

std::vector<ConvexPart> parts_of(const Body& body) {
  std::vector<int> all(body.volumes.size());
  std::iota(all.begin(), all.end(), 0);
  return all.empty() ? std::vector<ConvexPart>() : parts_of(body, all);
}

/// Returns the parts of a few tets: clusters that are convex up to a small fraction of the body's extent at rest.
std::vector<ConvexPart> clustered_parts(std::span<const Vec3> points, std::span<const Vec3> rest_points,
                                        std::span<const std::array<int, 4>> tets, int max_corners) {
  constexpr double kConcavity = 0.005;
  Eigen::AlignedBox3d box;
  for (const Vec3& point : rest_points) box.extend(point);
  std::vector<ConvexPart> parts;
  for (const std::vector<int>& cluster : convex_clusters(rest_points, tets, kConcavity * box.sizes().maxCoeff())) {
    std::vector<int> corners;
    for (const int tet : cluster) corners.insert(corners.end(), tets[tet].begin(), tets[tet].end());
    sort_unique(corners);
    ConvexPart& part = parts.emplace_back();
    for (const int corner : corners) part.push_back(points[corner]);
    if (cluster.size() > 1) part = convex_hull(extreme_points(part, max_corners)).corners;
  }
  return parts;
}

double tet_volume(std::span<const Vec3> points, const std::array<int, 4>& tet) {
  const auto& [a, b, c, d] = tet;
  const Vec3& origin = points[a];
  return std::abs((points[b] - origin).cross(points[c] - origin).dot(points[d] - origin)) / 6;
}

}  // namespace

std::vector<ConvexPart> convex_parts(std::span<const Vec3> points, std::span<const Vec3> rest_points,
                                     std::span<const std::array<int, 4>> tets, double fill, int max_corners) {
  constexpr std::size_t kFew = 64;
  assert(fill > 0 && fill <= 1 && points.size() == rest_points.size());
  if (tets.size() <= kFew) return clustered_parts(points, rest_points, tets, max_corners);
  Body body = {points, rest_points, fill, max_corners};
  for (const auto& tet : tets) body.add(tet, tet_volume(rest_points, tet));
  return parts_of(body);
}

std::vector<ConvexPart> convex_parts(std::span<const Vec3> points, std::span<const Vec3> rest_points,
                                     std::span<const ConvexPiece> pieces, double fill) {
  assert(fill > 0 && fill <= 1 && points.size() == rest_points.size());
  Body body = {points, rest_points, fill, kMaxPartCorners};
  for (const ConvexPiece& piece : pieces) body.add(piece.corners, piece.volume);
  return parts_of(body);
}

}  // namespace griffith
