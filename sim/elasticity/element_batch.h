#pragma once

#include <array>

#include "sim/elasticity/element_kernel.h"

namespace griffith {

// Four elements side by side, with the bits of one at a time.

using FourDeformations = simd::Deformation<simd::DoubleLanes>;
using FourStates = simd::State<simd::DoubleLanes>;

/// Returns element_deformation() of four elements.
FourDeformations element_deformations(ElementModel model, const std::array<const RestElement*, 4>& rests,
                                      const std::array<Corners, 4>& corners);

/// Returns element_state() of four elements.
FourStates element_states(const ElasticLaw& law, const FourDeformations& deformations,
                          const std::array<Mat3, 4>& stress_free_strains);

}  // namespace griffith
