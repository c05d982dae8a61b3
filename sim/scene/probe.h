#pragma once

#include <string>
#include <variant>
#include <vector>

#include "sim/scene/region.h"

namespace griffith {

/// A point in the body's rest space [m]; where it lies outside the body, the nearest tet counts.
struct ProbePoint {
  Vec3 point = Vec3::Zero();
  bool operator==(const ProbePoint&) const = default;
};
/// A node by its index in the body's mesh as built or read.
struct ProbeNode {
  int node = 0;
  bool operator==(const ProbeNode&) const = default;
};
using ProbePlace = std::variant<ProbePoint, ProbeNode, Region>;

enum class ProbeQuantity { displacement, velocity, stress, principal_stress, separation, reaction };

/// Values to be written down in every frame, under a name. A region's values are means over its nodes, but reactions
/// are added up.
struct Probe {
  std::string name = "probe";
  std::string body = "body";  ///< the name of a body
  ProbePlace at;
  std::vector<ProbeQuantity> quantities = {ProbeQuantity::displacement};
  bool operator==(const Probe&) const = default;
};

}  // namespace griffith
