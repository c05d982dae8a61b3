#include "sim/contact/contact_patch.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace griffith {
namespace {

using Outline = std::vector<Vec2>;

/// Coordinates in the contact plane and along the normal.
struct ContactFrame {
  Vec3 origin, first, second, normal;
  Vec3 to_local(const Vec3& p) const { return {first.dot(p - origin), second.dot(p - origin), normal.dot(p - origin)}; }
  Vec3 to_world(const Vec2& p, double height) const {
    return origin + p.x() * first + p.y() * second + height * normal;
  }
};

/// A face, an edge or a corner: its outline (counter-clockwise) and its nearly constant height over the contact plane.
struct Feature {
  Outline outline;
  Vec2 center = Vec2::Zero(), slope = Vec2::Zero();
  double height = 0;
  double height_at(const Vec2& p) const { return height + slope.dot(p - center); }
};

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Convex outline by Andrew's monotone chain (1979). Corners that stick out less than `tolerance` are left out.
Outline convex_outline(Outline points, double tolerance) {
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  if (points.size() < 3) return points;
  const auto append_chain = [&](Outline& outline, const Vec2& point, std::size_t start) {
    while (outline.size() >= start + 2) {
      const Vec2 base = point - outline[outline.size() - 2];
      if (cross(outline.back() - outline[outline.size() - 2], base) > tolerance * base.norm()) break;
      outline.pop_back();
    }
    outline.push_back(point);
  };
  Outline outline;
  for (const Vec2& point : points) append_chain(outline, point, 0);
  const std::size_t lower = outline.size() - 1;
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) append_chain(outline, *point, lower);
  outline.pop_back();
  return outline;
}

/// The plane through the feature's corners in the least squares sense; flat across an edge.
void fit_height(Feature& feature, const std::vector<Vec3>& corners) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& corner : corners) mean += corner / static_cast<double>(corners.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Vec2 moment = Vec2::Zero();
  for (const Vec3& corner : corners) {
    const Vec2 arm = (corner - mean).head<2>();
    spread += arm * arm.transpose();
    moment += (corner.z() - mean.z()) * arm;
  }
  feature.center = mean.head<2>();
  feature.height = mean.z();
  const double floor = 1e-6 * spread.trace();
  if (floor > 0) feature.slope = (spread + floor * Eigen::Matrix2d::Identity()).inverse() * moment;
}

/// The corners foremost along the normal (`side` 1) or against it (-1).
Feature foremost_feature(std::span<const Vec3> points, const ContactFrame& frame, double side, double tolerance) {
  constexpr double kThinFraction = 0.25;  // of the body's thickness: its far side is no part of the feature
  std::vector<Vec3> corners;
  double foremost = -std::numeric_limits<double>::infinity(), hindmost = -foremost;
  for (const Vec3& point : points) {
    corners.push_back(frame.to_local(point));
    foremost = std::max(foremost, side * corners.back().z());
    hindmost = std::min(hindmost, side * corners.back().z());
  }
  tolerance = std::min(tolerance, kThinFraction * (foremost - hindmost));
  std::erase_if(corners, [&](const Vec3& corner) { return side * corner.z() < foremost - tolerance; });
  Feature feature;
  for (const Vec3& corner : corners) feature.outline.push_back(corner.head<2>());
  feature.outline = convex_outline(std::move(feature.outline), 1e-3 * tolerance);
  fit_height(feature, corners);
  return feature;
}

/// The part of a convex outline on the left of the line through `start` along `direction`.
Outline clipped(const Outline& outline, const Vec2& start, const Vec2& direction) {
  Outline kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &here = outline[i], &next = outline[(i + 1) % outline.size()];
    const double here_side = cross(direction, here - start), next_side = cross(direction, next - start);
    if (here_side >= 0) kept.push_back(here);
    if ((here_side > 0 && next_side < 0) || (here_side < 0 && next_side > 0))
      kept.push_back(here + here_side / (here_side - next_side) * (next - here));
  }
  return kept;
}

/// What two outlines share (Sutherland and Hodgman 1974); for two edges that are not nearly parallel, nothing.
Outline intersection(const Outline& a, const Outline& b) {
  if (a.size() < 2 || b.size() < 2) return {};
  if (b.size() == 2 && a.size() > 2) return intersection(b, a);
  Outline shared = a;
  if (b.size() == 2) {
    const Vec2 along_a = (a[1] - a[0]).normalized(), along_b = (b[1] - b[0]).normalized();
    constexpr double kNearlyParallel = 0.05;
    if (std::abs(cross(along_a, along_b)) > kNearlyParallel) return {};
    const Vec2 across(-along_b.y(), along_b.x());
    return clipped(clipped(shared, b[0], -across), b[1], across);
  }
  for (std::size_t i = 0; i < b.size() && !shared.empty(); ++i)
    shared = clipped(shared, b[i], b[(i + 1) % b.size()] - b[i]);
  return shared;
}

}  // namespace

std::vector<PatchPoint> contact_patch(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& normal,
                                      double tolerance) {
  const Vec3 first = normal.unitOrthogonal();
  const ContactFrame frame{b.front(), first, normal.cross(first), normal};
  const Feature feature_a = foremost_feature(a, frame, -1, tolerance);
  const Feature feature_b = foremost_feature(b, frame, 1, tolerance);
  std::vector<PatchPoint> patch;
  for (const Vec2& point : intersection(feature_a.outline, feature_b.outline)) {
    const double height = feature_b.height_at(point);
    patch.push_back({frame.to_world(point, height), feature_a.height_at(point) - height});
  }
  return patch;
}

}  // namespace griffith
