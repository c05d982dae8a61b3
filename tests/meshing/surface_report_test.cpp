#include "sim/meshing/surface_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "sim/core/error.h"
#include "sim/geometry/triangle.h"
#include "sim/meshing/self_intersection.h"
#include "sim/meshing/triangle_tree.h"
#include "surfaces.h"

namespace griffith {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using namespace griffith::testing;

TriangleSurface unit_box() { return box_surface(Vec3::Zero(), Vec3::Ones()); }

SurfaceReport report_of(TriangleSurface surface) { return prepare_surface(surface); }

TEST(SurfaceReport, SoundSurfacesHaveNoFindings) {
  for (const TriangleSurface& sound : {unit_box(), torus_surface(1, 0.3, 20, 10), sphere_surface(2, 9)}) {
    const SurfaceReport report = report_of(sound);
    EXPECT_THAT(findings(report), IsEmpty());
    EXPECT_TRUE(report.closed());
    EXPECT_EQ(report.shells, 1);
    EXPECT_GT(report.volume, 0);
  }
}

TEST(SurfaceReport, AHoleIsMeasuredAndPlaced) {
  TriangleSurface open = unit_box();
  open.triangles.resize(10);  // without the side at x = 1
  const SurfaceReport report = report_of(open);
  EXPECT_FALSE(report.closed());
  EXPECT_EQ(report.boundary_edges, 4);
  EXPECT_EQ(report.boundary_loops, 1);
  EXPECT_EQ(report.first_boundary.x(), 1);
  EXPECT_THAT(findings(report), Contains(HasSubstr("is open: 4 edges in 1 loop")));
}

TEST(SurfaceReport, RandomFlipsAreUndone) {
  std::mt19937 random(3);
  const TriangleSurface sound = sphere_surface(1, 8);
  for (int sample = 0; sample < 20; ++sample) {
    TriangleSurface mixed = sound;
    int flipped = 0;
    for (auto& triangle : mixed.triangles)
      if (random() % 3 == 0) std::swap(triangle[0], triangle[1]), ++flipped;
    const SurfaceReport report = prepare_surface(mixed);
    EXPECT_NEAR(report.volume, enclosed_volume(sound), 1e-12);
    EXPECT_GT(report.flipped_triangles, 0);
    EXPECT_TRUE(report.closed());
  }
}

TEST(SurfaceReport, InsideOutShellsAreTurnedAndCavitiesKept) {
  TriangleSurface inner = box_surface(Vec3::Constant(0.3), Vec3::Constant(0.7));
  turn_inside_out(inner);
  TriangleSurface hollow = together(unit_box(), inner);
  const double volume = 1 - 0.4 * 0.4 * 0.4;
  SurfaceReport report = report_of(hollow);
  EXPECT_NEAR(report.volume, volume, 1e-12);
  EXPECT_EQ(report.inverted_shells, 0);
  EXPECT_EQ(report.shells, 2);
  turn_inside_out(hollow);
  report = report_of(hollow);
  EXPECT_NEAR(report.volume, volume, 1e-12);
  EXPECT_EQ(report.inverted_shells, 2);
  EXPECT_THAT(findings(report), Contains(HasSubstr("inside out")));
}

TEST(SurfaceReport, AMoebiusStripHasOneSide) {
  constexpr int kAround = 24;
  TriangleSurface strip;
  for (int i = 0; i < kAround; ++i)
    for (const double across : {-0.2, 0.2}) {
      const double u = 2 * std::numbers::pi * i / kAround, r = 1 + across * std::cos(u / 2);
      strip.points.emplace_back(r * std::cos(u), r * std::sin(u), across * std::sin(u / 2));
    }
  for (int i = 0; i < kAround; ++i) {
    const bool last = i == kAround - 1;
    const int a = 2 * i, b = 2 * i + 1, c = last ? 1 : a + 2, d = last ? 0 : b + 2;
    strip.triangles.push_back({a, b, d});
    strip.triangles.push_back({a, d, c});
  }
  const SurfaceReport report = report_of(strip);
  EXPECT_EQ(report.one_sided_shells, 1);
  EXPECT_THAT(findings(report), Contains(HasSubstr("cannot be oriented")));
}

TEST(SurfaceReport, CrowdedEdgesAndPinchedPointsAreFound) {
  TriangleSurface edge = together(unit_box(), box_surface(Vec3(1, 1, 0), Vec3(2, 2, 1)));
  weld_points(edge);
  const SurfaceReport crowded = report_of(edge);
  EXPECT_EQ(crowded.crowded_edges, 1);
  EXPECT_THAT(findings(crowded), Contains(HasSubstr("more than two triangles, the first near (1, 1, 0.5)")));
  TriangleSurface point = together(unit_box(), box_surface(Vec3::Ones(), Vec3::Constant(2)));
  weld_points(point);
  const SurfaceReport pinched = report_of(point);
  EXPECT_EQ(pinched.pinched_points, 1);
  EXPECT_TRUE(pinched.closed());
  EXPECT_THAT(findings(pinched), Contains(HasSubstr("share no edge there, the first at (1, 1, 1)")));
}

TEST(SurfaceReport, CrossingShellsAreFoundAndPlaced) {
  TriangleSurface other = unit_box();
  move(other, Vec3(0.5, 0.25, 0.125));
  const SurfaceReport report = report_of(together(unit_box(), other));
  EXPECT_GT(report.self_intersections.pairs, 0);
  const Vec3& place = report.self_intersections.place;
  EXPECT_TRUE(Eigen::AlignedBox3d(Vec3(0.5, 0.25, 0.125), Vec3::Ones()).exteriorDistance(place) < 1e-9)
      << place.transpose();
  EXPECT_THAT(findings(report), Contains(HasSubstr("passes through itself")));
}

TEST(SurfaceReport, ShellsThatLieOnEachOtherCross) {
  const SurfaceReport report = report_of(together(unit_box(), box_surface(Vec3(0.2, 0.2, 1), Vec3(0.8, 0.8, 2))));
  EXPECT_GT(report.self_intersections.pairs, 0);
  TriangleSurface apart = together(unit_box(), box_surface(Vec3(0.2, 0.2, 1.001), Vec3(0.8, 0.8, 2)));
  EXPECT_EQ(report_of(apart).self_intersections.pairs, 0);
}

TEST(SurfaceReport, CrossingsDoNotDependOnPlaceSizeOrTurn) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  TriangleSurface other = torus_surface(1, 0.3, 16, 8);
  for (Vec3& point : other.points) point = Vec3(point.x() + 1, point.z(), point.y() + 0.03);
  const TriangleSurface linked = together(torus_surface(1, 0.3, 16, 8), other);  // a chain: no crossing
  move(other, Vec3(0.51, 0, 0));
  const TriangleSurface crossed = together(torus_surface(1, 0.3, 16, 8), other);
  const int pairs = report_of(crossed).self_intersections.pairs;
  EXPECT_GT(pairs, 10);
  for (int sample = 0; sample < 10; ++sample) {
    const Quat turn = Quat(normal(random), normal(random), normal(random), normal(random)).normalized();
    const double scale = std::pow(10.0, normal(random));
    const Vec3 shift(normal(random), normal(random), normal(random));
    const auto placed = [&](TriangleSurface surface) {
      for (Vec3& point : surface.points) point = scale * (turn * point + shift);
      return report_of(surface);
    };
    EXPECT_EQ(placed(linked).self_intersections.pairs, 0);
    EXPECT_EQ(placed(crossed).self_intersections.pairs, pairs);
  }
}

TEST(SurfaceReport, RepeatedFlatAndCollapsedTrianglesAreCounted) {
  TriangleSurface repeated = unit_box();
  repeated.triangles.push_back(repeated.triangles[3]);
  repeated.triangles.push_back({1, 1, 2});
  const SurfaceReport report = report_of(repeated);
  EXPECT_EQ(report.removed_triangles, 2);
  EXPECT_TRUE(report.closed());
  EXPECT_THAT(findings(report), Contains(HasSubstr("2 repeated or collapsed triangles")));
  TriangleSurface flat = unit_box();
  flat.points.push_back((flat.points[flat.triangles[0][0]] + flat.points[flat.triangles[0][1]]) / 2);
  flat.triangles.push_back({flat.triangles[0][0], flat.triangles[0][1], 8});
  EXPECT_EQ(report_of(flat).flat_triangles, 1);
  TriangleSurface nothing;
  nothing.points = {Vec3::Zero(), Vec3::Ones()};
  nothing.triangles = {{0, 1, 1}};
  EXPECT_THROW(prepare_surface(nothing), InputError);
}

TEST(SurfaceReport, SizesThatLookLikeAnotherUnitAreMentioned) {
  EXPECT_THAT(findings(report_of(box_surface(Vec3::Zero(), Vec3::Constant(1e-4)))),
              Contains(HasSubstr("larger scale")));
  EXPECT_THAT(findings(report_of(box_surface(Vec3::Zero(), Vec3::Constant(5e3)))),
              Contains(HasSubstr("smaller scale")));
}

TEST(TriangleTree, NearestPointAndWindingNumberAgreeWithAllTriangles) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  const TriangleSurface torus = torus_surface(1, 0.35, 40, 20);
  const TriangleTree tree(torus);
  for (int sample = 0; sample < 300; ++sample) {
    const Vec3 point(uniform(random), uniform(random), uniform(random) / 3);
    double nearest = 1e9;
    for (int i = 0; i < static_cast<int>(torus.triangles.size()); ++i) {
      const std::array<Vec3, 3> corners = corners_of(torus, i);
      const Vec3 w = closest_on_triangle(point, corners);
      nearest = std::min(nearest, (w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2] - point).norm());
    }
    EXPECT_NEAR(tree.nearest(point).distance, nearest, 1e-12);
    const double to_core = std::hypot(std::hypot(point.x(), point.y()) - 1, point.z());
    if (std::abs(to_core - 0.345) < 0.01) continue;
    EXPECT_NEAR(tree.winding_number(point), to_core < 0.345 ? 1 : 0, 0.03);
  }
}

TEST(TriangleTree, HalfASphereWindsHalfRoundItsCenter) {
  TriangleSurface half = sphere_surface(1, 24);
  std::erase_if(half.triangles, [&](const auto& t) {
    return half.points[t[0]].z() + half.points[t[1]].z() + half.points[t[2]].z() < 0;
  });
  EXPECT_NEAR(TriangleTree(half).winding_number(Vec3::Zero()), 0.5, 0.01);
}

/// All pairs of so many triangles would be half a billion.
TEST(SurfaceReport, ATangleIsReportedWithoutCountingEveryPair) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  TriangleSurface tangle;
  for (int i = 0; i < 30'000; ++i) {
    tangle.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    for (int corner = 0; corner < 3; ++corner)
      tangle.points.emplace_back(uniform(random), uniform(random), uniform(random));
  }
  const SelfIntersections found = find_self_intersections(tangle);
  EXPECT_FALSE(found.all_known);
  EXPECT_GT(found.pairs, 2'000'000);
  EXPECT_LE(found.pairs, 3'000'000);
}

}  // namespace
}  // namespace griffith
