#include "sim/fracture/strength_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "sim/fracture/fracture_law.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/topology.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

using testing::RandomValues;

Mat3 principal_stress(double x, double y, double z) { return Vec3(x, y, z).asDiagonal(); }

Mat3 random_stress(RandomValues& random) {
  const Mat3 any = random.matrix(1);
  return any + any.transpose();
}

TEST(StrengthSurface, PassesThroughBothUniaxialStrengths) {
  for (const double ratio : {0.01, 0.1, 0.5, 1.0}) {
    EXPECT_NEAR(equivalent_tension(principal_stress(2, 0, 0), ratio), 2, 1e-12);
    EXPECT_NEAR(equivalent_tension(principal_stress(0, -3 / ratio, 0), ratio), 3, 1e-11);
  }
}

// Kamarei, Zeng, Dolbow & Lopez-Pamies 2026: soda-lime glass of 40 MPa in tension and 1000 MPa in compression.
TEST(StrengthSurface, HasThePublishedStrengthsOfGlass) {
  const double ratio = 0.04, strength = 40;
  const auto onset = [&](const Mat3& stress) { return strength / equivalent_tension(stress, ratio); };
  EXPECT_NEAR(onset(principal_stress(1, 1, 0)), 27.0, 0.05);
  EXPECT_NEAR(onset(principal_stress(1, 1, 1)), 27.8, 0.05);
  EXPECT_NEAR(onset(principal_stress(1, -1, 0)), 44.4, 0.05);
}

TEST(StrengthSurface, IsThatOfVonMisesForEqualStrengths) {
  RandomValues random(3);
  for (int i = 0; i < 20; ++i) {
    const Mat3 stress = random_stress(random);
    EXPECT_NEAR(equivalent_tension(stress, 1), von_mises_stress(stress), 1e-12);
  }
}

TEST(StrengthSurface, IsConvexAndKnowsNoDirection) {
  RandomValues random(4);
  for (int i = 0; i < 200; ++i) {
    const Mat3 a = random_stress(random), b = random_stress(random), turn = random.rotation();
    const double ratio = random.uniform(0.01, 1);
    EXPECT_LE(equivalent_tension(a + b, ratio), equivalent_tension(a, ratio) + equivalent_tension(b, ratio) + 1e-12);
    EXPECT_NEAR(equivalent_tension(turn * a * turn.transpose(), ratio), equivalent_tension(a, ratio), 1e-12);
    EXPECT_NEAR(equivalent_tension(7 * a, ratio), 7 * equivalent_tension(a, ratio), 1e-11);
  }
}

/// A rough mesh under a uniform stress, free of supports.
struct UniformBlock {
  TetMesh mesh;
  std::vector<RestElement> rest_elements;
  std::vector<ElementState> states;

  UniformBlock(BoxPattern pattern, const Mat3& deformation, const Material& material) {
    TetSoup soup = make_box(Vec3(1, 1, 1), Vec3::Constant(1.0 / 3), pattern);
    RandomValues random(5);
    for (Vec3& point : soup.points)
      if (point.cwiseAbs().maxCoeff() < 0.49) point += random.vector(0.03);
    mesh = build_mesh(soup);
    for (const auto& tet : mesh.tets) {
      Corners rest;
      for (int i = 0; i < 4; ++i) rest.col(i) = mesh.rest_positions[tet[i]];
      const RestElement& element = rest_elements.emplace_back(rest_element(rest));
      const ElasticLaw law = elastic_law(material);
      states.push_back(element_state(law, element_deformation(law.model, element, deformation * rest)));
    }
  }
  SeparationInput input() const { return {mesh.tets, mesh.stars, rest_elements, states, {}}; }
  double load(NodeId node, const Material& material) const {
    return fracture_law(material).load(input(), node, material, plane(node));
  }
  CandidatePlane plane(NodeId node) const { return candidate_plane(input(), node, separation_tensor(input(), node)); }
};

/// Strains in directions that no element has.
Mat3 strained(const Vec3& strain) {
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  return turn * (Vec3::Ones() + strain).asDiagonal() * turn.transpose();
}

constexpr BoxPattern kEachPattern[] = {BoxPattern::five_tet, BoxPattern::kuhn, BoxPattern::bcc};

TEST(SeparationLoad, IsTheEquivalentTensionOfAUniformStressAtEveryNodeOfEveryMesh) {
  for (const ElementModel model : {ElementModel::corotational, ElementModel::green_strain})
    for (const BoxPattern pattern : kEachPattern)
      for (const Vec3& strain : {Vec3(1, 1, 1), Vec3(1, 1, 0), Vec3(1, 0.5, -1), Vec3(0.1, 0, -2), Vec3(-0.2, 0, -2)}) {
        Material glass = *find_material_preset("soda_lime_glass");
        glass.compressive_strength = 15 * glass.tensile_strength;
        glass.element_model = model;
        const UniformBlock block(pattern, strained(1e-4 * strain), glass);
        const Mat3 stress = cauchy_stress(block.states[0].frame, block.states[0].stress);
        const double expected = std::max(0.0, equivalent_tension(stress, 1.0 / 15));
        for (const NodeId node : IdRange<NodeId>(0, block.mesh.node_count()))
          EXPECT_NEAR(block.load(node, glass), expected, 1e-6 * stress.norm()) << strain.transpose();
      }
}

TEST(SeparationLoad, OfAUniaxialTensionIsThatTension) {
  Material glass = *find_material_preset("soda_lime_glass");
  glass.compressive_strength = 1000e6;
  for (const BoxPattern pattern : kEachPattern) {
    const double lateral = -glass.poisson_ratio;
    const UniformBlock block(pattern, strained(1e-4 * Vec3(1, lateral, lateral)), glass);
    for (const NodeId node : IdRange<NodeId>(0, block.mesh.node_count())) {
      const CandidatePlane plane = block.plane(node);
      EXPECT_NEAR(block.load(node, glass) / plane.stress, 1, 1e-9);
    }
  }
}

TEST(SeparationLoad, IsThePlanesStressWithoutACompressiveStrengthAndItsForceByTheForceCriterion) {
  Material glass = *find_material_preset("soda_lime_glass");
  const UniformBlock block(BoxPattern::kuhn, strained(1e-4 * Vec3(1, 1, 0.3)), glass);
  for (const NodeId node : IdRange<NodeId>(0, block.mesh.node_count()))
    EXPECT_EQ(block.load(node, glass), block.plane(node).stress);
  glass.compressive_strength = 1000e6;
  glass.criterion = FractureCriterion::separation_force;
  for (const NodeId node : IdRange<NodeId>(0, block.mesh.node_count()))
    EXPECT_EQ(block.load(node, glass), block.plane(node).eigenvalue);
}

TEST(SeparationLoad, HydrostaticPressureIsNone) {
  Material glass = *find_material_preset("soda_lime_glass");
  glass.compressive_strength = 1000e6;
  const UniformBlock block(BoxPattern::bcc, strained(-1e-3 * Vec3::Ones()), glass);
  for (const NodeId node : IdRange<NodeId>(0, block.mesh.node_count())) EXPECT_EQ(block.load(node, glass), 0);
}

}  // namespace
TEST(FractureLaws, OneIsThatOfTheMaterialThatAdoptsItAfterAnyOther) {
  std::vector<std::string_view> keys;  // of the criteria, in the order of the table
  for (const FractureLaw& law : fracture_laws())
    if (std::ranges::find(keys, law.key) == keys.end()) keys.push_back(law.key);
  for (const FractureLaw& before : fracture_laws())
    for (const FractureLaw& law : fracture_laws()) {
      Material glass = *find_material_preset("soda_lime_glass");
      adopt(before, glass);
      adopt(law, glass);
      EXPECT_EQ(&fracture_law(glass), &law) << law.label << " after " << before.label;
      EXPECT_EQ(keys[static_cast<std::size_t>(law.criterion)], law.key);
    }
}

/// Microsteps screen nodes by that bound.
TEST(FractureLaws, NoLoadExceedsTheTensionOrTheBoundOfItsLaw) {
  RandomValues random(6);
  for (const FractureLaw& law : fracture_laws()) {
    if (!law.is_stress()) continue;
    Material glass = *find_material_preset("soda_lime_glass");
    adopt(law, glass);
    for (int i = 0; i < 40; ++i) {
      const UniformBlock block(BoxPattern::kuhn, strained(random.vector(1e-4)), glass);
      const Mat3 stress = cauchy_stress(block.states[0].frame, block.states[0].stress);
      double bound = std::max(0.0, largest_principal(stress).value);
      if (law.strength_ratio) bound = std::max(bound, equivalent_tension(stress, law.strength_ratio(glass)));
      for (const NodeId node : IdRange<NodeId>(0, block.mesh.node_count()))
        EXPECT_LE(block.load(node, glass), bound + 1e-6 * stress.norm()) << law.label;
    }
  }
}

}  // namespace griffith
