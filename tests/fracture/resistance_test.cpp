#include "sim/fracture/resistance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace griffith {
namespace {

TEST(Resistance, AwayFromACrackIsTheTensileStrength) {
  Material glass;
  glass.tensile_strength = 45e6;
  for (double h : {1e-3, 1e-2, 1.0}) EXPECT_EQ(resistance(glass, false, h), 45e6);
}

TEST(Resistance, AtACrackFrontFallsWithTheRootOfTheElementSize) {
  Material glass;
  glass.tensile_strength = 45e6;
  glass.fracture_toughness = 0.76e6;
  const double h = 0.02;
  EXPECT_NEAR(resistance(glass, true, h), 1.3 * 0.76e6 / std::sqrt(2 * std::numbers::pi * h), 1);
  EXPECT_NEAR(resistance(glass, true, 4 * h), resistance(glass, true, h) / 2, 1);
  EXPECT_EQ(resistance(glass, true, 1e-9), 45e6) << "never above the strength";
}

TEST(Resistance, ForceCriterionUsesTheToughnessInNewtons) {
  Material paper;
  paper.criterion = FractureCriterion::separation_force;
  paper.separation_toughness = 1234;
  EXPECT_EQ(resistance(paper, false, 0.1), 1234);
  EXPECT_EQ(resistance(paper, true, 0.1), 1234);
}

}  // namespace
}  // namespace griffith
