#include "sim/explicit/sharp_edge.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace griffith::explicit_dynamics {
namespace {

/// Fraction of an edge at each end that belongs to its corner.
constexpr double kCorner = 0.02;

/// Sine of the angle between edges that count as parallel.
constexpr double kParallel = 0.01;

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

/// Returns by how much a normal of an edge misses the directions between those of its faces [sine]; at most 0 if it
/// lies between them, and not next to one of them, which touches then.
double miss_of_faces(const SharpEdge& edge, const Vec3& normal) {
  constexpr double kBeside = 0.02;  // sine
  const Vec3 along = (edge.ends[1] - edge.ends[0]).normalized();
  const double from_first = along.dot(edge.normals[0].cross(normal)),
               to_second = along.dot(normal.cross(edge.normals[1])),
               whole = along.dot(edge.normals[0].cross(edge.normals[1]));
  return kBeside - (whole > 0 ? std::min(from_first, to_second) : -std::max(from_first, to_second));
}

/// Returns the fraction by which a place on an edge lies beyond its ends, or in one of its corners.
double beyond_ends(double along) { return std::max({0.0, kCorner - along, along - (1 - kCorner)}); }

}  // namespace

bool are_sharp(const Vec3& first, const Vec3& second) {
  constexpr double kFlat = 0.94;  // cosine
  return first.dot(second) < kFlat;
}

EdgeTest test_edges(const SharpEdge& first, const SharpEdge& second, double deepest) {
  constexpr double kTurning = 0.25;  // of a way at its end, by which an edge turns
  const Vec3 way_of_first = first.ends[1] - first.ends[0], way_of_second = second.ends[1] - second.ends[0],
             apart = second.ends[0] - first.ends[0], across = way_of_first.cross(way_of_second);
  const std::array<double, 2> lengths = {way_of_first.norm(), way_of_second.norm()};
  const double shorter = std::min(lengths[0], lengths[1]), square = across.squaredNorm(),
               sine = std::sqrt(square) / (lengths[0] * lengths[1]);
  const auto apart_at = [&](const std::array<double, 2>& along) {
    return std::max(0.0, distance_between(first, second, along) - deepest);
  };
  if (sine < kParallel) return {std::nullopt, std::max(kTurning * (kParallel - sine) * shorter, apart_at({0.5, 0.5}))};
  const std::array<double, 2> along = {apart.cross(way_of_second).dot(across) / square,
                                       apart.cross(way_of_first).dot(across) / square};
  const double beyond = std::max(beyond_ends(along[0]) * lengths[0], beyond_ends(along[1]) * lengths[1]);
  if (beyond > 0) return {std::nullopt, std::max(kTurning * sine * beyond, apart_at(along))};
  Vec3 normal = across / std::sqrt(square);
  if (normal.dot(first.normals[0] + first.normals[1]) < 0) normal = -normal;
  const double depth = -normal.dot(apart);
  if (depth < 0) return {std::nullopt, -depth};
  const double miss = std::max(miss_of_faces(first, normal), miss_of_faces(second, -normal));
  if (depth <= deepest && miss < 0) return {EdgeContact{along, normal, depth}};
  return {std::nullopt, std::max(depth - deepest, kTurning * sine * miss * shorter)};
}

}  // namespace griffith::explicit_dynamics
