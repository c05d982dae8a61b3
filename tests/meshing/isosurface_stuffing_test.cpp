#include "sim/meshing/isosurface_stuffing.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "sim/core/parallel.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/topology.h"
#include "sim/meshing/mesh_quality.h"
#include "tests/mesh/mesh_invariants.h"

namespace griffith {
namespace {

/// Returns the solid of points where `f` is positive, with its border by bisection.
ImplicitSolid solid_of(std::function<double(const Vec3&)> f) {
  ImplicitSolid solid;
  solid.inside = [f](const Vec3& point) { return f(point) > 0; };
  solid.crossing = [f](const Vec3& inner, const Vec3& outer) {
    double low = 0, high = 1;
    for (int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2;
      (f(inner + middle * (outer - inner)) > 0 ? low : high) = middle;
    }
    return low;
  };
  return solid;
}

Eigen::AlignedBox3d cube(double half) { return {Vec3::Constant(-half), Vec3::Constant(half)}; }

double volume_of(const TetSoup& soup) {
  double volume = 0;
  for (const auto& [a, b, c, d] : soup.tets)
    volume += signed_volume(soup.points[a], soup.points[b], soup.points[c], soup.points[d]);
  return volume;
}

TEST(IsosurfaceStuffing, DihedralAnglesStayWithinTheProvenBounds) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double minimum = 180, maximum = 0;
  for (int sample = 0; sample < 15; ++sample) {
    const Vec3 wave(3 * uniform(random), 3 * uniform(random), 3 * uniform(random)), center(uniform(random), 0, 0);
    const double wildness = sample % 3, radius = 0.8 + 0.4 * uniform(random);
    const auto field = [=](const Vec3& p) {
      return radius - (p - 0.2 * center).norm() + 0.2 * wildness * std::sin(2 * wave.dot(p)) * std::cos(5 * p.x());
    };
    const TetSoup soup = stuff_isosurface(solid_of(field), cube(1.6), 0.11 + 0.05 * uniform(random), "test");
    const MeshQuality quality = mesh_quality(soup);
    minimum = std::min(minimum, quality.min_dihedral);
    maximum = std::max(maximum, quality.max_dihedral);
  }
  EXPECT_GT(minimum, 10.78);
  EXPECT_LT(maximum, 164.75);
}

/// Returns a pseudorandom number in [0, 1) that depends on the point.
double hash_of(const Vec3& p, double seed) {
  const double value = std::sin(p.dot(Vec3(12.9898, 78.233, 37.719)) + seed) * 43758.5453;
  return value - std::floor(value);
}

TEST(IsosurfaceStuffing, DihedralAnglesKeepTheirBoundsInNoise) {
  for (int seed = 0; seed < 4; ++seed) {
    ImplicitSolid noise;
    noise.inside = [=](const Vec3& p) { return p.cwiseAbs().maxCoeff() < 1 && hash_of(p, seed) < 0.3 + 0.15 * seed; };
    noise.crossing = [=](const Vec3& inner, const Vec3& outer) { return hash_of(inner + 0.7 * outer, seed + 0.5); };
    TetSoup soup = stuff_isosurface(noise, cube(1), 0.1, "noise");
    const MeshQuality quality = mesh_quality(soup);
    EXPECT_GT(quality.min_dihedral, 10.78);
    EXPECT_LT(quality.max_dihedral, 164.75);
    EXPECT_EQ(prepare(soup).overlapping_faces, 0);
  }
}

TEST(IsosurfaceStuffing, VolumeOfABallConvergesInSecondOrder) {
  const auto error = [](double edge) {
    const auto ball = solid_of([](const Vec3& p) { return 1 - p.norm(); });
    return 1 - volume_of(stuff_isosurface(ball, cube(1), edge, "ball")) / (4 * std::numbers::pi / 3);
  };
  const double coarse = error(0.25), fine = error(0.125);
  EXPECT_LT(std::abs(coarse), 0.04);
  EXPECT_LT(std::abs(fine), 0.35 * std::abs(coarse));
}

TEST(IsosurfaceStuffing, EveryTetIsPositiveAndFacesMatch) {
  const auto blob =
      solid_of([](const Vec3& p) { return 0.9 - p.norm() + 0.3 * std::sin(7 * p.x()) * std::cos(6 * p.y()); });
  TetSoup soup = stuff_isosurface(blob, cube(1.4), 0.15, "blob");
  const MeshReport report = prepare(soup);
  EXPECT_EQ(report.reoriented_tets, 0);
  EXPECT_EQ(report.removed_tets, 0);
  EXPECT_EQ(report.overlapping_faces, 0);
  EXPECT_EQ(report.pinched_nodes + report.pinched_edges, 0);
  EXPECT_TRUE(testing::check_invariants(build_mesh(soup)).empty());
  // No face inside: all free faces lie on the border.
  const TetMesh mesh = build_mesh(soup);
  for (const SurfaceFace& face : surface_faces(mesh))
    for (const NodeId node : face_nodes(mesh, face.tet, face.face)) {
      const Vec3& p = mesh.rest_positions[node];
      EXPECT_NEAR(0.9 - p.norm() + 0.3 * std::sin(7 * p.x()) * std::cos(6 * p.y()), 0, 1e-6);
    }
}

/// Grading does not change the border or leave gaps, so surface and volume are equal.
TEST(IsosurfaceStuffing, GradingKeepsTheSurfaceAndSavesElements) {
  const ImplicitSolid ball =
      solid_of([](const Vec3& p) { return 1 - (p - Vec3(0.1, 0, 0)).norm() + 0.05 * std::sin(7 * p.x()); });
  const auto graded = [&](int levels) {
    TetSoup soup = stuff_isosurface(ball, cube(1.3), 0.06, "ball", {}, levels);
    for (const auto& [a, b, c, d] : soup.tets)
      EXPECT_GT(signed_volume(soup.points[a], soup.points[b], soup.points[c], soup.points[d]), 0);
    prepare(soup);
    EXPECT_TRUE(testing::check_invariants(build_mesh(soup)).empty());
    return mesh_quality(soup);
  };
  const MeshQuality even = graded(0);
  int tets = even.tets;
  for (const int levels : {1, 2}) {
    const MeshQuality quality = graded(levels);
    EXPECT_NEAR(quality.volume, even.volume, 1e-11 * even.volume);
    EXPECT_EQ(quality.surface_triangles, even.surface_triangles);
    EXPECT_GT(quality.min_dihedral, 10.78);
    EXPECT_LT(quality.max_dihedral, 164.75);
    EXPECT_NEAR(quality.longest_edge / 0.06, 1 << levels, 0.01);
    EXPECT_LT(quality.tets, levels == 1 ? 0.65 * tets : tets);
    tets = quality.tets;
  }
}

/// For tets inside only: a cube that the lattice fits exactly.
TEST(IsosurfaceStuffing, GradedElementsAreWellShaped) {
  const ImplicitSolid noisy =
      solid_of([](const Vec3& p) { return 1.5 - p.norm() + 0.4 * std::sin(9 * p.x()) * std::cos(8 * p.y()); });
  const TetSoup soup = stuff_isosurface(noisy, cube(2.1), 0.1, "noisy", {}, 2);
  int large = 0;
  for (const auto& tet : soup.tets) {
    std::array<Vec3, 4> corners;
    for (int i = 0; i < 4; ++i) corners[i] = soup.points[tet[i]];
    double longest = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) longest = std::max(longest, (corners[i] - corners[j]).norm());
    if (longest < 0.15) continue;
    ++large;
    for (const double angle : dihedral_angles(corners)) {
      EXPECT_GT(angle * 180 / std::numbers::pi, 29.9);
      EXPECT_LT(angle * 180 / std::numbers::pi, 135.1);
    }
  }
  EXPECT_GT(large, 100);
}

TEST(IsosurfaceStuffing, IsTheSameForAnyNumberOfThreads) {
  const auto ball = solid_of([](const Vec3& p) { return 1 - p.norm(); });
  const auto with_threads = [&](int threads) {
    const ThreadLimit limit(threads);
    return stuff_isosurface(ball, cube(1), 0.2, "ball");
  };
  const TetSoup one = with_threads(1), four = with_threads(4);
  EXPECT_EQ(one.tets, four.tets);
  EXPECT_EQ(one.points, four.points);
}

TEST(IsosurfaceStuffing, CanBeCancelled) {
  const auto ball = solid_of([](const Vec3& p) { return 1 - p.norm(); });
  Monitor monitor;
  monitor.cancelled = [] { return true; };
  EXPECT_THROW(stuff_isosurface(ball, cube(1), 0.2, "ball", monitor), Cancelled);
}

}  // namespace
}  // namespace griffith
