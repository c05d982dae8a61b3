#include "sim/splinters/fragments.h"

#include <gtest/gtest.h>

#include <ctime>
#include <fstream>

#include "sim/core/error.h"
#include "sim/core/parallel.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/shapes.h"
#include "sim/mesh/topology.h"
#include "tests/random_values.h"
#include "tests/splinters/patterns.h"

namespace griffith {
namespace {

using testing::NamedPattern;
using testing::RandomValues;

double total_volume(const TetMesh& mesh) {
  double sum = 0;
  for (const TetId tet : IdRange<TetId>(0, mesh.tet_count())) sum += rest_volume(mesh, tet);
  return sum;
}

class Fragments : public ::testing::TestWithParam<NamedPattern> {};
INSTANTIATE_TEST_SUITE_P(Patterns, Fragments, ::testing::ValuesIn(testing::patterns()),
                         [](const auto& test) { return test.param.name; });

/// Bodies that share planes, edges and corners with bricks and lattices of 0.1 m, and others that do not.
std::vector<TetMesh> bodies() {
  std::vector<TetMesh> meshes;
  for (const BoxPattern pattern : {BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc})
    meshes.push_back(build_mesh(make_box(Vec3(0.8, 0.6, 0.4), Vec3::Constant(0.2), pattern)));
  TetSoup ball = make_sphere(0.35, 0.15, BoxPattern::five_tet);
  prepare(ball);
  meshes.push_back(build_mesh(ball));
  return meshes;
}

TEST_P(Fragments, FillEveryTetWithoutOverlap) {
  for (const TetMesh& mesh : bodies()) {
    const CellPartition cells = make_cells(GetParam().pattern, testing::bounds(mesh));
    std::vector<double> filled(mesh.tets.size(), 0);
    for (const Fragment& fragment : make_fragments(mesh, cells)) {
      EXPECT_GE(fragment.volume, 0);
      filled[fragment.tet] += fragment.volume;
    }
    for (const TetId tet : IdRange<TetId>(0, mesh.tet_count()))
      EXPECT_NEAR(filled[tet], rest_volume(mesh, tet), 1e-9 * total_volume(mesh) / mesh.tet_count());
  }
}

TEST_P(Fragments, AreClosed) {
  const TetMesh mesh = bodies()[0];
  for (const Fragment& fragment : make_fragments(mesh, make_cells(GetParam().pattern, testing::bounds(mesh)))) {
    Vec3 sum = Vec3::Zero();
    for (const PolyhedronFace& face : fragment.polyhedron.faces) sum += area_vector(fragment.polyhedron, face);
    EXPECT_LT(sum.norm(), 1e-9);
  }
}

TEST_P(Fragments, LieInTheirCells) {
  const TetMesh mesh = bodies()[3];
  const CellPartition cells = make_cells(GetParam().pattern, testing::bounds(mesh));
  for (const Fragment& fragment : make_fragments(mesh, cells))
    for (const PolyhedronFace& face : fragment.polyhedron.faces)
      for (const int corner : face.corners)
        for (const CellWall& wall : cells[fragment.cell].walls)
          EXPECT_LT(wall.inside.distance(fragment.polyhedron.corners[corner]), 1e-8);
}

TEST_P(Fragments, AreTheSameForAnyNumberOfThreads) {
  const TetMesh mesh = bodies()[1];
  const CellPartition cells = make_cells(GetParam().pattern, testing::bounds(mesh));
  std::vector<std::vector<Fragment>> results;
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    results.push_back(make_fragments(mesh, cells));
  }
  ASSERT_EQ(results[0].size(), results[1].size());
  for (std::size_t i = 0; i < results[0].size(); ++i) {
    EXPECT_EQ(results[0][i].cell, results[1][i].cell);
    EXPECT_EQ(results[0][i].volume, results[1][i].volume);
  }
}

TEST_P(Fragments, WallsOfNeighborsAreOpposite) {
  const CellPartition cells = make_cells(GetParam().pattern, testing::bounds(bodies()[0]));
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (const CellWall& wall : cells[i].walls) {
      if (wall.neighbor < 0) continue;  // outside of what a file holds
      for (const CellWall& back : cells[wall.neighbor].walls) {
        if (back.neighbor != static_cast<int>(i) || wall.inside.normal.dot(back.inside.normal) > 0) continue;
        EXPECT_EQ(wall.inside.normal, -back.inside.normal);
        EXPECT_EQ(wall.inside.offset, -back.inside.offset);
      }
    }
}

/// Planes through corners, edges and faces of the tets, and within rounding of them.
TEST(FragmentAbuse, NearlyCoincidentPlanesLoseNoVolume) {
  RandomValues random(3);
  const TetMesh mesh = bodies()[0];
  for (int round = 0; round < 40; ++round) {
    BrickSplinters bricks;
    bricks.size = Vec3(0.1, 0.1, 0.1) * (1 + random.index(4));
    bricks.mortar = 0;
    bricks.origin = std::pow(10.0, -6 - random.index(12)) * random.vector();
    double sum = 0;
    for (const Fragment& fragment : make_fragments(mesh, make_cells(bricks, testing::bounds(mesh))))
      sum += fragment.volume;
    EXPECT_NEAR(sum, total_volume(mesh), 1e-9 * total_volume(mesh)) << round;
  }
}

TEST(FragmentAbuse, SizeDoesNotMatter) {
  for (const double size : {1e-3, 1e3}) {
    const TetMesh mesh = build_mesh(make_box(Vec3::Constant(size), Vec3::Constant(size / 2), BoxPattern::bcc));
    VoronoiSplinters shards;
    shards.size = size / 5;
    double sum = 0;
    for (const Fragment& fragment : make_fragments(mesh, make_cells(shards, testing::bounds(mesh))))
      sum += fragment.volume;
    EXPECT_NEAR(sum, size * size * size, 1e-9 * size * size * size);
  }
}

/// Rays branch where sectors would become too wide: still neither gap nor overlap, nor a cell that is larger.
TEST(Patterns, BranchingRaysFillTheBody) {
  const TetMesh mesh = build_mesh(make_box(Vec3(1, 1, 0.02), Vec3(0.1, 0.1, 0.02), BoxPattern::five_tet));
  RadialSplinters rings;
  rings.center = Vec3(0.2, -0.1, 0);
  rings.sectors = 5;
  rings.first_ring = 0.02;
  const double largest = 0.08;
  const CellPartition cells = make_radial_cells(rings, testing::bounds(mesh), largest);
  EXPECT_GT(cells.size(), make_radial_cells(rings, testing::bounds(mesh)).size());
  for (int i = 0; i < std::ssize(cells); ++i)
    for (const CellWall& wall : cells[i].walls) {
      const auto& beyond = cells[wall.neighbor].walls;
      const auto back = std::ranges::find(beyond, i, &CellWall::neighbor);
      ASSERT_NE(back, beyond.end()) << i;
      EXPECT_EQ(back->inside.normal, -wall.inside.normal);
      EXPECT_EQ(back->inside.offset, -wall.inside.offset);
    }
  double sum = 0;
  for (const Fragment& fragment : make_fragments(mesh, cells)) sum += fragment.volume;
  EXPECT_NEAR(sum, 0.02, 1e-12);
  for (const Splinter& splinter : make_splinters(mesh, cells).splinters)
    EXPECT_LT(splinter.volume, 3 * largest * largest * 0.02);
}

TEST(Patterns, TooManyCellsAreRefused) {
  const Eigen::AlignedBox3d bounds(Vec3(-1, -1, -1), Vec3(1, 1, 1));
  VoronoiSplinters shards;
  shards.size = 1e-3;
  BrickSplinters bricks;
  bricks.size = Vec3::Constant(1e-3);
  bricks.mortar = 0;
  RadialSplinters rings;
  rings.first_ring = 1e-4;
  rings.growth = 1;
  rings.sectors = 1000;
  for (const SplinterPattern& pattern : {SplinterPattern(shards), SplinterPattern(bricks), SplinterPattern(rings)})
    EXPECT_THROW(make_cells(pattern, bounds), InputError);
}

TEST(Patterns, PointsComeFromAFile) {
  const auto path = std::filesystem::path(::testing::TempDir()) / "splinter_points.csv";
  std::ofstream(path) << "x,y,z\n-25,0,0\n25,0,0\n25,0,0\n";
  const Eigen::AlignedBox3d bounds(Vec3(-1, -1, -1), Vec3(1, 1, 1));
  const CellPartition cells = make_cells(PointSplinters{path, 0.01}, bounds);
  ASSERT_EQ(cells.size(), 2u);  // a repeated point counts once
  ASSERT_EQ(cells[0].walls.size(), 1u);
  EXPECT_NEAR(cells[0].walls[0].inside.distance(Vec3(0.3, 5, 7)), 0.3, 1e-12);
  std::ofstream(path) << "x,y,z\n";
  EXPECT_THROW(make_cells(PointSplinters{path, 1}, bounds), InputError);
}

TEST(Patterns, GrainStretchesShards) {
  VoronoiSplinters shards;
  shards.size = 0.05;
  shards.grain = Vec3(1, 2, 0);
  shards.elongation = 8;
  const TetMesh mesh = bodies()[0];
  // The mean square extent of a fragment's walls along the grain and across: normals lean away from the grain.
  double along = 0, across = 0;
  for (const ConvexCell& cell : make_cells(shards, testing::bounds(mesh)))
    for (const CellWall& wall : cell.walls) {
      const double fraction = std::pow(wall.inside.normal.dot(shards.grain.normalized()), 2);
      along += fraction;
      across += (1 - fraction) / 2;
    }
  EXPECT_LT(along, across / 4);
}

/// Work grows with the number of cells in a tet, not with its square, which would take a minute here.
TEST(ManyFragments, OfOneTetTakeNoQuadraticWork) {
  const TetMesh mesh = build_mesh(make_box(Vec3::Ones(), Vec3::Ones(), BoxPattern::five_tet));
  BrickSplinters bricks;
  bricks.size = Vec3::Constant(0.018);
  bricks.mortar = 0;
  const CellPartition cells = make_cells(bricks, testing::bounds(mesh));
  const std::clock_t start = std::clock();  // of the processor, not of the wall
  EXPECT_GT(make_fragments(mesh, cells).size(), 300'000u);
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 10);
}

}  // namespace
}  // namespace griffith
