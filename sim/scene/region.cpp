#include "sim/scene/region.h"

#include <algorithm>

namespace griffith {
namespace {

struct Contains {
  const Vec3& point;
  int node;
  double tolerance;

  bool operator()(const BoxRegion& box) const {
    return (point.array() >= box.minimum.array() - tolerance).all() &&
           (point.array() <= box.maximum.array() + tolerance).all();
  }
  bool operator()(const SphereRegion& sphere) const {
    return (point - sphere.center).norm() <= sphere.radius + tolerance;
  }
  bool operator()(const HalfSpaceRegion& half_space) const {
    return (point - half_space.point).dot(half_space.normal.stableNormalized()) >= -tolerance;
  }
  bool operator()(const NodeListRegion& list) const { return std::ranges::find(list.nodes, node) != list.nodes.end(); }
};

}  // namespace

bool contains(const Region& region, const Vec3& point, int node, double tolerance) {
  return std::visit(Contains{point, node, tolerance}, region);
}

}  // namespace griffith
