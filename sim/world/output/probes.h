#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/core/error.h"
#include "sim/scene/probe.h"
#include "sim/world/setup/rest_body.h"

namespace griffith {

struct Frame;
struct Scene;

/// Node of a probe.
struct ProbedNode {
  TetCorner corner;             ///< it stays with this corner where a crack parts it
  double weight = 0;            ///< weight in the probe's mean; their sum is 1
  std::vector<TetCorner> star;  ///< all corners at the node before anything broke
};

/// Probe and its nodes or points.
struct PlacedProbe {
  Probe probe;
  std::vector<ProbedNode> nodes;  ///< none where a region holds none: its values are not numbers
};

/// Finds the nodes of the scene's probes that name this body, in `all` probes; a region without any becomes a finding.
/// Throws InputError when a probe names a node that the mesh lacks.
void place_probes(const Scene& scene, int scene_body, const RestBody& body, std::vector<PlacedProbe>& all,
                  std::vector<InputError>& findings);

/// Throws InputError when a probe names no body of the scene, or no quantity.
void check_probes(const Scene& scene);

/// Returns the columns of probe_values(): "name.displacement.x [m]", …
std::vector<std::string> probe_columns(std::span<const PlacedProbe> probes);

/// Returns the values of all probes in a frame, SI units. A node's stress is the mean of its tets', weighted by their
/// volumes. A point's values are interpolated between the corners of its tet; a region's are means over its nodes.
/// Reactions are sums over the probe's nodes and the copies that cracks made of them.
std::vector<double> probe_values(std::span<const PlacedProbe> probes, const Frame& frame);

}  // namespace griffith
