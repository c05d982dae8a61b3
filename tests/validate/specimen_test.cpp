#include "app/validate/specimen.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/mesh/box_mesh.h"

namespace griffith::app {
namespace {

TEST(LowestBreaking, FindsTheThresholdToItsTolerance) {
  for (const double threshold : {0.3, 1.0, 2.9})
    EXPECT_NEAR(lowest_breaking(0.25, 4, 0.01, [&](double value) { return value > threshold; }), threshold,
                0.01 * threshold);
}

TEST(LowestBreaking, HasNoResultIfAllOrNoneBreak) {
  EXPECT_TRUE(std::isnan(lowest_breaking(1, 2, 0.01, [](double) { return true; })));
  EXPECT_TRUE(std::isnan(lowest_breaking(1, 2, 0.01, [](double) { return false; })));
}

TEST(OpenSlit, PartsABoxThatItCrosses) {
  for (const auto& [name, pattern] : kNamedPatterns) {
    HexMesh whole = make_box_hexes(Vec3(4, 2, 1), {4, 2, 1}), half = whole;
    open_slit(whole, Vec3::UnitY(), [](const Vec3& point) { return std::abs(point.y()) < 1e-9; });
    open_slit(half, Vec3::UnitY(), [](const Vec3& point) { return std::abs(point.y()) < 1e-9 && point.x() < -1e-9; });
    EXPECT_EQ(whole.points.size(), 5 * 4 * 2);
    EXPECT_EQ(half.points.size(), (5 * 3 + 2) * 2);
    SpecimenScene specimen{empty_laboratory(), {}};
    add_body(specimen, cut_into_tets(half, pattern), laboratory_material("concrete"));
    const World world = specimen.world();
    EXPECT_EQ(world.frame().bodies.size(), 1) << name;
    int fronts = 0;
    for (const std::uint8_t front : world.frame().nodes.at_crack_front) fronts += front;
    EXPECT_EQ(fronts, 2) << name << ": the two nodes of its tip";
  }
}

TEST(Loaded, MultipliesAllLoads) {
  SpecimenScene specimen{empty_laboratory(), {}};
  add_body(specimen, make_box(Vec3::Ones(), Vec3::Ones(), BoxPattern::kuhn), laboratory_material("brick"));
  specimen.scene.bodies[0].loads = {traction_on(end_region(Vec3::UnitX(), 0.5), Vec3(2, 0, 0))};
  EXPECT_EQ(loaded(specimen, 1.5).scene.bodies[0].loads[0].traction, Vec3(3, 0, 0));
}

/// The tip of a crack is at its critical load if it gives back G_c: half of K_Ic gives back a quarter.
TEST(Laboratory, FractureEnergyIsThatOfToughness) {
  Material glass = laboratory_material("soda_lime_glass");
  const double energy = fracture_energy(glass);
  EXPECT_NEAR(energy, 7.85, 0.01);
  glass.fracture_toughness /= 2;
  EXPECT_NEAR(fracture_energy(glass), energy / 4, 1e-9);
}

}  // namespace
}  // namespace griffith::app
