#pragma once

#include <array>
#include <span>

#include "sim/elasticity/element.h"

namespace griffith {

/// Sums over the quadratic elements at a corner or an edge of their mesh.
struct NodeStiffness {
  double stiffness = 0;  ///< Σ V |g_i|² at corner i, Σ V (|g_i|² + |g_j|²) at edge ij [m]
  double volume = 0;     ///< volume whose mass it has: ¼ Σ V of a corner, Σ V of an edge [m³]

  double ratio() const { return stiffness / volume; }  ///< [1/m²]
};

/// Adds the part of one element. `corner` and `edge` are 0..3 and 0..5 as in kTetEdges.
void add_corner_stiffness(const RestElement& rest, int corner, NodeStiffness& sums);
void add_edge_stiffness(const RestElement& rest, int edge, NodeStiffness& sums);

/// Returns a frequency of an element that bounds those of its mesh from above: the highest one of a mesh, with the
/// masses of NodeStiffness, does not exceed the largest of its elements' [rad/s]. Each element has a share of its
/// nodes' masses in proportion to its stiffness there, so small or flat elements among larger ones do not count alone.
///   density         [kg/m³]
///   corners, edges  NodeStiffness::ratio() at the corners and edges of the element [1/m²]
double bounding_frequency(const ElasticLaw& law, double density, const RestElement& rest,
                          const std::array<double, 4>& corners, const std::array<double, 6>& edges);

/// Largest ratio of the frequencies of the stiffest elements of a mesh, at most 2 % of them, to those of the others,
/// which set the microstep. The stiffest have little energy, and stay within three quarters of the limit of stability.
inline constexpr double kFewOverMost = 1.6;

/// Returns the largest bounding_frequency() of a mesh except for the stiffest few, or more if these need it [rad/s].
/// The largest is 1.2 to 1.6 times the highest frequency of a mesh (test).
///   corners, edges  indices of each element's, not negative
double highest_quadratic_frequency(const ElasticLaw& law, double density, std::span<const RestElement> rest_elements,
                                   std::span<const std::array<int, 4>> corners,
                                   std::span<const std::array<int, 6>> edges);

}  // namespace griffith
