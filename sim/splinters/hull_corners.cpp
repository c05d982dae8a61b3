#include <algorithm>
#include <array>

#include "sim/splinters/splinters.h"

namespace griffith {
namespace {

std::array<float, 3> place_of(const SplinterSet& set, const HullCorner& corner) {
  const Eigen::Vector3f& rest = set.corners[corner.corner].rest;
  return {rest.x(), rest.y(), rest.z()};
}

std::vector<HullCorner> corners_of(const SplinterSet& set, const Splinter& splinter) {
  std::vector<HullCorner> corners;
  for (int p = splinter.first_part; p < splinter.first_part + splinter.parts; ++p)
    for (int f = set.parts[p].first_face; f < set.parts[p].first_face + set.parts[p].faces; ++f)
      for (int i = 0; i < set.faces[f].corners; ++i) corners.push_back({p, set.faces[f].first_corner + i});
  const auto place = [&](const HullCorner& corner) { return place_of(set, corner); };
  std::ranges::stable_sort(corners, {}, place);
  const auto rest = std::ranges::unique(corners, {}, place);
  corners.erase(rest.begin(), rest.end());
  return corners;
}

}  // namespace

std::vector<std::vector<HullCorner>> hull_corners(const SplinterSet& splinters) {
  std::vector<std::vector<HullCorner>> hulls;
  for (const Splinter& splinter : splinters.splinters) hulls.push_back(corners_of(splinters, splinter));
  return hulls;
}

}  // namespace griffith
