#pragma once

#include <array>
#include <span>

#include "sim/contact/hull.h"
#include "sim/contact/polygon.h"

namespace griffith::contact {

/// Place of an object.
struct Place {
  Mat3 rotation = Mat3::Identity();
  Vec3 translation = Vec3::Zero();
  Vec3 to_world(const Vec3& local) const { return rotation * local + translation; }
  Vec3 to_local(const Vec3& world) const { return rotation.transpose() * (world - translation); }
};

/// Returns the place of one in the frame of the other.
inline Place relative(const Place& one, const Place& other) {
  return {other.rotation.transpose() * one.rotation, other.to_local(one.translation)};
}

/// Up to four contact points of two convex parts, with the state of the pair from one detection to the next. The points
/// move with the pair, so that little is computed while it hardly moves.
struct Manifold {
  static constexpr int kMaxPoints = 4;
  struct Point {
    Vec3 on_a, on_b;            ///< the nearest points of the surfaces, in the frames of the two objects [m]
    Vec3 force = Vec3::Zero();  ///< on a, of the last substep [N]
  };
  /// Feature that separates two hulls best: a face of one, or two edges.
  enum class Feature : signed char { none, face_of_a, face_of_b, edges };

  Feature feature = Feature::none;
  int count = 0;
  int of_a = 0, of_b = 0;           ///< the faces or edges of the feature
  double margin = 0;                ///< motion of the pair up to which its feature stays the best [m]
  double drift = 0;                 ///< bound on its motion since the last search [m]
  double separation = 0;            ///< along the feature's normal in the last search [m]
  double seen_reach = 0;            ///< gap up to which the last search listed its points [m]
  Place seen;                       ///< place of a in b's frame at that time
  Vec3 normal_in_b = Vec3::Zero();  ///< unit normal, toward a
  std::array<Point, kMaxPoints> points;

  std::span<Point> listed() { return {points.data(), static_cast<std::size_t>(count)}; }
  std::span<const Point> listed() const { return {points.data(), static_cast<std::size_t>(count)}; }
};

/// Largest number at two parts: only some corners of a face with very many are examined.
inline constexpr int kMostFound = Polygon::kMaxCorners;

/// Point on both surfaces, in b's frame.
struct FoundPoint {
  Vec3 on_a, on_b;
  double distance;  ///< [m], negative where they overlap
};

/// Hull and the radius of its object around the origin [m].
struct SizedHull {
  const Hull& hull;
  double radius;
};

/// Finds where two solid hulls meet whose gaps are below `reach` [m]; `a_in_b`: where a lies in b's frame. By
/// separating axes (Gottschalk 1996), the normals of faces and edges (Gregorius 2013); the axis that parted or touched
/// last is tried first and kept while no other can be better. The nearest points are the corners of the area common to
/// the two faces there (Sutherland and Hodgman 1974).
void find_contacts(Manifold& manifold, const SizedHull& a, const SizedHull& b, const Place& a_in_b, double reach);

/// Writes points into a manifold, at most four that span their area, and hands on the forces of those that were where
/// they are within `tolerance` [m].
void set_points(Manifold& manifold, std::span<const FoundPoint> found, const Vec3& normal_in_b, const Place& a_in_b,
                double tolerance);

}  // namespace griffith::contact
