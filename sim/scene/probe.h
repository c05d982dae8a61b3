#pragma once

#include <string>
#include <variant>
#include <vector>

#include "sim/scene/region.h"

namespace griffith {

/// Point in the body's rest space [m]. Outside the body, the nearest tet is used.
struct ProbePoint {
  Vec3 point = Vec3::Zero();
  bool operator==(const ProbePoint&) const = default;
};
/// Node by its index in the body's mesh as built or read.
struct ProbeNode {
  int node = 0;
  bool operator==(const ProbeNode&) const = default;
};
using ProbePlace = std::variant<ProbePoint, ProbeNode, Region>;

/// Values recorded in every frame under a name. Values of a region are means over its nodes, but reactions are summed.
struct Probe {
  std::string name = "probe";
  std::string body = "body";  ///< name of a body
  ProbePlace at;
  std::vector<std::string> quantities = {"displacement"};  ///< keys of probe_quantities()
  bool operator==(const Probe&) const = default;
};

}  // namespace griffith
