#include "sim/mesh/box_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/error.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/topology.h"
#include "tests/mesh/mesh_invariants.h"
#include "tests/mesh/pattern_name.h"

namespace griffith {
namespace {

constexpr BoxPattern kPatterns[] = {BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc};

double surface_area(const TetMesh& mesh) {
  double area = 0;
  for (const auto& [tet, face] : surface_faces(mesh)) {
    const auto [a, b, c] = face_nodes(mesh, tet, face);
    const auto& x = mesh.rest_positions;
    area += (x[b] - x[a]).cross(x[c] - x[a]).norm() / 2;
  }
  return area;
}

class BoxTest : public ::testing::TestWithParam<BoxPattern> {};

TEST_P(BoxTest, FillsTheBoxWithConformingPositiveTets) {
  for (const Vec3& cells : {Vec3(1, 1, 1), Vec3(2, 1, 1), Vec3(3, 4, 2), Vec3(1, 5, 3)}) {
    const Vec3 size(1.3, 0.7, 2.1);
    TetSoup soup = make_box(size, size.cwiseQuotient(cells), GetParam());
    const MeshReport report = prepare(soup);
    const TetMesh mesh = build_mesh(soup);
    EXPECT_THAT(testing::check_invariants(mesh), ::testing::IsEmpty());
    EXPECT_THAT(findings(report), ::testing::IsEmpty());
    EXPECT_NEAR(report.volume, size.prod(), 1e-12 * size.prod());
    const double area = 2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
    EXPECT_NEAR(surface_area(mesh), area, 1e-12 * area);
    EXPECT_TRUE(report.minimum.isApprox(-size / 2, 1e-15) && report.maximum.isApprox(size / 2, 1e-15));
  }
}

TEST_P(BoxTest, CutsEveryCellIntoTheSameNumberOfTets) {
  const auto tets = make_box(Vec3(4, 3, 2), Vec3::Ones(), GetParam()).tets.size();
  const int cells = 24, inner_faces = 3 * 6 + 4 * 4 + 12 * 1, outer_faces = 2 * (12 + 6 + 8);
  switch (GetParam()) {
    case BoxPattern::kuhn:
      EXPECT_EQ(tets, 6u * cells);
      break;
    case BoxPattern::five_tet:
      EXPECT_EQ(tets, 5u * cells);
      break;
    case BoxPattern::bcc:
      EXPECT_EQ(tets, 4u * inner_faces + 2u * outer_faces);
      break;
  }
}

TEST_P(BoxTest, RefusesLengthsThatMakeNoBox) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (double bad : {0.0, -1.0, infinity, std::nan("")}) {
    EXPECT_THROW(make_box(Vec3(1, bad, 1), Vec3::Ones(), GetParam()), InputError) << bad;
    EXPECT_THROW(make_box(Vec3::Ones(), Vec3(1, 1, bad), GetParam()), InputError) << bad;
  }
  EXPECT_THROW(make_box(Vec3::Ones(), Vec3::Constant(1e-4), GetParam()), InputError);
  EXPECT_THROW(make_box(Vec3::Ones(), Vec3(1e-300, 1, 1), GetParam()), InputError);
}

INSTANTIATE_TEST_SUITE_P(Patterns, BoxTest, ::testing::ValuesIn(kPatterns), testing::pattern_name);

TEST(BoxCellsTest, AreRoundedToFitTheBoxAndAtLeastOne) {
  EXPECT_EQ(cell_count(3, 1.5, "x"), 2);
  EXPECT_EQ(cell_count(3, 1.3, "x"), 2);
  EXPECT_EQ(cell_count(1, 100, "x"), 1);
}

TEST(KuhnTest, PutsTheSameDiagonalIntoEveryTet) {
  const TetSoup soup = make_box(Vec3(3, 2, 2), Vec3::Ones(), BoxPattern::kuhn);
  for (const auto& tet : soup.tets) {
    int diagonals = 0;
    for (int a : tet)
      for (int b : tet) diagonals += (soup.points[b] - soup.points[a]).isApprox(Vec3::Ones());
    EXPECT_EQ(diagonals, 1);
  }
}

TEST(FiveTetTest, IsMirroredFromCellToCell) {
  TetSoup soup = make_box(Vec3(2, 2, 2), Vec3::Ones(), BoxPattern::five_tet);
  // With an even number of cells the mesh is its own mirror image: every tet has a partner with mirrored corners.
  const auto corner_set = [&](const std::array<int, 4>& tet, double sign) {
    std::vector<std::array<double, 3>> corners;
    for (int node : tet)
      corners.push_back({sign * soup.points[node].x() + 0.0, soup.points[node].y(), soup.points[node].z()});
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::vector<std::vector<std::array<double, 3>>> tets, mirrored;
  for (const auto& tet : soup.tets) {
    tets.push_back(corner_set(tet, 1));
    mirrored.push_back(corner_set(tet, -1));
  }
  EXPECT_THAT(mirrored, ::testing::UnorderedElementsAreArray(tets));
}

TEST(BccTest, TetsAreEqualInVolumeAndOfTwoShapes) {
  const TetSoup soup = make_box(Vec3(3, 3, 3), Vec3::Ones(), BoxPattern::bcc);
  // Squared edges: 1, 1 and four of 3/4 between two cell centers; 1, 1, 2 and three of 3/4 at the surface.
  const auto quality = [](double squared_edges) { return std::sqrt(2.0) / 2 / std::pow(squared_edges / 6, 1.5); };
  int inner = 0, outer = 0;
  for (const auto& [a, b, c, d] : soup.tets) {
    const auto& x = soup.points;
    EXPECT_NEAR(signed_volume(x[a], x[b], x[c], x[d]), 1.0 / 12, 1e-14);
    const double found = tet_quality(x[a], x[b], x[c], x[d]);
    inner += std::abs(found - quality(5)) < 1e-12;
    outer += std::abs(found - quality(6.25)) < 1e-12;
  }
  EXPECT_EQ(inner, 4 * 54);  // 54 inner faces
  EXPECT_EQ(outer, 2 * 54);  // 54 outer faces
}

}  // namespace
}  // namespace griffith
