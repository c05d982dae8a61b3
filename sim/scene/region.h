#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Part of a body, in the body's rest space (before position and rotation) [m].
struct BoxRegion {
  Vec3 minimum = Vec3::Zero(), maximum = Vec3::Zero();
  bool operator==(const BoxRegion&) const = default;
};
struct SphereRegion {
  Vec3 center = Vec3::Zero();
  double radius = 0;
  bool operator==(const SphereRegion&) const = default;
};
/// Points x with dot(x − point, normal) >= 0.
struct HalfSpaceRegion {
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitY();
  bool operator==(const HalfSpaceRegion&) const = default;
};
/// Nodes by their index in the body's mesh as built or read.
struct NodeListRegion {
  std::vector<int> nodes;
  bool operator==(const NodeListRegion&) const = default;
};
using Region = std::variant<BoxRegion, SphereRegion, HalfSpaceRegion, NodeListRegion>;

/// True if the node at rest position `point` with index `node` lies in the region. Boundaries are included, with a
/// tolerance of `tolerance` [m].
bool contains(const Region& region, const Vec3& point, int node, double tolerance);

/// Returns per node of a body: 1 if it lies in the region, boundaries included, with a tolerance of 1e-9 of the body's
/// size. `points`: all of the body's nodes, in its rest space [m]; `numbers`: their indices in the body's mesh as built
/// or read, used by regions.
std::vector<std::uint8_t> nodes_in(const Region& region, std::span<const Vec3> points, std::span<const int> numbers);

}  // namespace griffith
