#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith {

/// Divides tets into few clusters that are convex up to `tolerance` [m] >= 0: no point of a cluster lies farther
/// outside of the plane of a face of its surface. A cluster that is not is cut by the plane of such a face, of those
/// the one that passes through the fewest tets; a tet goes to the side of its centroid. Where none divides it, planes
/// between two tets do. A single tet is a cluster. (Lien & Amato 2007,
/// "Approximate convex decomposition of polyhedra", cut at the deepest notch; cells have planes that cut none.)
/// Returns the tets of each cluster, ascending. `points` [m]; `tets` have volume and are at most some hundred, since
/// the time grows with the square of their number.
std::vector<std::vector<int>> convex_clusters(std::span<const Vec3> points, std::span<const std::array<int, 4>> tets,
                                              double tolerance);

}  // namespace griffith
