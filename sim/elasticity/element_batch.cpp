#include "sim/elasticity/element_batch.h"

namespace griffith {
namespace {

using simd::DoubleLanes;

/// Returns get(lane) of all lanes.
template <class Get>
DoubleLanes gather_lanes(const Get& get) {
  return DoubleLanes{get(0), get(1), get(2), get(3)};
}

}  // namespace

FourDeformations element_deformations(ElementModel model, const std::array<const RestElement*, 4>& rests,
                                      const std::array<Corners, 4>& corners) {
  const auto place = [&](int i, int corner) {
    return gather_lanes([&](int lane) { return corners[lane](i, corner); });
  };
  const auto slope = [&](int i, int corner) {
    return gather_lanes([&](int lane) { return rests[lane]->shape_gradients(i, corner); });
  };
  return simd::deformation_of(model, simd::gradient_of<DoubleLanes>(place, slope));
}

FourStates element_states(const ElasticLaw& law, const FourDeformations& deformations,
                          const std::array<Mat3, 4>& stress_free_strains) {
  const auto entry = [&](int i, int j) {
    return gather_lanes([&](int lane) { return stress_free_strains[lane](i, j); });
  };
  return simd::state_of(law, deformations,
                        {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)});
}

}  // namespace griffith
