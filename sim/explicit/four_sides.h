#pragma once

#include <array>

#include "sim/core/lane_vectors.h"
#include "sim/explicit/explicit_bodies.h"

// Triangles of the bodies' surface, four side by side.

namespace griffith::explicit_dynamics {

using simd::DoubleLanes;
using simd::DoubleMask;
using FourVectors = simd::Vector3<DoubleLanes>;

/// Positions of corners a, b and c of four triangles [m].
using FourSides = std::array<FourVectors, 3>;

/// Returns the triangles of these nodes, given per lane.
template <class NodesOf>
FourSides four_sides(const ExplicitBodies& bodies, NodesOf nodes_of) {
  const std::array<std::array<int, 3>, 4> nodes = {nodes_of(0), nodes_of(1), nodes_of(2), nodes_of(3)};
  FourSides sides;
  for (int i = 0; i < 3; ++i)
    sides[i] = simd::side_by_side(bodies.place(nodes[0][i]), bodies.place(nodes[1][i]), bodies.place(nodes[2][i]),
                                  bodies.place(nodes[3][i]));
  return sides;
}

/// Returns twice the area vectors [m²].
inline FourVectors double_areas(const FourSides& sides) { return cross(sides[1] - sides[0], sides[2] - sides[0]); }

/// Returns the barycentric weights of the projections of points onto triangles. `across`: their double_areas(),
/// `square`: the squared length of these.
inline std::array<DoubleLanes, 3> weights_in(const FourSides& sides, const FourVectors& across,
                                             const DoubleLanes& square, const FourVectors& points) {
  const auto& [a, b, c] = sides;
  const DoubleLanes u = dot(across, cross(c - b, points - b)) / square,
                    v = dot(across, cross(a - c, points - c)) / square;
  return {u, v, 1.0 - u - v};
}

/// Returns the distance to the triangle of points whose projection misses the limit of a weight by `beyond`: sides
/// rotate about their edges [m].
inline DoubleLanes distance_beyond(const FourSides& sides, const DoubleLanes& square, const DoubleLanes& beyond) {
  constexpr double kFraction = 0.5;
  const auto squared_length = [](const FourVectors& v) { return dot(v, v); };
  const DoubleLanes longest = larger(larger(squared_length(sides[1] - sides[0]), squared_length(sides[2] - sides[1])),
                                     squared_length(sides[0] - sides[2]));
  return kFraction * beyond * simd::root(square / longest);
}

}  // namespace griffith::explicit_dynamics
