#include "sim/fracture/resistance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace griffith {
namespace {

TEST(Resistance, IsTheTensileStrengthThatFlawsLeave) {
  Material glass;
  glass.tensile_strength = 45e6;
  EXPECT_EQ(resistance(glass), 45e6);
  EXPECT_EQ(resistance(glass, 0.5), 22.5e6);
}

TEST(Resistance, FrontsAreScreenedByAStressThatFallsWithTheRootOfTheElementSize) {
  Material glass;
  glass.tensile_strength = 45e6;
  glass.fracture_toughness = 0.76e6;
  const double h = 0.02;
  EXPECT_EQ(screening_resistance(glass, false, h), 45e6);
  EXPECT_LT(screening_resistance(glass, true, h), 0.76e6 / std::sqrt(2 * std::numbers::pi * h));
  EXPECT_NEAR(screening_resistance(glass, true, 4 * h), screening_resistance(glass, true, h) / 2, 1);
  EXPECT_EQ(screening_resistance(glass, true, 1e-9), 45e6) << "never above the strength";
}

TEST(Resistance, ForceCriterionUsesTheToughnessInNewtons) {
  Material paper;
  paper.criterion = FractureCriterion::separation_force;
  paper.separation_toughness = 1234;
  EXPECT_EQ(resistance(paper), 1234);
  EXPECT_EQ(screening_resistance(paper, true, 0.1), 1234);
}

TEST(Resistance, AWeakPlaneTakesTheSquareOfItsFractionOfTheFractureEnergy) {
  Material glass;
  glass.young_modulus = 70e9;
  glass.poisson_ratio = 0.22;
  glass.fracture_toughness = 0.75e6;
  EXPECT_NEAR(fracture_energy(glass), 7.647, 1e-3);  // K² (1 − ν²) / E
  EXPECT_NEAR(fracture_energy(glass, 0.5), fracture_energy(glass) / 4, 1e-12);
}

}  // namespace
}  // namespace griffith
