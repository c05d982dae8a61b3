#include "sim/explicit/explicit_bodies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "sim/elasticity/element_frequency.h"
#include "sim/fracture/strength_surface.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/topology.h"

namespace griffith::explicit_dynamics {
namespace {

/// A box of a mesh as explicit bodies in the world's place and turn, and what it was made of.
struct Box {
  TetMesh mesh;
  std::vector<RestElement> rest_elements;
  std::vector<double> masses;
  Material material;
  ExplicitBodies bodies;

  Box(
      const Vec3& size, double element_size, const Material& of, const std::function<Vec3(const Vec3&)>& place,
      const std::function<Vec3(const Vec3&)>& velocity,
      const std::function<Mat3(std::size_t)>& stress_free_strain = [](std::size_t) { return Mat3(Mat3::Zero()); })
      : mesh(build_mesh(make_box(size, Vec3::Constant(element_size), BoxPattern::five_tet))), material(of) {
    masses.resize(mesh.rest_positions.size(), 0);
    std::vector<std::array<int, 4>> tets;
    for (const auto& tet : mesh.tets) {
      Corners corners;
      for (int i = 0; i < 4; ++i) corners.col(i) = mesh.rest_positions[tet[i]];
      rest_elements.push_back(rest_element(corners));
      for (const NodeId node : tet) masses[node] += material.density * rest_elements.back().volume / 4;
      tets.push_back({tet[0].index(), tet[1].index(), tet[2].index(), tet[3].index()});
    }
    for (std::size_t i = 0; i < masses.size(); ++i) {
      const Vec3& rest = mesh.rest_positions[i];
      bodies.add_node({rest, place(rest) - rest, velocity(rest), Vec3::Zero(), masses[i]});
    }
    std::vector<Mat3> offsets;
    for (std::size_t i = 0; i < tets.size(); ++i) offsets.push_back(stress_free_strain(i));
    bodies.add_body(elastic_law(material), material.density, tets, rest_elements, offsets);
    bodies.finish();
    bodies.set_step(bodies.stable_step(0.9));
  }

  double energy() const {
    double sum = 0;
    for (int i = 0; i < bodies.node_count(); ++i) sum += 0.5 * masses[i] * bodies.velocity(i).squaredNorm();
    for (std::size_t tet = 0; tet < rest_elements.size(); ++tet) {
      Corners corners;
      for (int i = 0; i < 4; ++i) corners.col(i) = bodies.position(mesh.tets[tet][i].index());
      const ElasticLaw law = elastic_law(material);
      sum += rest_elements[tet].volume *
             element_state(law, element_deformation(law.model, rest_elements[tet], corners)).energy_density;
    }
    return sum;
  }
  Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < bodies.node_count(); ++i) sum += masses[i] * bodies.velocity(i);
    return sum;
  }
  Vec3 angular_momentum() const {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < bodies.node_count(); ++i) sum += masses[i] * bodies.position(i).cross(bodies.velocity(i));
    return sum;
  }
  void advance(int steps) {
    std::vector<int> flagged;
    for (int i = 0; i < steps; ++i) {
      bodies.compute_forces();
      bodies.advance(1, flagged);
    }
  }
};

Vec3 at_rest(const Vec3&) { return Vec3::Zero(); }

/// Turned by half a radian and strained by about 1e-3, differently everywhere.
Vec3 bent(const Vec3& rest) {
  const Vec3 strained = rest + 1e-3 * Vec3(rest.x() * rest.y(), 0.5 * rest.z() * rest.z() - rest.y(), rest.x());
  return Eigen::AngleAxisd(0.5, Vec3(1, 2, 3).normalized()) * strained + Vec3(4, 5, 6);
}

Eigen::AngleAxisd turn_of(double angle) { return Eigen::AngleAxisd(angle, Vec3(-1, 1, 2).normalized()); }

class EveryModel : public ::testing::TestWithParam<ElementModel> {};

TEST_P(EveryModel, AccelerationsAreThoseOfTheElementsInDoublePrecision) {
  Material material;
  material.element_model = GetParam();
  Box box(Vec3(1, 1, 1), 0.25, material, bent, at_rest);
  std::vector<Vec3> forces(box.masses.size(), Vec3::Zero());
  double largest = 0;
  for (std::size_t tet = 0; tet < box.rest_elements.size(); ++tet) {
    Corners corners;
    for (int i = 0; i < 4; ++i) corners.col(i) = bent(box.mesh.rest_positions[box.mesh.tets[tet][i]]);
    const ElasticLaw law = elastic_law(material);
    const ElementState state = element_state(law, element_deformation(law.model, box.rest_elements[tet], corners));
    const Corners of_element = nodal_forces(box.rest_elements[tet], state.frame, state.stress);
    for (int i = 0; i < 4; ++i) forces[box.mesh.tets[tet][i]] += of_element.col(i);
    largest = std::max(largest, of_element.norm());
  }
  const double dt = box.bodies.stable_step(0.9);
  box.advance(1);
  for (std::size_t i = 0; i < forces.size(); ++i)
    EXPECT_LT((box.bodies.velocity(i) * box.masses[i] / dt - forces[i]).norm(), 1e-3 * largest) << "node " << i;
}

/// Elements of a piece on a hinge that a crack left may lie in any turn to the body's own.
TEST_P(EveryModel, ForcesTurnWithElementsHoweverFarTheseHaveTurned) {
  Material material;
  material.element_model = GetParam();
  Box straight(Vec3(1, 0.5, 0.5), 0.25, material, bent, at_rest);
  straight.advance(1);
  double largest = 0;
  for (int i = 0; i < straight.bodies.node_count(); ++i)
    largest = std::max(largest, straight.bodies.velocity(i).norm());
  for (const double angle : {1.0, 2.0, 3.0, 4.0, 5.0}) {
    Box turned(
        Vec3(1, 0.5, 0.5), 0.25, material, [&](const Vec3& rest) { return Vec3(turn_of(angle) * bent(rest)); },
        at_rest);
    turned.advance(1);
    for (int i = 0; i < turned.bodies.node_count(); ++i) {
      const Vec3 expected = turn_of(angle) * straight.bodies.velocity(i);
      EXPECT_LT((turned.bodies.velocity(i) - expected).norm(), 0.01 * largest) << angle << " rad, node " << i;
    }
  }
}

TEST_P(EveryModel, MomentumStaysAndEnergyNeverGrows) {
  Material material;
  material.element_model = GetParam();
  Box box(Vec3(1, 0.5, 0.5), 0.125, material, bent, [](const Vec3& rest) { return Vec3(3, rest.z(), -rest.y()); });
  const Vec3 momentum = box.momentum();
  double energy = box.energy();
  const double scale = energy;
  for (int i = 0; i < 50; ++i) {
    box.advance(20);
    EXPECT_LT((box.momentum() - momentum).norm(), 1e-5 * momentum.norm());
    EXPECT_LT(box.energy(), energy + 1e-3 * scale);
    energy = box.energy();
  }
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, ::testing::Values(ElementModel::corotational, ElementModel::green_strain));

TEST(ExplicitBodies, ResidualStressDoesNotSpinABodyUp) {
  const Material glass = *find_material_preset("soda_lime_glass");
  const auto shear = [](std::size_t tet) {
    Mat3 strain = Mat3::Zero();
    strain(0, 1) = strain(1, 0) = 3e-3 * static_cast<double>(tet % 3);
    strain(1, 1) = -4e-3 * static_cast<double>(tet % 2);
    return strain;
  };
  Box box(Vec3(0.02, 0.01, 0.01), 0.005, glass, bent, at_rest, shear);
  double waves = 0;  // scale of angular momentum: that of the parts that move
  for (int i = 0; i < 20; ++i) {
    box.advance(10);
    double sum = 0;
    for (int k = 0; k < box.bodies.node_count(); ++k) sum += box.masses[k] * 0.01 * box.bodies.velocity(k).norm();
    waves = std::max(waves, sum);
  }
  EXPECT_GT(waves, 0);
  EXPECT_LT(box.angular_momentum().norm(), 1e-5 * waves) << box.angular_momentum().norm() / waves;
}

TEST(ExplicitBodies, AWaveRunsThroughABarAtTheBarSpeed) {
  Material material;
  material.poisson_ratio = 0;
  const double length = 2;
  Box box(
      Vec3(length, 0.1, 0.1), 0.05, material, [](const Vec3& rest) { return rest; },
      [&](const Vec3& rest) { return rest.x() < -0.49 * length ? Vec3(1, 0, 0) : Vec3(Vec3::Zero()); });
  int far_end = 0;
  for (int i = 0; i < box.bodies.node_count(); ++i)
    if (box.mesh.rest_positions[i].x() > box.mesh.rest_positions[far_end].x()) far_end = i;
  double time = 0, fastest = 0, arrival = 0;
  const double dt = box.bodies.stable_step(0.9), due = length / bar_wave_speed(material);
  while (time < 1.5 * due) {
    box.advance(1);
    time += dt;
    const double speed = box.bodies.velocity(far_end).x();
    if (speed > fastest) fastest = speed, arrival = time;
  }
  EXPECT_NEAR(arrival / due, 1, 0.06);
}

/// A cube of many elements, of which some were made otherwise.
ExplicitBodies cube_with(
    const std::function<void(std::vector<RestElement>&)>& change,
    const std::function<Vec3(const Vec3&)>& place = [](const Vec3& rest) { return rest; }) {
  Box box(Vec3(2, 2, 2), 0.25, Material(), place, at_rest);
  change(box.rest_elements);
  ExplicitBodies bodies;
  std::vector<std::array<int, 4>> tets;
  for (const auto& tet : box.mesh.tets)
    tets.push_back({tet[0].index(), tet[1].index(), tet[2].index(), tet[3].index()});
  for (std::size_t i = 0; i < box.masses.size(); ++i) {
    const Vec3& rest = box.mesh.rest_positions[i];
    bodies.add_node({rest, place(rest) - rest, Vec3::Zero(), Vec3::Zero(), box.masses[i]});
  }
  bodies.add_body(elastic_law(Material()), Material().density, tets, box.rest_elements,
                  std::vector<Mat3>(tets.size(), Mat3::Zero()),
                  highest_frequency(elastic_law(Material()), Material().density, box.rest_elements));
  bodies.finish();
  return bodies;
}

/// Returns how many nodes of a uniformly strained box are flagged at a threshold [Pa].
std::size_t flagged_nodes(const Material& material, const Vec3& strain, float threshold) {
  Box box(
      Vec3(1, 1, 1), 0.5, material, [&](const Vec3& rest) { return Vec3(rest + strain.cwiseProduct(rest)); }, at_rest);
  box.bodies.set_strength_surface(material);
  for (int i = 0; i < box.bodies.node_count(); ++i) box.bodies.node(i).threshold = threshold;
  std::vector<int> flagged;
  box.bodies.compute_forces();
  box.bodies.advance(1, flagged);
  return flagged.size();
}

TEST(ExplicitBodies, AStrengthSurfaceFlagsNodesByTheirEquivalentTension) {
  Material glass = *find_material_preset("soda_lime_glass");
  const ElasticLaw law = elastic_law(glass);
  const std::size_t all = Box(
                              Vec3(1, 1, 1), 0.5, glass, [](const Vec3& rest) { return rest; }, at_rest)
                              .masses.size();
  for (const Vec3& strain : {Vec3(1e-4, 1e-4, -5e-5), Vec3(1e-4, 1e-4, 1e-4), Vec3(2.2e-4, 2.2e-4, -1e-3)}) {
    const Mat3 stress = Vec3(2 * law.mu * strain + Vec3::Constant(law.lambda * strain.sum())).asDiagonal();
    glass.compressive_strength = 20 * glass.tensile_strength;
    const double largest = std::max(0.0, stress.diagonal().maxCoeff()),
                 load = std::max(largest, equivalent_tension(stress, 0.05));
    ASSERT_GT(load, 1.1 * largest);
    EXPECT_EQ(flagged_nodes(glass, strain, static_cast<float>(0.999 * load)), all);
    EXPECT_EQ(flagged_nodes(glass, strain, static_cast<float>(1.001 * load)), 0U);
    glass.compressive_strength.reset();
    EXPECT_EQ(flagged_nodes(glass, strain, static_cast<float>(1.001 * largest + 1e-2 * load)), 0U);
  }
}

void flatten(RestElement& rest, double fraction) {
  rest.shape_gradients.row(0) /= fraction;
  rest.volume *= fraction;
}

void shrink(RestElement& rest, double fraction) {
  rest.shape_gradients /= fraction;
  rest.volume *= fraction * fraction * fraction;
}

double step_of(const ExplicitBodies& bodies) { return bodies.stable_step(0.9); }

TEST(ExplicitBodies, ASliverDoesNotSetTheStepOfAll) {
  const ExplicitBodies sound = cube_with([](auto&) {});
  const ExplicitBodies flattened = cube_with([](auto& rest_elements) { flatten(rest_elements[7], 1e-3); });
  EXPECT_EQ(step_of(flattened), step_of(sound));
  EXPECT_EQ(flattened.body(0).relieved, 1);
  EXPECT_TRUE(flattened.is_relieved(7));
  EXPECT_EQ(sound.body(0).relieved, 0);
}

TEST(ExplicitBodies, SmallElementsOfGoodShapeKeepTheirStiffnessAndSetTheStep) {
  constexpr double kSize = 1.0 / 16;
  const ExplicitBodies graded = cube_with([](auto& rest_elements) { shrink(rest_elements[7], kSize); });
  EXPECT_EQ(graded.body(0).relieved, 0);
  EXPECT_LT(step_of(graded), 1.1 * kSize * step_of(cube_with([](auto&) {})));
}

TEST(ExplicitBodies, FlatElementsThatAreManyKeepTheirStiffness) {
  const ExplicitBodies plate = cube_with([](auto& rest_elements) {
    for (RestElement& rest : rest_elements) flatten(rest, 0.02);
  });
  EXPECT_LE(plate.body(0).relieved, 0.02 * 2560);
}

TEST(ExplicitBodies, ARelievedSliverStartsWithItsStressAndAnswersMoreStrainWithAShareOfIt) {
  constexpr double kFlat = 0.03;
  const Mat3 stretch = Vec3(1e-3, 5e-4, -2e-4).asDiagonal(), more = Vec3(1e-2, 0, 0).asDiagonal();
  const Mat3 start = Vec3(1e-3 / kFlat, 5e-4, -2e-4).asDiagonal();
  const ExplicitBodies bodies = cube_with(
      [](auto& rest_elements) {
        flatten(rest_elements[7], kFlat);
        shrink(rest_elements[300], 0.035);
      },
      [&](const Vec3& rest) { return Vec3(rest + stretch * rest); });
  ASSERT_TRUE(bodies.is_relieved(7));
  EXPECT_LT((bodies.elastic_strain(7, start) - start).norm(), 1e-4 * start.norm());
  const Mat3 answer = bodies.elastic_strain(7, start + more) - start;
  EXPECT_GT(answer(0, 0), 0.25 * more(0, 0));
  EXPECT_LT(answer(0, 0), 0.9 * more(0, 0));
}

TEST(ExplicitBodies, ASliverTooFlatForAnyShareHasNoStress) {
  const ExplicitBodies bodies = cube_with([](auto& rest_elements) { flatten(rest_elements[7], 1e-3); });
  EXPECT_EQ(bodies.elastic_strain(7, Mat3::Identity()), Mat3::Zero());
}

}  // namespace
}  // namespace griffith::explicit_dynamics
