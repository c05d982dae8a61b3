#include "sim/fracture/mean_tension.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "sim/elasticity/element.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/shapes.h"
#include "sim/mesh/topology.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

using testing::RandomValues;

constexpr double kSize = 0.05;  // of the cells [m]

/// A box with a stress of its own in each tet, given at the tet's centroid, in a body turned as a whole.
struct StressField {
  TetMesh mesh;
  std::vector<RestElement> rest_elements;
  std::vector<ElementState> states;
  std::vector<NodeConstraint> constraints;
  std::vector<std::uint8_t> at_crack_front;
  double depth = 10;  ///< [m]

  StressField(TetMesh made, const std::function<Mat3(const Vec3&)>& stress, const Mat3& turn = Mat3::Identity())
      : mesh(std::move(made)), constraints(mesh.rest_positions.size()), at_crack_front(mesh.rest_positions.size()) {
    for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
      const TetId tet(static_cast<std::int64_t>(i));
      Corners corners;
      for (int c = 0; c < 4; ++c) corners.col(c) = mesh.rest_positions[mesh.tets[tet][c]];
      rest_elements.push_back(rest_element(corners));
      const Mat3 acting = stress(rest_centroid(mesh, tet));
      ElementState state;
      state.frame = turn;
      state.stress = {acting(0, 0), acting(1, 1), acting(2, 2), acting(0, 1), acting(0, 2), acting(1, 2)};
      states.push_back(state);
    }
  }

  SeparationInput input() const { return {mesh.tets, mesh.stars, rest_elements, states, constraints}; }
  NodeId nearest(const Vec3& place) const {
    const auto distance = [&](const Vec3& other) { return (other - place).norm(); };
    return NodeId(std::ranges::min_element(mesh.rest_positions, {}, distance) - mesh.rest_positions.begin());
  }
  TensionZone zone(NodeId node, double length) const {
    return TensionZones(mesh, at_crack_front).zone_of(node, length, depth);
  }
  double mean(NodeId node, double length, const Vec3& normal) const {
    return mean_tension(input(), zone(node, length), normal);
  }
};

TetMesh box(BoxPattern pattern) { return build_mesh(make_box(Vec3(1, 1, 1), Vec3::Constant(kSize), pattern)); }

/// Tension along x.
Mat3 pull(double stress) { return Vec3(stress, 0, 0).asDiagonal(); }

class MeanTension : public ::testing::TestWithParam<BoxPattern> {};

TEST_P(MeanTension, OfAUniformStressIsThatStressHoweverTheBodyIsTurned) {
  RandomValues random(1);
  for (int i = 0; i < 5; ++i) {
    const Mat3 turn = Quat::FromTwoVectors(random.direction(), random.direction()).toRotationMatrix();
    const StressField body(
        box(GetParam()), [](const Vec3&) { return pull(3e6); }, turn);
    const NodeId node = body.nearest(0.3 * random.direction());
    EXPECT_NEAR(body.mean(node, 1, turn.col(0)), 3e6, 1);
    EXPECT_NEAR(body.mean(node, 1, turn.col(1)), 0, 1);
  }
}

TEST_P(MeanTension, InsideALinearStressIsThatOfTheNode) {
  const StressField body(box(GetParam()), [](const Vec3& place) { return pull(2e6 + 1e6 * place.x()); });
  EXPECT_NEAR(body.mean(body.nearest(Vec3::Zero()), 1, Vec3::UnitX()), 2e6, 2e4);
}

/// A half ball under a surface, of weight 1 − r/R, has its center of gravity 0.3 R below it.
TEST_P(MeanTension, AtTheSurfaceOfABentBodyIsThatAThirdOfTheRadiusBelow) {
  const StressField body(box(GetParam()), [](const Vec3& place) { return pull(1e6 * place.z()); });
  const NodeId top = body.nearest(Vec3(0, 0, 0.5));
  const double length = 1.5, radius = body.zone(top, length).radius;
  EXPECT_DOUBLE_EQ(radius, 0.24 * length);
  EXPECT_NEAR(body.mean(top, length, Vec3::UnitX()) / 1e6, 0.5 - 0.3 * radius, 0.01);
}

/// Mean of σ = K/√(2πr) cos(θ/2) (1 + sin(θ/2) sin(3θ/2)) along a straight front with the weights 1 − r/R of a ball:
/// 1.2224 · K/√(2πR) in a thin disc, where the square root's mean is 1.6, and 0.764 that of the angle.
TEST_P(MeanTension, AheadOfACrackFollowsItsStressIntensity) {
  constexpr double kIntensity = 1e6;  // [Pa√m]
  const auto near_tip = [](const Vec3& place) {
    const double r = std::hypot(place.x(), place.y()), half = std::atan2(place.x(), place.y()) / 2;
    const double stress = kIntensity / std::sqrt(2 * std::numbers::pi * r);
    return pull(stress * std::cos(half) * (1 + std::sin(half) * std::sin(3 * half)));
  };
  const Vec3 size(1, 1, kSize / 4);
  StressField body(build_mesh(make_box(size, Vec3::Constant(kSize / 4), GetParam())), near_tip);
  const NodeId tip = body.nearest(Vec3(0, 0, size.z() / 2));
  body.at_crack_front[tip.index()] = 1;
  for (const double length : {0.2, 0.4}) {
    const double radius = body.zone(tip, length).radius;
    EXPECT_DOUBLE_EQ(radius, std::numbers::pi / 4 * length);
    EXPECT_NEAR(
        body.mean(tip, length, Vec3::UnitX()) / (1.2224 * kIntensity / std::sqrt(2 * std::numbers::pi * radius)), 1,
        0.06);
  }
}

TEST_P(MeanTension, OfCompressionIsNone) {
  const StressField body(box(GetParam()), [](const Vec3&) { return pull(-3e6); });
  EXPECT_EQ(body.mean(body.nearest(Vec3::Zero()), 1, Vec3::UnitX()), 0);
}

TEST_P(MeanTension, ReachesNoFartherThanHalfOfAPlatesThickness) {
  StressField body(box(GetParam()), [](const Vec3&) { return pull(1); });
  body.depth = 2.5 * kSize;
  EXPECT_EQ(body.zone(body.nearest(Vec3::Zero()), 1).radius, 2.5 * kSize);
}

TEST_P(MeanTension, HasNoZoneWhereElementsAreLarger) {
  const StressField body(box(GetParam()), [](const Vec3&) { return pull(1); });
  EXPECT_TRUE(body.zone(body.nearest(Vec3::Zero()), 0.1 * kSize).parts.empty());
}

TEST_P(MeanTension, DoesNotReachAcrossAnOpenCrack) {
  const TetMesh slit = build_mesh(make_notched_beam(Vec3(1, 1, kSize), 1 - kSize, Vec3::Constant(kSize), GetParam()));
  const StressField body(slit, [](const Vec3& place) { return pull(place.x() > 0 ? 5e6 : 1e6); });
  for (const TensionZone::Part& part : body.zone(body.nearest(Vec3(3 * kSize, -0.3, 0)), 0.3).parts)
    EXPECT_GT(rest_centroid(body.mesh, part.tet).x(), 0);
}

INSTANTIATE_TEST_SUITE_P(Patterns, MeanTension,
                         ::testing::Values(BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc));

}  // namespace
}  // namespace griffith
