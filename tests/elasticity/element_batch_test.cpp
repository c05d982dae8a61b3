#include "sim/elasticity/element_batch.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "sim/elasticity/corner_traction.h"
#include "tests/elasticity/random_element.h"

namespace griffith {
namespace {

using testing::RandomValues;

template <class Matrix>
bool same_bits(const Matrix& a, const Matrix& b) {
  return std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

/// Four elements, hardly strained, crushed, torn about (inverted now and then) and flat, from `first` on.
struct Quartet {
  std::array<RestElement, 4> elements;
  std::array<const RestElement*, 4> rests;
  std::array<Corners, 4> corners;
  std::array<Mat3, 4> stress_free_strains;

  Quartet(RandomValues& random, int first) {
    constexpr double kStrains[4] = {1e-5, 0.3, 2, 1e-2};
    for (int lane = 0; lane < 4; ++lane) {
      const int kind = (first + lane) % 4;
      Mat3 gradient = random.rotation() * (Mat3::Identity() + random.matrix(kStrains[kind]));
      if (kind == 3) gradient.col(0).setZero();
      const Corners rest_corners = testing::random_corners(random);
      elements[lane] = rest_element(rest_corners);
      rests[lane] = &elements[lane];
      corners[lane] = gradient * rest_corners;
      const Mat3 strain = random.matrix(1e-3);
      stress_free_strains[lane] = strain + strain.transpose();
    }
  }
};

class ElementBatch : public ::testing::TestWithParam<ElementModel> {
 protected:
  const ElasticLaw law_{GetParam(), 4e9, 6e9};
};

TEST_P(ElementBatch, HasTheBitsOfOneAtATime) {
  RandomValues random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const Quartet four(random, trial);
    const FourDeformations deformations = element_deformations(law_.model, four.rests, four.corners);
    const FourStates states = element_states(law_, deformations, four.stress_free_strains);
    for (int lane = 0; lane < 4; ++lane) {
      const ElementDeformation deformation = element_deformation(law_.model, *four.rests[lane], four.corners[lane]);
      const ElementState one = element_state(law_, deformation, four.stress_free_strains[lane]), of = states.of(lane);
      ASSERT_TRUE(same_bits(deformations.of(lane).strain, deformation.strain)) << lane;
      ASSERT_TRUE(same_bits(of.frame, one.frame)) << lane;
      ASSERT_TRUE(same_bits(of.stress.full(), one.stress.full())) << lane;
      ASSERT_TRUE(same_bits(of.tensile_traction, one.tensile_traction)) << lane;
      ASSERT_TRUE(same_bits(of.tension.full(), one.tension.full())) << lane;
      ASSERT_EQ(of.tension_norm, one.tension_norm);
      ASSERT_EQ(of.energy_density, one.energy_density);
      ASSERT_EQ(of.inverted, one.inverted);
      ASSERT_TRUE(same_bits(states.cauchy_stress.of(lane).full(), cauchy_stress(one.frame, one.stress))) << lane;
    }
  }
}

TEST_P(ElementBatch, ALaneWithoutANumberLeavesTheOthersAlone) {
  RandomValues random(2);
  for (int broken = 0; broken < 4; ++broken) {
    Quartet four(random, 0);
    const FourStates sound =
        element_states(law_, element_deformations(law_.model, four.rests, four.corners), four.stress_free_strains);
    four.corners[broken](1, 2) = std::numeric_limits<double>::quiet_NaN();
    const FourStates states =
        element_states(law_, element_deformations(law_.model, four.rests, four.corners), four.stress_free_strains);
    for (int lane = 0; lane < 4; ++lane) {
      EXPECT_EQ(same_bits(states.of(lane).stress.full(), sound.of(lane).stress.full()), lane != broken);
      EXPECT_EQ(states.of(lane).stress.full().allFinite(), lane != broken);
    }
  }
}

TEST_P(ElementBatch, TractionsOfAllCornersHaveTheBitsOfEach) {
  RandomValues random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const Quartet four(random, trial);
    const RestElement& rest = four.elements[0];
    const ElementState state = testing::elastic_state(law_, rest, four.corners[0]);
    const auto tractions = one_by_one(corner_tractions(state, corner_gradients(rest)));
    for (int corner = 0; corner < 4; ++corner) {
      const simd::WideQuad one = corner_traction(rest, state, corner);
      for (int i = 0; i < 3; ++i) EXPECT_EQ(tractions[corner][i], one[i]) << corner;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, ElementBatch,
                         ::testing::Values(ElementModel::corotational, ElementModel::green_strain),
                         [](const auto& model) {
                           return model.param == ElementModel::corotational ? "Corotational" : "GreenStrain";
                         });

}  // namespace
}  // namespace griffith
