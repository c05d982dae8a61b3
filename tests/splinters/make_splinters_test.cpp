#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "sim/core/error.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/shapes.h"
#include "sim/mesh/topology.h"
#include "sim/splinters/splinters.h"
#include "tests/splinters/patterns.h"

namespace griffith {
namespace {

using testing::NamedPattern;

TetMesh box() { return build_mesh(make_box(Vec3(0.8, 0.6, 0.4), Vec3::Constant(0.2), BoxPattern::five_tet)); }

SplinterSet splinters_of(const TetMesh& mesh, const SplinterPattern& pattern) {
  return make_splinters(mesh, make_cells(pattern, testing::bounds(mesh)));
}

Vec3 area_vector(const SplinterSet& set, const SplinterFace& face) {
  const auto corner = [&](int i) { return Vec3(set.corners[face.first_corner + i].rest.cast<double>()); };
  Vec3 sum = Vec3::Zero();
  for (int i = 2; i < face.corners; ++i) sum += (corner(i - 1) - corner(0)).cross(corner(i) - corner(0)) / 2;
  return sum;
}

class MakeSplinters : public ::testing::TestWithParam<NamedPattern> {
 protected:
  const TetMesh mesh_ = box();
  const SplinterSet set_ = splinters_of(mesh_, GetParam().pattern);
};
INSTANTIATE_TEST_SUITE_P(Patterns, MakeSplinters, ::testing::ValuesIn(testing::patterns()),
                         [](const auto& test) { return test.param.name; });

TEST_P(MakeSplinters, ShareOutTheBody) {
  std::vector<double> of_tets(mesh_.tets.size(), 0);
  double sum = 0;
  for (const SplinterPart& part : set_.parts) of_tets[part.tet] += part.volume;
  for (const Splinter& splinter : set_.splinters) sum += splinter.volume;
  EXPECT_NEAR(sum, 0.8 * 0.6 * 0.4, 1e-9 * 0.8 * 0.6 * 0.4);
  for (const TetId tet : IdRange<TetId>(0, mesh_.tet_count()))
    EXPECT_NEAR(of_tets[tet], rest_volume(mesh_, tet), 1e-12);
}

TEST_P(MakeSplinters, TheSurfaceIsTheBodysOwn) {
  double area = 0, enclosed = 0;
  for (const SplinterFace& face : set_.faces) {
    if (face.beyond >= 0) continue;
    area += area_vector(set_, face).norm();
    enclosed += area_vector(set_, face).dot(set_.corners[face.first_corner].rest.cast<double>()) / 3;
  }
  EXPECT_NEAR(area, 2 * (0.8 * 0.6 + 0.6 * 0.4 + 0.4 * 0.8), 1e-5);
  EXPECT_NEAR(enclosed, 0.8 * 0.6 * 0.4, 1e-6);
}

TEST_P(MakeSplinters, EverySplinterIsClosed) {
  std::vector<Vec3> sums(set_.splinters.size(), Vec3::Zero());
  std::vector<double> enclosed(set_.splinters.size(), 0);
  for (const SplinterFace& face : set_.faces) {
    const SplinterId splinter = set_.parts[face.part].splinter;
    const Vec3 area = area_vector(set_, face);
    sums[splinter] += area;
    enclosed[splinter] += area.dot(set_.corners[face.first_corner].rest.cast<double>()) / 3;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    EXPECT_LT(sums[i].norm(), 1e-6);
    EXPECT_NEAR(enclosed[i], set_.splinters[i].volume, 1e-6 * 0.2);
  }
}

TEST_P(MakeSplinters, WallsHaveTwoSides) {
  std::map<std::pair<int, int>, Vec3> sums;
  for (const SplinterFace& face : set_.faces) {
    if (face.beyond < 0) continue;
    EXPECT_NE(set_.parts[face.part].splinter, set_.parts[face.beyond].splinter);
    const auto [low, high] = std::minmax(face.part, face.beyond);
    sums.try_emplace({low, high}, Vec3::Zero()).first->second += area_vector(set_, face);
  }
  for (const auto& [parts, sum] : sums) EXPECT_LT(sum.norm(), 1e-6);
}

TEST_P(MakeSplinters, TheOwnerHoldsTheLargestShare) {
  for (std::size_t i = 0; i < set_.splinters.size(); ++i) {
    const Splinter& splinter = set_.splinters[i];
    double largest = 0, owned = 0;
    for (int p = splinter.first_part; p < splinter.first_part + splinter.parts; ++p) {
      EXPECT_EQ(set_.parts[p].splinter, SplinterId(static_cast<std::int64_t>(i)));
      largest = std::max(largest, set_.parts[p].volume);
      if (set_.parts[p].tet == splinter.owner) owned = set_.parts[p].volume;
    }
    EXPECT_EQ(owned, largest);
  }
}

TEST_P(MakeSplinters, WeightsGiveTheRestPlacesBack) {
  for (const SplinterFace& face : set_.faces) {
    const SplinterPart& part = set_.parts[face.part];
    for (int i = face.first_corner; i < face.first_corner + face.corners; ++i) {
      const SplinterCorner& corner = set_.corners[i];
      Vec3 in_tet = Vec3::Zero(), in_owner = Vec3::Zero();
      for (int k = 0; k < 4; ++k) {
        in_tet += corner.weights[k] * mesh_.rest_positions[mesh_.tets[part.tet][k]];
        in_owner += corner.owner_weights[k] * mesh_.rest_positions[mesh_.tets[set_.splinters[part.splinter].owner][k]];
      }
      EXPECT_LT((in_tet - corner.rest.cast<double>()).norm(), 1e-6);
      EXPECT_LT((in_owner - corner.rest.cast<double>()).norm(), 1e-5);
      EXPECT_GT(corner.weights.minCoeff(), -1e-6);
    }
  }
}

TEST(MakeSplinters, PointsFarAwayOrSideBySideLeaveTheOthersTheirCells) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "points.xyz";
  replace_file(path, "-0.2 0.1 0\n0.2 0 0.1\n0.2 0 0.1000000000001\n0 -0.2 0\n100000000 0 0\n0 1e300 7\n");
  const TetMesh mesh = box();
  const SplinterSet set = splinters_of(mesh, PointSplinters{path, 1});
  double sum = 0;
  for (const Splinter& splinter : set.splinters) sum += splinter.volume;
  EXPECT_NEAR(sum, 0.8 * 0.6 * 0.4, 1e-12);
  EXPECT_EQ(set.splinters.size(), 3u);
  replace_file(path, "100000000 0 0\n100000001 0 0\n");
  EXPECT_THROW(splinters_of(mesh, PointSplinters{path, 1}), InputError);
}

TEST(MakeSplinters, NothingSmallIsLeftBesideSomethingLarge) {
  // A lattice that cuts slices of a hundredth off the box.
  BrickSplinters bricks;
  bricks.size = Vec3::Constant(0.2);
  bricks.mortar = 0;
  bricks.origin = Vec3::Constant(0.002);
  const SplinterSet set = splinters_of(box(), bricks);
  for (const Splinter& splinter : set.splinters) EXPECT_GT(splinter.volume, 0.1 * 0.002);
}

TEST(MakeSplinters, NoSplinterReachesAcrossASlit) {
  TetSoup soup = make_notched_beam(Vec3(2, 0.6, 0.4), 0.3, Vec3::Constant(0.1), BoxPattern::five_tet);
  prepare(soup);
  const TetMesh mesh = build_mesh(soup);
  BrickSplinters bricks;  // one row of bricks across the slit
  bricks.size = Vec3(0.5, 0.2, 0.4);
  bricks.mortar = 0;
  bricks.origin = Vec3(-0.25, -0.3, -0.2);
  for (const Splinter& splinter : splinters_of(mesh, bricks).splinters)
    EXPECT_LE(splinter.volume, 0.5 * 0.2 * 0.4 + 1e-9);
  const SplinterSet set = splinters_of(mesh, bricks);
  int beside_slit = 0;
  for (const SplinterFace& face : set.faces) {
    if (face.beyond >= 0) continue;
    const auto corner = [&](int i) { return set.corners[face.first_corner + i].rest; };
    bool on_slit = true;
    for (int i = 0; i < face.corners; ++i) on_slit = on_slit && std::abs(corner(i).x()) < 1e-6;
    beside_slit += on_slit;
  }
  EXPECT_GT(beside_slit, 0);
  for (const PartLink& link : set.links) {
    const Vec3 a = rest_centroid(mesh, set.parts[link.a].tet), b = rest_centroid(mesh, set.parts[link.b].tet);
    EXPECT_FALSE(a.x() * b.x() < 0 && a.y() < 0 && b.y() < 0);
  }
}

TEST(MakeSplinters, BodiesStandOneAfterAnother) {
  const TetMesh mesh = box();
  const SplinterSet one = splinters_of(mesh, VoronoiSplinters{});
  SplinterSet all;
  append(all, one, TetId(0), 0);
  append(all, one, TetId(mesh.tet_count() + 7), 2);
  const std::size_t half = one.splinters.size();
  ASSERT_EQ(all.splinters.size(), 2 * half);
  EXPECT_EQ(all.first_link.size(), all.splinters.size() + 1);
  EXPECT_EQ(all.first_link.back(), static_cast<int>(all.links.size()));
  for (std::size_t i = 0; i < all.splinters.size(); ++i) {
    const Splinter& splinter = all.splinters[i];
    EXPECT_EQ(splinter.scene_body, i < half ? 0 : 2);
    for (int p = splinter.first_part; p < splinter.first_part + splinter.parts; ++p) {
      EXPECT_EQ(all.parts[p].splinter, SplinterId(static_cast<std::int64_t>(i)));
      for (int f = all.parts[p].first_face; f < all.parts[p].first_face + all.parts[p].faces; ++f)
        EXPECT_EQ(all.faces[f].part, p);
      const std::vector<int>& of_tet = all.parts_of_tet[all.parts[p].tet];
      EXPECT_NE(std::find(of_tet.begin(), of_tet.end(), p), of_tet.end());
    }
  }
}

}  // namespace
}  // namespace griffith
