#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <numbers>

#include "sim/mesh/box_mesh.h"
#include "sim/mesh/write_mesh.h"
#include "sim/scene/body_pose.h"
#include "tests/files/test_folder.h"
#include "tests/random_values.h"
#include "tests/world/loading.h"

namespace griffith::testing {
namespace {

constexpr double kLength = 1.5;  // of bars 1 m across

/// A bar with a mesh out of line.
MeshFileShape bar_on_a_rough_mesh(BoxPattern pattern, int cells) {
  TetSoup bar = make_box(Vec3(kLength, 1, 1), Vec3::Constant(1.0 / cells), pattern);
  RandomValues random(11);
  for (Vec3& point : bar.points) {
    const Vec3 distance = Vec3(kLength, 1, 1) / 2 - point.cwiseAbs();
    if (distance.minCoeff() > 1e-9) point += random.vector(0.1 / cells);
  }
  const std::filesystem::path path = empty_folder() / "bar.msh";
  write_gmsh(path, bar);
  return {path};
}

/// A bar pulled at both ends by the tensile strength. Some scatter decides where it breaks; bars of this size keep the
/// strength on average.
Scene pulled_bar(BoxPattern pattern, int cells, const Vec3& degrees) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  BodyDescription bar;
  bar.shape = bar_on_a_rough_mesh(pattern, cells);
  bar.rotation_degrees = degrees;
  bar.material = *find_material_preset("concrete");
  bar.strength_scatter = StrengthScatter{200, kLength, cells};
  for (double side : {-1.0, 1.0}) {
    Load pull;
    pull.kind = LoadKind::traction;
    pull.region = HalfSpaceRegion{Vec3(side * kLength / 2, 0, 0), Vec3(side, 0, 0)};
    pull.traction = pose_of(bar).rotation * Vec3(side * bar.material.tensile_strength, 0, 0);
    bar.loads.push_back(pull);
  }
  scene.bodies = {bar};
  scene.simulation.impact_substeps = 256;
  return scene;
}

/// The unit normal of the plane that fits best through the faces of the crack that parted the bar, in rest space.
Vec3 crack_normal(const Frame& frame, double half_length) {
  const double start = frame.crack_events.back().rest_position.x();
  std::vector<Vec3> points;
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet)
    for (int face = 0; face < 4; ++face) {
      if (frame.elements.neighbors[tet][face].valid()) continue;
      Vec3 middle = Vec3::Zero();
      for (int corner : kTetFaces[face]) middle += frame.nodes.rest_positions[frame.elements.tets[tet][corner]] / 3;
      // Surfaces of the bar lie at its border.
      if (middle.tail<2>().cwiseAbs().maxCoeff() < 0.49 && std::abs(middle.x()) < 0.99 * half_length &&
          std::abs(middle.x() - start) < 0.25)
        points.push_back(middle);
    }
  Vec3 mean = Vec3::Zero();
  for (const Vec3& point : points) mean += point / static_cast<double>(points.size());
  Mat3 scatter = Mat3::Zero();
  for (const Vec3& point : points) scatter += (point - mean) * (point - mean).transpose();
  return Eigen::SelfAdjointEigenSolver<Mat3>(scatter).eigenvectors().col(0);
}

class BarInTension : public ::testing::TestWithParam<BoxPattern> {};

TEST_P(BarInTension, BreaksAtItsStrengthOnEveryMeshInEveryOrientation) {
  for (int cells : {2, 4, 8})
    for (const Vec3& degrees : {Vec3(0, 0, 0), Vec3(0, 0, 90), Vec3(25, -40, 70)}) {
      const double fraction =
          breaking_fraction(pulled_bar(GetParam(), cells, degrees), {0.945, 1.045, 0.02}, has_parted);
      EXPECT_NEAR(fraction, 1, 0.03) << cells << " cells across, turned by " << degrees.transpose();
    }
}

TEST_P(BarInTension, BreaksAtNearlyTheSameLoadWhenItIsRemeshed) {
  for (const Vec3& degrees : {Vec3(0, 0, 0), Vec3(0, 0, 90), Vec3(25, -40, 70)}) {
    Scene scene = pulled_bar(GetParam(), 4, degrees);
    const LoadRamp ramp{0.9, 1.2, 0.02};
    const double along_faces = breaking_fraction(scene, ramp, has_parted);
    scene.bodies[0].remeshing = true;
    int tets = 0;
    const double remeshed = breaking_fraction(
        scene, ramp, has_parted, [&](const Frame& frame) { tets = static_cast<int>(frame.elements.tets.size()); });
    EXPECT_NEAR(remeshed / along_faces, 1, 0.1) << "turned by " << degrees.transpose();
    EXPECT_GT(tets, static_cast<int>(World(scene).frame().elements.tets.size())) << "tets were cut";
  }
}

/// Between grips that move apart; without lateral contraction, so that the stress stays uniform at the grips.
Scene stretched_bar(BoxPattern pattern, int cells) {
  Scene scene = pulled_bar(pattern, cells, Vec3::Zero());
  BodyDescription& bar = scene.bodies[0];
  bar.loads.clear();
  bar.material.poisson_ratio = 0;
  const double breaking_stretch = kLength * bar.material.tensile_strength / bar.material.young_modulus;
  for (double side : {-1.0, 1.0}) {
    Support grip;
    grip.kind = SupportKind::prescribed;
    grip.region = HalfSpaceRegion{Vec3(side * kLength / 2, 0, 0), Vec3(side, 0, 0)};
    grip.velocity = Vec3(side * breaking_stretch / 2, 0, 0);
    grip.can_tear = false;
    bar.supports.push_back(grip);
  }
  scene.analysis = Analysis::static_;
  scene.simulation.time_step = 0.05;
  return scene;
}

TEST_P(BarInTension, BreaksAcrossTheLoad) {
  for (bool remeshing : {false, true}) {
    Scene scene = stretched_bar(GetParam(), 8);
    scene.bodies[0].remeshing = remeshing;
    World world(scene);
    while (!has_parted(world.frame()) && world.frame().time < 1.5) world.step();
    ASSERT_TRUE(has_parted(world.frame()));
    const auto degrees_off = [](const Vec3& normal) {
      return std::acos(std::min(std::abs(normal.x()), 1.0)) * 180 / std::numbers::pi;
    };
    EXPECT_LT(degrees_off(world.frame().crack_events.front().normal), 5) << "the first crack";
    EXPECT_LT(degrees_off(crack_normal(world.frame(), kLength / 2)), 5) << "the broken face as a whole";
  }
}

INSTANTIATE_TEST_SUITE_P(Patterns, BarInTension,
                         ::testing::Values(BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc));

}  // namespace
}  // namespace griffith::testing
