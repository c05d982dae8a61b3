#include "sim/mesh/shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "sim/core/error.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/topology.h"
#include "tests/mesh/mesh_invariants.h"
#include "tests/mesh/pattern_name.h"

namespace griffith {
namespace {

using std::numbers::pi;
using ::testing::IsEmpty;

class ShapeTest : public ::testing::TestWithParam<BoxPattern> {
 protected:
  /// Checks what holds for every shape and returns its report.
  static MeshReport check(TetSoup soup) {
    for (const auto& [a, b, c, d] : soup.tets)
      EXPECT_GT(signed_volume(soup.points[a], soup.points[b], soup.points[c], soup.points[d]), 0);
    const MeshReport report = prepare(soup);
    EXPECT_THAT(testing::check_invariants(build_mesh(soup)), IsEmpty());
    EXPECT_EQ(report.pieces, 1);
    EXPECT_EQ(report.slivers, 0) << "worst quality " << report.worst_quality;
    EXPECT_EQ(report.removed_nodes + report.removed_tets + report.reoriented_tets + report.overlapping_faces, 0);
    return report;
  }
};

/// Area of a regular polygon on the unit circle, with `sides` corners.
double polygon_area(int sides) { return 0.5 * sides * std::sin(2 * pi / sides); }

TEST_P(ShapeTest, CylinderIsARegularPrism) {
  for (double element_size : {2.0, 0.6, 0.3}) {
    const MeshReport report = check(make_cylinder(1.5, 2.5, Vec2(element_size, 0.7), GetParam()));
    EXPECT_EQ(report.coincident_nodes, 0);
    const int core = std::max(2, static_cast<int>(std::round(1.2 * 1.5 / element_size)));
    const double volume = polygon_area(4 * core) * 1.5 * 1.5 * 2.5;
    EXPECT_NEAR(report.volume, volume, 1e-12 * volume);
    EXPECT_NEAR(report.maximum.z(), 1.25, 1e-12);
    EXPECT_NEAR(report.minimum.z(), -1.25, 1e-12);
  }
}

TEST_P(ShapeTest, SphereConvergesWithTheSquareOfTheElementSize) {
  const auto error = [&](double element_size) {
    const MeshReport report = check(make_sphere(1, element_size, GetParam()));
    EXPECT_EQ(report.coincident_nodes, 0);
    return 1 - report.volume / (4 * pi / 3);
  };
  const double coarse = error(0.3), fine = error(0.15);
  EXPECT_GT(coarse, 0);
  EXPECT_GT(fine, 0);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.15);
}

TEST_P(ShapeTest, PlateLosesThePolygonOfTheHole) {
  for (const Vec3& size : {Vec3(1, 1, 0.1), Vec3(3, 1, 0.2), Vec3(1, 2.5, 0.1), Vec3(1.04, 1, 0.1)})
    for (double radius : {0.1, 0.3}) {
      const MeshReport report = check(make_plate_with_hole(size, radius, Vec2(0.2, 0.1), GetParam()));
      EXPECT_EQ(report.coincident_nodes, 0);
      EXPECT_TRUE(report.maximum.isApprox(size / 2, 1e-12) && report.minimum.isApprox(-size / 2, 1e-12));
      // Five cells on each side of the middle square: a regular polygon of 20 sides.
      const double volume = (size.x() * size.y() - polygon_area(20) * radius * radius) * size.z();
      EXPECT_NEAR(report.volume, volume, 1e-12 * volume);
    }
}

TEST_P(ShapeTest, NotchedBeamIsABoxWithASlit) {
  const Vec3 size(4, 1, 0.5);
  const double depth = 0.37;
  TetSoup soup = make_notched_beam(size, depth, Vec3(0.2, 0.1, 0.25), GetParam());
  const MeshReport report = check(soup);
  EXPECT_NEAR(report.volume, size.prod(), 1e-12 * size.prod());
  EXPECT_EQ(report.coincident_nodes, 4 * 3) << "four rows of three nodes below the tip";
  const TetMesh mesh = build_mesh(soup);
  double slit_area = 0, area = 0;
  for (const auto& [tet, face] : surface_faces(mesh)) {
    const auto [a, b, c] = face_nodes(mesh, tet, face);
    const auto& x = mesh.rest_positions;
    const double face_area = (x[b] - x[a]).cross(x[c] - x[a]).norm() / 2;
    const bool in_middle = std::abs(x[a].x()) + std::abs(x[b].x()) + std::abs(x[c].x()) < 1e-12;
    (in_middle ? slit_area : area) += face_area;
    EXPECT_TRUE(!in_middle || std::max({x[a].y(), x[b].y(), x[c].y()}) < depth - size.y() / 2 + 1e-12);
  }
  EXPECT_NEAR(slit_area, 2 * depth * size.z(), 1e-12);
  EXPECT_NEAR(area, 2 * (4 * 1 + 1 * 0.5 + 4 * 0.5), 1e-12);
}

TEST_P(ShapeTest, RefusesWhatIsNoShape) {
  const double nan = std::nan("");
  for (double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(make_cylinder(bad, 1, Vec2(1, 1), GetParam()), InputError);
    EXPECT_THROW(make_cylinder(1, bad, Vec2(1, 1), GetParam()), InputError);
    EXPECT_THROW(make_cylinder(1, 1, Vec2(bad, 1), GetParam()), InputError);
    EXPECT_THROW(make_cylinder(1, 1, Vec2(1, bad), GetParam()), InputError);
    EXPECT_THROW(make_sphere(bad, 1, GetParam()), InputError);
    EXPECT_THROW(make_sphere(1, bad, GetParam()), InputError);
    EXPECT_THROW(make_plate_with_hole(Vec3(bad, 1, 1), 0.1, Vec2(1, 1), GetParam()), InputError);
    EXPECT_THROW(make_plate_with_hole(Vec3(1, 1, bad), 0.1, Vec2(1, 1), GetParam()), InputError);
    EXPECT_THROW(make_plate_with_hole(Vec3(1, 2, 1), bad, Vec2(1, 1), GetParam()), InputError);
    EXPECT_THROW(make_plate_with_hole(Vec3(1, 2, 1), 0.1, Vec2(bad, 1), GetParam()), InputError);
    EXPECT_THROW(make_notched_beam(Vec3(bad, 1, 1), 0.5, Vec3::Ones(), GetParam()), InputError);
    EXPECT_THROW(make_notched_beam(Vec3::Ones(), bad, Vec3::Ones(), GetParam()), InputError);
  }
  EXPECT_THROW(make_plate_with_hole(Vec3(1, 2, 1), 0.5, Vec2(1, 1), GetParam()), InputError);
  EXPECT_THROW(make_notched_beam(Vec3::Ones(), 1, Vec3::Ones(), GetParam()), InputError);
  EXPECT_THROW(make_sphere(1, 1e-4, GetParam()), InputError);
  EXPECT_THROW(make_cylinder(1, 1, Vec2(1e-4, 1), GetParam()), InputError);
  EXPECT_THROW(make_plate_with_hole(Vec3::Ones(), 1e-3, Vec2(1e-4, 1), GetParam()), InputError);
}

INSTANTIATE_TEST_SUITE_P(Patterns, ShapeTest,
                         ::testing::Values(BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc),
                         testing::pattern_name);

}  // namespace
}  // namespace griffith
