#include "sim/fracture/crack_front.h"

#include <gtest/gtest.h>

#include "sim/fracture/slit_tips.h"
#include "sim/mesh/shapes.h"
#include "sim/mesh/topology.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

using testing::RandomValues;

/// A slit box without Poisson's effect, opened by a uniform gap between the sides of the slit.
struct SlitBox {
  TetMesh mesh;
  std::vector<NodeId> tips;

  explicit SlitBox(BoxPattern pattern)
      : mesh(build_mesh(make_notched_beam(Vec3(1, 1, 0.5), 0.5, Vec3::Constant(0.25), pattern))),
        tips(slit_tips(mesh)) {}
};

class CrackFront : public ::testing::TestWithParam<BoxPattern> {};

TEST_P(CrackFront, TheSidesOfASlitAreFoundAtItsTips) {
  const SlitBox box(GetParam());
  ASSERT_EQ(box.tips.size(), 3);
  for (const NodeId tip : box.tips) {
    const std::vector<OpenFace> faces = open_faces_at(box.mesh, std::span(&tip, 1));
    ASSERT_FALSE(faces.empty());
    double area = 0;
    for (const OpenFace& face : faces) {
      area += third_of_face(box.mesh, face.first, face.first_corners).norm();
      for (int i = 0; i < 3; ++i)
        EXPECT_EQ(box.mesh.rest_positions[box.mesh.tets[face.first][face.first_corners[i]]],
                  box.mesh.rest_positions[box.mesh.tets[face.second][face.second_corners[i]]]);
    }
    EXPECT_GT(area, 0);
  }
}

/// The crack behind the tips is open by `gap`; elements pull the tip's upper half up and its lower half down.
double release_rate(const SlitBox& box, NodeId tip, const Vec3& gap, double force, const Mat3& turn) {
  std::vector<Corners> star;
  std::vector<Vec3> forces;
  for (const TetId tet : box.mesh.stars[tip]) {
    const bool upper = rest_centroid(box.mesh, tet).x() > 0;
    Corners corners;
    for (int i = 0; i < 4; ++i) {
      const NodeId node = box.mesh.tets[tet][i];
      const Vec3& place = box.mesh.rest_positions[node];
      const bool opens = place.x() == 0 && place.y() < -1e-9 && upper;
      corners.col(i) = turn * (place + (opens ? gap : Vec3(Vec3::Zero())));
    }
    star.push_back(corners);
    forces.push_back(turn * Vec3(upper ? force : -force, 0, 0) * rest_volume(box.mesh, tet));
  }
  return best_advance(box.mesh, tip, star, forces, turn * Vec3::UnitX(), Vec3::Zero()).energy_release;
}

TEST_P(CrackFront, ReleasesHalfOfForceTimesOpeningWhicheverWayTheBodyIsTurned) {
  if (GetParam() == BoxPattern::bcc) GTEST_SKIP() << "its tets straddle the plane of the slit";
  const SlitBox box(GetParam());
  const NodeId tip = box.tips[1];
  const double rate = release_rate(box, tip, Vec3(1e-5, 0, 0), 1e9, Mat3::Identity());
  EXPECT_GT(rate, 0);
  EXPECT_NEAR(release_rate(box, tip, Vec3(2e-5, 0, 0), 1e9, Mat3::Identity()), 2 * rate, 1e-9 * rate);
  EXPECT_NEAR(release_rate(box, tip, Vec3(1e-5, 0, 0), 3e9, Mat3::Identity()), 3 * rate, 1e-9 * rate);
  EXPECT_NEAR(release_rate(box, tip, Vec3(1e-5, 1e-5, 2e-5), 1e9, Mat3::Identity()), rate, 1e-9 * rate)
      << "a slip across the force releases nothing";
  EXPECT_EQ(release_rate(box, tip, Vec3(1e-5, 0, 0), -1e9, Mat3::Identity()), 0) << "pressed together";
  EXPECT_EQ(release_rate(box, tip, Vec3::Zero(), 1e9, Mat3::Identity()), 0);
  RandomValues random(3);
  for (int i = 0; i < 10; ++i) {
    const Mat3 turn = Quat::FromTwoVectors(random.direction(), random.direction()).toRotationMatrix();
    EXPECT_NEAR(release_rate(box, tip, Vec3(1e-5, 0, 0), 1e9, turn), rate, 1e-6 * rate);
  }
}

TEST_P(CrackFront, TetsBesideOpenFacesStayOnTheirSideOfATiltedPlane) {
  const SlitBox box(GetParam());
  RandomValues random(5);
  for (const NodeId tip : box.tips)
    for (int i = 0; i < 10; ++i) {
      const Vec3 normal = (Vec3::UnitX() + 0.4 * random.direction()).normalized();
      std::vector<Corners> star;
      for (const TetId tet : box.mesh.stars[tip]) {
        Corners corners;
        for (int c = 0; c < 4; ++c) corners.col(c) = box.mesh.rest_positions[box.mesh.tets[tet][c]];
        star.push_back(corners);
      }
      const std::vector<std::uint8_t> above = sides_of_crack(box.mesh, tip, star, normal);
      for (const OpenFace& face : open_faces_at(box.mesh, std::span(&tip, 1)))
        for (const TetId tet : {face.first, face.second}) {
          const auto index = std::ranges::lower_bound(box.mesh.stars[tip], tet) - box.mesh.stars[tip].begin();
          EXPECT_EQ(above[index] != 0, rest_centroid(box.mesh, tet).x() > 0);
        }
    }
}

TEST_P(CrackFront, NoPlaneReleasesMoreThanTheBound) {
  const SlitBox box(GetParam());
  RandomValues random(7);
  double closest = 0;
  for (int i = 0; i < 2000; ++i) {
    const NodeId tip = box.tips[i % 3];
    const Mat3 part = random.matrix(), stress = part + part.transpose();
    std::vector<Vec3> places(box.mesh.rest_positions.begin(), box.mesh.rest_positions.end());
    for (Vec3& place : places) place += random.vector(1e-4);
    std::vector<Corners> star;
    std::vector<Vec3> forces;
    for (const TetId tet : box.mesh.stars[tip]) {
      Corners& corners = star.emplace_back();
      for (int c = 0; c < 4; ++c) corners.col(c) = places[box.mesh.tets[tet][c].index()];
      const Vec3 third = third_of_face(box.mesh, tet, kTetFaces[local_corner(box.mesh, tet, tip)]);
      forces.push_back((stress + random.uniform() * Mat3::Identity()) * third);
    }
    const double bound = energy_release_bound(box.mesh, tip, star, forces);
    const double rate = best_advance(box.mesh, tip, star, forces, random.direction(), Vec3::Zero()).energy_release;
    EXPECT_LE(rate, bound);
    closest = std::max(closest, rate / bound);
  }
  EXPECT_GT(closest, 0.2) << "a bound far from all rates screens nothing";
}

INSTANTIATE_TEST_SUITE_P(Patterns, CrackFront,
                         ::testing::Values(BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc));

}  // namespace
}  // namespace griffith
