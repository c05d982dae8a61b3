#include "ui/model/region_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/scene/scene_fields.h"

namespace griffith::ui {
namespace {

void add_box(const BoxRegion& box, std::vector<RegionLine>& lines) {
  const auto corner = [&](int bits) {
    Vec3 place = box.minimum;
    for (int axis = 0; axis < 3; ++axis)
      if (bits >> axis & 1) place[axis] = box.maximum[axis];
    return place;
  };
  for (int bits = 0; bits < 8; ++bits)
    for (const int axis : {1, 2, 4})
      if (!(bits & axis)) lines.push_back({corner(bits), corner(bits | axis)});
}

void add_sphere(const SphereRegion& sphere, std::vector<RegionLine>& lines) {
  for (int axis = 0; axis < 3; ++axis)
    for (const RegionLine& line : circle_lines(sphere.center, sphere.radius * Vec3::Unit((axis + 1) % 3),
                                               sphere.radius * Vec3::Unit((axis + 2) % 3)))
      lines.push_back(line);
}

void add_plane(const HalfSpaceRegion& half_space, double size, std::vector<RegionLine>& lines) {
  const Vec3 normal = half_space.normal.stableNormalized();
  const Vec3 a = size / 2 * normal.unitOrthogonal(), b = normal.cross(a);
  const std::array<Vec3, 4> corners = {a + b, a - b, -a - b, b - a};
  for (std::size_t i = 0; i < 4; ++i)
    lines.push_back({half_space.point + corners[i], half_space.point + corners[(i + 1) % 4]});
  lines.push_back({half_space.point, half_space.point + size / 4 * normal});
}

/// Returns the sum rounded to nanometers, without digits that come from rounding errors alone.
double tidy_sum(double place, double offset) {
  constexpr double kParts = 1e9;
  return offset == 0 ? place : std::round((place + offset) * kParts) / kParts;
}

Vec3 tidy_sum(const Vec3& place, const Vec3& offset) {
  return place.binaryExpr(offset, [](double a, double b) { return tidy_sum(a, b); });
}

/// Clamps a point to the range that scene files allow.
Vec3 in_limits(const Vec3& place) { return place.cwiseMax(kPlace.minimum).cwiseMin(kPlace.maximum); }

void keep_in_limits(Region& region) {
  if (auto* box = std::get_if<BoxRegion>(&region))
    box->minimum = in_limits(box->minimum), box->maximum = in_limits(box->maximum);
  if (auto* sphere = std::get_if<SphereRegion>(&region)) {
    sphere->center = in_limits(sphere->center);
    sphere->radius = std::min(sphere->radius, kPlace.maximum);
  }
  if (auto* half_space = std::get_if<HalfSpaceRegion>(&region)) half_space->point = in_limits(half_space->point);
}

}  // namespace

std::vector<RegionLine> circle_lines(const Vec3& center, const Vec3& a, const Vec3& b) {
  constexpr int kSegments = 48;
  const auto place = [&](int i) {
    const double angle = 2 * std::numbers::pi * i / kSegments;
    return Vec3(center + std::cos(angle) * a + std::sin(angle) * b);
  };
  std::vector<RegionLine> lines;
  for (int i = 0; i < kSegments; ++i) lines.push_back({place(i), place(i + 1)});
  return lines;
}

std::vector<RegionLine> region_lines(const Region& region, double size) {
  std::vector<RegionLine> lines;
  if (const auto* box = std::get_if<BoxRegion>(&region)) add_box(*box, lines);
  if (const auto* sphere = std::get_if<SphereRegion>(&region)) add_sphere(*sphere, lines);
  if (const auto* half_space = std::get_if<HalfSpaceRegion>(&region)) add_plane(*half_space, size, lines);
  return lines;
}

std::vector<RegionGrip> region_grips(const Region& region) {
  std::vector<RegionGrip> grips;
  if (const auto* box = std::get_if<BoxRegion>(&region)) {
    for (int axis = 0; axis < 3; ++axis)
      for (const bool upper : {false, true}) {
        Vec3 place = region_place(region);
        place[axis] = (upper ? box->maximum : box->minimum)[axis];
        grips.push_back({place, (upper ? 1.0 : -1.0) * Vec3::Unit(axis)});
      }
  }
  if (const auto* sphere = std::get_if<SphereRegion>(&region))
    for (int axis = 0; axis < 3; ++axis)
      grips.push_back({sphere->center + sphere->radius * Vec3::Unit(axis), Vec3::Unit(axis)});
  if (const auto* half_space = std::get_if<HalfSpaceRegion>(&region))
    grips.push_back({half_space->point, half_space->normal.stableNormalized()});
  return grips;
}

Region drag_grip(Region region, std::size_t grip, double distance, double min_radius) {
  if (auto* box = std::get_if<BoxRegion>(&region)) {
    const auto axis = static_cast<Eigen::Index>(grip / 2);
    double &low = box->minimum[axis], &high = box->maximum[axis];
    if (grip % 2 == 1) {
      high = std::max(low, tidy_sum(high, distance));
    } else {
      low = std::min(high, tidy_sum(low, -distance));
    }
  }
  if (auto* sphere = std::get_if<SphereRegion>(&region))
    sphere->radius = std::max(min_radius, tidy_sum(sphere->radius, distance));
  if (auto* half_space = std::get_if<HalfSpaceRegion>(&region))
    half_space->point = tidy_sum(half_space->point, distance * half_space->normal.stableNormalized());
  keep_in_limits(region);
  return region;
}

Vec3 region_place(const Region& region) {
  if (const auto* box = std::get_if<BoxRegion>(&region)) return (box->minimum + box->maximum) / 2;
  if (const auto* sphere = std::get_if<SphereRegion>(&region)) return sphere->center;
  if (const auto* half_space = std::get_if<HalfSpaceRegion>(&region)) return half_space->point;
  return Vec3::Zero();
}

bool has_place(const Region& region) { return !std::holds_alternative<NodeListRegion>(region); }

Vec3 moved_place(const Vec3& place, const Vec3& offset) { return in_limits(tidy_sum(place, offset)); }

void move_region(Region& region, const Vec3& offset) {
  if (auto* box = std::get_if<BoxRegion>(&region)) {
    box->minimum = moved_place(box->minimum, offset);
    box->maximum = moved_place(box->maximum, offset);
  }
  if (auto* sphere = std::get_if<SphereRegion>(&region)) sphere->center = moved_place(sphere->center, offset);
  if (auto* half_space = std::get_if<HalfSpaceRegion>(&region))
    half_space->point = moved_place(half_space->point, offset);
}

}  // namespace griffith::ui
