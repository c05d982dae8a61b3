#include "sim/elasticity/plasticity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/elasticity/elastic_body.h"
#include "tests/elasticity/random_element.h"

namespace griffith {
namespace {

using testing::ElasticBody;
using testing::RandomValues;

Material steel(ElementModel model = ElementModel::corotational) {
  Material material = *find_material_preset("mild_steel");
  material.element_model = model;
  return material;
}

double von_mises(const Mat3& stress) {
  const Mat3 deviator = stress - stress.trace() / 3 * Mat3::Identity();
  return std::sqrt(1.5) * deviator.norm();
}

Mat3 random_strain(RandomValues& random, double size) {
  const Mat3 m = random.matrix(size);
  return 0.5 * (m + m.transpose());
}

Mat3 deviator(const Mat3& m) { return m - m.trace() / 3 * Mat3::Identity(); }

class Plasticity : public ::testing::TestWithParam<ElementModel> {};
INSTANTIATE_TEST_SUITE_P(Models, Plasticity, ::testing::Values(ElementModel::corotational, ElementModel::green_strain));

TEST(PlasticLaw, BrittleMaterialsHaveNone) { EXPECT_FALSE(plastic_law(Material{})); }

TEST(PlasticFlow, StressNeverPassesTheYieldStrength) {
  RandomValues random(1);
  const ElasticLaw law = elastic_law(steel());
  const PlasticLaw plastic = *plastic_law(steel());
  for (int i = 0; i < 1000; ++i) {
    const ElementDeformation deformation{Mat3::Identity(), random_strain(random, 0.01), false};
    const Mat3 elastic = element_state(law, deformation).stress;
    const Mat3 stress = element_state(law, deformation, flow(plastic, deformation, Mat3::Zero())).stress;
    EXPECT_NEAR(von_mises(stress), std::min(von_mises(elastic), *steel().yield_strength),
                1e-6 * *steel().yield_strength);
    EXPECT_NEAR(stress.trace(), elastic.trace(), 1e-9 * elastic.norm()) << "pressure does not flow";
  }
}

TEST(PlasticFlow, BelowYieldItIsExactlyElastic) {
  RandomValues random(2);
  const PlasticLaw plastic = *plastic_law(steel());
  for (int i = 0; i < 100; ++i) {
    const Mat3 before = deviator(random_strain(random, 0.01));
    const Mat3 strain = before + 0.9 * plastic.yield_strain * random_strain(random, 1).normalized();
    EXPECT_EQ(flow(plastic, {Mat3::Identity(), strain, false}, before), before);
  }
}

TEST(PlasticFlow, StrainIsTracelessLimitedAndDissipates) {
  RandomValues random(3);
  const ElasticLaw law = elastic_law(steel());
  const PlasticLaw plastic = *plastic_law(steel());
  Mat3 plastic_strain = Mat3::Zero();
  int limited = 0;
  for (int i = 0; i < 5000; ++i) {
    const ElementDeformation deformation{Mat3::Identity(), random_strain(random, i % 2 ? 0.4 : 0.01), false};
    const double before = element_state(law, deformation, plastic_strain).energy_density;
    plastic_strain = flow(plastic, deformation, plastic_strain);
    EXPECT_LE(element_state(law, deformation, plastic_strain).energy_density, before);
    EXPECT_LE(plastic_strain.norm(), plastic.limit * (1 + 1e-12));
    EXPECT_LT(std::abs(plastic_strain.trace()), 1e-12);
    limited += plastic_strain.norm() > 0.999 * plastic.limit;
  }
  EXPECT_GT(limited, 100);
}

TEST(PlasticFlow, AnInvertedElementDoesNotFlow) {
  const ElementDeformation folded{Mat3::Identity(), Vec3(0, 0, -1.5).asDiagonal(), true};
  EXPECT_EQ(flow(*plastic_law(steel()), folded, Mat3::Zero()), Mat3::Zero());
}

TEST_P(Plasticity, StrainDoesNotDependOnTheOrientation) {
  RandomValues random(4);
  const PlasticLaw plastic = *plastic_law(steel());
  for (int i = 0; i < 100; ++i) {
    const Corners rest_corners = testing::random_corners(random);
    const RestElement rest = rest_element(rest_corners);
    const Corners corners = testing::shaken(rest_corners, random, 0.02);
    const auto flowed = [&](const Corners& x) {
      return flow(plastic, element_deformation(GetParam(), rest, x), Mat3::Zero());
    };
    EXPECT_GT(flowed(corners).norm(), 0);
    EXPECT_LT((flowed(random.rotation() * corners) - flowed(corners)).norm(), 1e-12);
  }
}

TEST(PlasticFlow, ALoadingCycleTakesTheWorkThatIsDissipated) {
  // Uniaxial strain up to 0.01 and back: elastic to the yield point, flow, elastic unloading into compression.
  const ElasticLaw law = elastic_law(steel());
  const PlasticLaw plastic = *plastic_law(steel());
  const int steps = 2000;
  Mat3 plastic_strain = Mat3::Zero();
  double work = 0, dissipated = 0, peak = 0, previous = 0;
  for (int i = 1; i <= 2 * steps; ++i) {
    const double strain = 0.01 * (i <= steps ? i : 2 * steps - i) / steps;
    const ElementDeformation deformation{Mat3::Identity(), Vec3(strain, 0, 0).asDiagonal(), false};
    const double trial_energy = element_state(law, deformation, plastic_strain).energy_density;
    plastic_strain = flow(plastic, deformation, plastic_strain);
    const ElementState state = element_state(law, deformation, plastic_strain);
    dissipated += trial_energy - state.energy_density;
    work += 0.5 * (previous + state.stress.full()(0, 0)) * (i <= steps ? 0.01 : -0.01) / steps;
    previous = state.stress.full()(0, 0);
    peak = std::max(peak, von_mises(state.stress));
  }
  EXPECT_NEAR(peak, *steel().yield_strength, 1e-6 * peak);
  EXPECT_GT(plastic_strain(0, 0), 0);
  EXPECT_LT(previous, 0) << "the permanent strain is pressed back";
  const ElementDeformation closed;
  EXPECT_NEAR(work, dissipated + element_state(law, closed, plastic_strain).energy_density, 1e-2 * work);
}

TEST_P(Plasticity, AStretchedBarKeepsItsPermanentStrain) {
  Material material = steel(GetParam());
  material.young_modulus = 1e6;
  material.yield_strength = 1e4;
  ElasticBody bar(make_box(Vec3(2, 1, 1), Vec3::Constant(0.5), BoxPattern::five_tet), material);
  const Vec3 stretch(1.1, 1 / std::sqrt(1.1), 1 / std::sqrt(1.1));
  for (Vec3& position : bar.positions) position = stretch.cwiseProduct(position);
  bar.flow_plastically();
  const Vec3 strain = bar.plastic_strains.front().diagonal();
  EXPECT_GT(strain[0], 0.05);
  const Vec3 permanent = GetParam() == ElementModel::corotational ? Vec3(Vec3::Ones() + strain)
                                                                  : Vec3((Vec3::Ones() + 2 * strain).cwiseSqrt());
  // Half the load is taken off at once and the rest let go: an overshoot from the full load would yield again.
  for (std::size_t i = 0; i < bar.positions.size(); ++i)
    bar.positions[i] = 0.5 * (stretch + permanent).cwiseProduct(bar.mesh.rest_positions[i]);
  bar.integrate(4000, 2e-4, 1, 30);
  EXPECT_LT(bar.elastic_energy(), 1e-9 * material.young_modulus) << "it lies free of stress";
  double left = 0, right = 0;
  for (const Vec3& position : bar.positions) left = std::min(left, position.x()), right = std::max(right, position.x());
  EXPECT_NEAR(right - left, 2 * permanent[0], 1e-5);
}

TEST_P(Plasticity, ABarStretchedBelowYieldSpringsBack) {
  Material material = steel(GetParam());
  material.young_modulus = 1e6;
  material.yield_strength = 1e5;
  ElasticBody bar(make_box(Vec3(2, 1, 1), Vec3::Constant(0.5), BoxPattern::five_tet), material);
  for (Vec3& position : bar.positions) position.x() *= 1.05;
  bar.integrate(4000, 2e-4, 1, 30);
  for (const Mat3& strain : bar.plastic_strains) EXPECT_EQ(strain, Mat3::Zero());
  EXPECT_LT(bar.elastic_energy(), 1e-9 * material.young_modulus);
}

}  // namespace
}  // namespace griffith
