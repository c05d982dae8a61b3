#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "sim/elasticity/element_batch.h"
#include "sim/world/state/corners.h"

namespace griffith {

/// Elements with their law and placement.
struct PlacedElements {
  ElasticLaw law;
  const TetMesh& mesh;
  std::span<const RestElement> rest_elements;  ///< per tet
  std::span<const Vec3> positions;             ///< per node [m]
};

/// Finds the states of `tets`, four side by side: strain_of(tet, deformations, lane) returns the strain without stress
/// of a lane, and write(tet, states, lane) takes its state. Both are called once a tet, in their order.
template <class StrainOf, class Write>
void find_states(const PlacedElements& placed, std::span<const TetId> tets, const StrainOf& strain_of,
                 const Write& write) {
  constexpr std::size_t kLanes = simd::kDoubleLanes;
  for (std::size_t first = 0; first < tets.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, tets.size() - first);
    std::array<const RestElement*, kLanes> rests;
    std::array<Corners, kLanes> corners;
    std::array<Mat3, kLanes> strains;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const TetId tet = tets[first + std::min(lane, count - 1)];  // lanes to spare repeat the last
      rests[lane] = &placed.rest_elements[tet];
      corners[lane] = corners_of(placed.mesh, tet, placed.positions);
    }
    const FourDeformations deformations = element_deformations(placed.law.model, rests, corners);
    for (std::size_t lane = 0; lane < count; ++lane)
      strains[lane] = strain_of(tets[first + lane], deformations, static_cast<int>(lane));
    std::fill(strains.begin() + static_cast<std::ptrdiff_t>(count), strains.end(), strains[count - 1]);
    const FourStates states = element_states(placed.law, deformations, strains);
    for (std::size_t lane = 0; lane < count; ++lane) write(tets[first + lane], states, static_cast<int>(lane));
  }
}

}  // namespace griffith
