#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include "sim/contact/contact_world.h"
#include "sim/contact/convex_hull.h"

namespace griffith {
namespace {

using Tets = std::span<const std::array<int, 4>>;

/// More corners than this cost time at every contact and are not seen in one.
constexpr int kMaxCorners = 42;
/// A part with less than this share of the body's volume is not halved any more: it bounds the number of parts.
constexpr double kSmallestShare = 1.0 / 32;

struct Body {
  std::span<const Vec3> points;
  Tets tets;
  double fill;
  double volume = 0;
};

double tet_volume(const Body& body, int tet) {
  const auto& [a, b, c, d] = body.tets[tet];
  const Vec3& origin = body.points[a];
  return std::abs((body.points[b] - origin).cross(body.points[c] - origin).dot(body.points[d] - origin)) / 6;
}

Vec3 centroid(const Body& body, int tet) {
  const auto& [a, b, c, d] = body.tets[tet];
  return (body.points[a] + body.points[b] + body.points[c] + body.points[d]) / 4;
}

/// The points used by some tets, each once.
std::vector<Vec3> used_points(const Body& body, std::span<const int> tets) {
  std::vector<int> nodes;
  for (int tet : tets) nodes.insert(nodes.end(), body.tets[tet].begin(), body.tets[tet].end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::vector<Vec3> points;
  for (int node : nodes) points.push_back(body.points[node]);
  return points;
}

/// Keeps the corners that are extreme in `kMaxCorners` directions, spread evenly over the sphere and stretched with
/// the part so that thin parts keep their edges.
ConvexPart simplified(const std::vector<Vec3>& corners) {
  if (corners.size() <= kMaxCorners) return corners;
  Vec3 minimum = corners[0], maximum = corners[0];
  for (const Vec3& corner : corners) {
    minimum = minimum.cwiseMin(corner);
    maximum = maximum.cwiseMax(corner);
  }
  const Vec3 scale = (maximum - minimum).cwiseMax(1e-9).cwiseInverse();
  std::vector<bool> kept(corners.size(), false);
  for (int i = 0; i < kMaxCorners; ++i) {
    const double z = 1 - (2 * i + 1.0) / kMaxCorners;
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const Vec3 direction =
        Vec3(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z).cwiseProduct(scale);
    std::size_t best = 0;
    for (std::size_t j = 1; j < corners.size(); ++j)
      if (corners[j].dot(direction) > corners[best].dot(direction)) best = j;
    kept[best] = true;
  }
  ConvexPart part;
  for (std::size_t j = 0; j < corners.size(); ++j)
    if (kept[j]) part.push_back(corners[j]);
  return part;
}

/// Sorts the tets into the two halves of their extent's longest axis and returns where the second half starts.
std::size_t halve(const Body& body, std::span<int> tets, const std::vector<Vec3>& points) {
  Vec3 minimum = points[0], maximum = points[0];
  for (const Vec3& point : points) {
    minimum = minimum.cwiseMin(point);
    maximum = maximum.cwiseMax(point);
  }
  int axis = 0;
  (maximum - minimum).maxCoeff(&axis);
  const double middle = (minimum[axis] + maximum[axis]) / 2;
  const auto second =
      std::stable_partition(tets.begin(), tets.end(), [&](int tet) { return centroid(body, tet)[axis] < middle; });
  const std::size_t half = second - tets.begin();
  return half == 0 || half == tets.size() ? tets.size() / 2 : half;
}

void split(const Body& body, std::span<int> tets, std::vector<ConvexPart>& parts) {
  const std::vector<Vec3> points = used_points(body, tets);
  if (tets.size() == 1) {
    parts.push_back(points);
    return;
  }
  const ConvexHull hull = convex_hull(points);
  double volume = 0;
  for (int tet : tets) volume += tet_volume(body, tet);
  const bool filled = volume >= (body.fill - 1e-9) * hull.volume;
  if (filled || volume < kSmallestShare * body.volume) {
    parts.push_back(simplified(hull.corners));
    return;
  }
  const std::size_t half = halve(body, tets, points);
  split(body, tets.first(half), parts);
  split(body, tets.subspan(half), parts);
}

}  // namespace

std::vector<ConvexPart> convex_parts(std::span<const Vec3> points, Tets tets, double fill) {
  assert(fill > 0 && fill <= 1);
  std::vector<int> all(tets.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<ConvexPart> parts;
  Body body = {points, tets, fill};
  for (int tet : all) body.volume += tet_volume(body, tet);
  if (!all.empty()) split(body, all, parts);
  return parts;
}

}  // namespace griffith
