#include "sim/explicit/sharp_edge.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace griffith::explicit_dynamics {
namespace {

/// Fraction of an edge at each end that belongs to its corner.
constexpr double kCorner = 0.02;

/// Squared sine of the angle between edges that count as parallel.
constexpr double kParallel = 1e-4;

/// Returns the place on the segment from `start` along `way` nearest to a point, 0..1.
double nearest_along(const Vec3& start, const Vec3& way, const Vec3& point) {
  return std::clamp(way.dot(point - start) / way.squaredNorm(), 0.0, 1.0);
}

/// Returns the distance of two segments whose lines are nearest at these places [m] (Ericson 2005, 5.1.9).
double distance_between(const SharpEdge& first, const SharpEdge& second, std::array<double, 2> along) {
  const Vec3 way_of_first = first.ends[1] - first.ends[0], way_of_second = second.ends[1] - second.ends[0];
  along[0] = std::clamp(along[0], 0.0, 1.0);
  along[1] = nearest_along(second.ends[0], way_of_second, first.ends[0] + along[0] * way_of_first);
  along[0] = nearest_along(first.ends[0], way_of_first, second.ends[0] + along[1] * way_of_second);
  return (first.ends[0] + along[0] * way_of_first - second.ends[0] - along[1] * way_of_second).norm();
}

/// True if a normal of an edge lies between those of its faces, and not next to one of them, which touches then.
bool is_between_faces(const SharpEdge& edge, const Vec3& normal) {
  constexpr double kBeside = 0.02;  // sine
  const Vec3 along = (edge.ends[1] - edge.ends[0]).normalized();
  const double from_first = along.dot(edge.normals[0].cross(normal)),
               to_second = along.dot(normal.cross(edge.normals[1])),
               whole = along.dot(edge.normals[0].cross(edge.normals[1]));
  return whole > 0 ? std::min(from_first, to_second) > kBeside : std::max(from_first, to_second) < -kBeside;
}

}  // namespace

bool are_sharp(const Vec3& first, const Vec3& second) {
  constexpr double kFlat = 0.94;  // cosine
  return first.dot(second) < kFlat;
}

EdgeTest test_edges(const SharpEdge& first, const SharpEdge& second, double deepest) {
  const Vec3 way_of_first = first.ends[1] - first.ends[0], way_of_second = second.ends[1] - second.ends[0],
             apart = second.ends[0] - first.ends[0], across = way_of_first.cross(way_of_second);
  const double square = across.squaredNorm();
  const auto none = [&](const std::array<double, 2>& along) {
    return EdgeTest{std::nullopt, std::max(0.0, distance_between(first, second, along) - deepest)};
  };
  if (square < kParallel * way_of_first.squaredNorm() * way_of_second.squaredNorm()) return none({0.5, 0.5});
  const std::array<double, 2> along = {apart.cross(way_of_second).dot(across) / square,
                                       apart.cross(way_of_first).dot(across) / square};
  const auto is_inside = [](double fraction) { return fraction > kCorner && fraction < 1 - kCorner; };
  if (!is_inside(along[0]) || !is_inside(along[1])) return none(along);
  Vec3 normal = across / std::sqrt(square);
  if (normal.dot(first.normals[0] + first.normals[1]) < 0) normal = -normal;
  const double depth = -normal.dot(apart);
  if (depth < 0) return {std::nullopt, -depth};
  if (depth > deepest || !is_between_faces(first, normal) || !is_between_faces(second, -normal)) return none(along);
  return {EdgeContact{along, normal, depth}};
}

}  // namespace griffith::explicit_dynamics
