#include "sim/mesh/mesh_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>

#include "sim/mesh/box_mesh.h"
#include "sim/mesh/read_mesh.h"
#include "sim/mesh/topology.h"
#include "tests/input_error_of.h"
#include "tests/mesh/mesh_invariants.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::RandomValues;

TetSoup box_soup() { return make_box(Vec3(2, 2, 1), Vec3::Ones(), BoxPattern::kuhn); }

/// Tets that share `shared` corners (1: a node, 2: an edge) and lie on opposite sides of them.
TetSoup two_tets_sharing(int shared) {
  TetSoup soup;
  soup.points = {Vec3(0, 0, 0),  Vec3(0, 0, 1),  Vec3(1, 0, 0),   Vec3(0, 1, 0),
                 Vec3(-1, 0, 0), Vec3(0, -1, 0), Vec3(-1, -1, -1)};
  soup.tets = {{0, 2, 3, 1}, shared == 2 ? std::array{0, 4, 5, 1} : std::array{0, 4, 5, 6}};
  return soup;
}

std::string error_of(TetSoup soup) {
  return input_error_of([&] { prepare(soup, "wall.msh"); });
}

TEST(QualityTest, IsOneForTheRegularTetAndInvariant) {
  const std::array<Vec3, 4> regular = {Vec3(1, 1, 1), Vec3(-1, 1, -1), Vec3(1, -1, -1), Vec3(-1, -1, 1)};
  const double sign = signed_volume(regular[0], regular[1], regular[2], regular[3]) > 0 ? 1 : -1;
  EXPECT_NEAR(sign * tet_quality(regular[0], regular[1], regular[2], regular[3]), 1, 1e-14);
  RandomValues random(1);
  for (int round = 0; round < 100; ++round) {
    std::array<Vec3, 4> x;
    for (Vec3& corner : x) corner = random.vector();
    const double quality = tet_quality(x[0], x[1], x[2], x[3]);
    EXPECT_LE(std::abs(quality), 1 + 1e-14);
    EXPECT_NEAR(tet_quality(x[1], x[0], x[2], x[3]), -quality, 1e-14);
    const Mat3 map = random.uniform(0.1, 10) * random.rotation();
    EXPECT_NEAR(tet_quality(map * x[0], map * x[1], map * x[2], map * x[3]), quality, 1e-12);
  }
}

TEST(PrepareTest, LeavesAGoodMeshAlone) {
  const TetSoup original = box_soup();
  TetSoup soup = original;
  const MeshReport report = prepare(soup);
  EXPECT_THAT(findings(report), IsEmpty());
  EXPECT_EQ(soup.tets, original.tets);
  EXPECT_EQ(soup.points, original.points);
  EXPECT_EQ(report.pieces, 1);
  EXPECT_EQ(report.tets, static_cast<int>(soup.tets.size()));
}

TEST(PrepareTest, RepairsRandomlySpoiltMeshesToTheSameShape) {
  RandomValues random(2);
  const TetSoup original = box_soup();
  for (int round = 0; round < 50; ++round) {
    TetSoup soup = original;
    int flipped = 0, repeated = 0, unused = 0;
    for (auto& tet : soup.tets)
      if (random.index(3) == 0) std::swap(tet[random.index(2)], tet[2 + random.index(2)]), ++flipped;
    for (; repeated < random.index(4); ++repeated) {
      auto copy = soup.tets[random.index(static_cast<int>(original.tets.size()))];
      std::swap(copy[0], copy[1]);
      soup.tets.push_back(copy);
      flipped +=
          signed_volume(soup.points[copy[0]], soup.points[copy[1]], soup.points[copy[2]], soup.points[copy[3]]) < 0;
    }
    for (; unused < random.index(4); ++unused) {
      soup.points.insert(soup.points.begin(), Vec3(100, 100, 100));
      for (auto& tet : soup.tets)
        for (int& corner : tet) ++corner;
    }
    const TetSoup spoilt = soup;
    const MeshReport report = prepare(soup);
    EXPECT_EQ(report.reoriented_tets, flipped);
    EXPECT_EQ(report.removed_tets, repeated);
    EXPECT_EQ(report.removed_nodes, unused);
    EXPECT_EQ(soup.points, original.points);
    EXPECT_NEAR(report.volume, 4, 1e-12);
    EXPECT_THAT(testing::check_invariants(build_mesh(soup)), IsEmpty());
    ASSERT_EQ(report.point_of_node.size(), soup.points.size());
    for (std::size_t node = 0; node < soup.points.size(); ++node)
      EXPECT_EQ(soup.points[node], spoilt.points[report.point_of_node[node]]);
  }
}

TEST(PrepareTest, PartsWhatMeetsInANodeOrAnEdgeAlone) {
  for (int shared : {1, 2}) {
    TetSoup soup = two_tets_sharing(shared);
    const TetSoup read = soup;
    TetMesh mesh;
    const MeshReport report = prepare(soup, "mesh", &mesh);
    EXPECT_EQ(report.pinched_nodes, shared);
    EXPECT_EQ(report.first_pinched, Vec3::Zero());
    EXPECT_EQ(report.pinched_edges, 0);
    EXPECT_EQ(report.pieces, 2);
    EXPECT_EQ(report.coincident_nodes, 0) << "those of the file alone";
    EXPECT_EQ(report.nodes, static_cast<int>(read.points.size()) - (shared == 2) + shared);
    EXPECT_THAT(testing::check_invariants(mesh), IsEmpty());
    EXPECT_THAT(findings(report),
                Contains(HasSubstr(std::to_string(shared) + " nodes joined parts that share no face")));
    for (std::size_t node = 0; node < soup.points.size(); ++node)
      EXPECT_EQ(soup.points[node], read.points[report.point_of_node[node]]);
  }
}

/// Any of a lattice's tets, which touch in all the ways in which tets can.
TEST(PrepareTest, MakesAMeshOfAnyOfALatticesTets) {
  RandomValues random(3);
  int parted = 0, still_pinched = 0;
  for (int round = 0; round < 200; ++round) {
    const BoxPattern pattern = std::array{BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc}[round % 3];
    TetSoup soup = make_box(Vec3(2, 2, 2), Vec3::Ones(), pattern);
    std::erase_if(soup.tets,
                  [&, fraction = random.uniform(0.1, 0.9)](const auto&) { return random.uniform(0, 1) > fraction; });
    if (soup.tets.empty()) continue;
    TetMesh mesh;
    const MeshReport report = prepare(soup, "mesh", &mesh);
    EXPECT_THAT(testing::check_invariants(mesh), IsEmpty()) << "round " << round;
    parted += report.pinched_nodes;
    still_pinched += report.pinched_edges;
  }
  EXPECT_GT(parted, 500);
  EXPECT_GT(still_pinched, 0) << "edges whose ends hold together by faces";
}

TEST(PrepareTest, CountsCoincidentNodesButNeverMergesThem) {
  TetSoup soup = box_soup();
  const int points = static_cast<int>(soup.points.size());
  const TetSoup second = soup;
  soup.points.insert(soup.points.end(), second.points.begin(), second.points.end());
  for (auto tet : second.tets) {
    for (int& corner : tet) corner += points;
    soup.tets.push_back(tet);
  }
  const MeshReport report = prepare(soup);
  EXPECT_EQ(report.coincident_nodes, points);
  EXPECT_EQ(report.nodes, 2 * points);
  EXPECT_EQ(report.pieces, 2);
}

TEST(PrepareTest, CountsSliversAndOverlaps) {
  TetSoup sliver;
  sliver.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.3, 0.3, 1e-3)};
  sliver.tets = {{0, 1, 2, 3}};
  EXPECT_EQ(prepare(sliver).slivers, 1);
  TetSoup overlap;
  overlap.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.2, 0.2, 2)};
  overlap.tets = {{0, 1, 2, 3}, {0, 1, 2, 4}};
  EXPECT_EQ(prepare(overlap).overlapping_faces, 1);
}

TEST(PrepareTest, NamesWhatMakesAMeshUnusable) {
  TetSoup soup = box_soup();
  EXPECT_THAT(error_of({}), HasSubstr("wall.msh: has no tetrahedra"));
  soup.tets[7][2] = 1000;
  EXPECT_THAT(error_of(soup), HasSubstr("tet 7 has the corner 1000"));
  soup = box_soup();
  soup.tets[3][2] = soup.tets[3][0];
  EXPECT_THAT(error_of(soup), HasSubstr("tet 3 has the same corner twice"));
  soup = box_soup();
  soup.points[5].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(error_of(soup), HasSubstr("node 5 is not finite"));
  soup.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 1e-14)};
  soup.tets = {{0, 1, 2, 3}};
  EXPECT_THAT(error_of(soup), HasSubstr("tet 0 (nodes 0, 1, 2, 3) has no volume"));
  soup.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0.2, 0.2, 2)};
  soup.tets = {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}};
  EXPECT_THAT(error_of(soup), HasSubstr("the face of nodes 0, 1, 2 belongs to more than two tets"));
}

TEST(PrepareTest, AcceptsTinyAndHugeUnits) {
  for (double scale : {1e-60, 1e-9, 1e9, 1e60}) {
    TetSoup soup = box_soup();
    for (Vec3& point : soup.points) point *= scale;
    EXPECT_THAT(findings(prepare(soup)), IsEmpty()) << scale;
  }
}

class SceneMeshTest : public ::testing::TestWithParam<const char*> {};

TEST_P(SceneMeshTest, IsReadAndPrepared) {
  const std::filesystem::path path = std::filesystem::path(GRIFFITH_SOURCE_DIR) / "scenes/meshes" / GetParam();
  TetSoup soup = read_mesh(path);
  const MeshReport report = prepare(soup, path.string());
  RecordProperty("findings", ::testing::PrintToString(findings(report)));
  EXPECT_EQ(report.pinched_nodes, 0);
  EXPECT_THAT(testing::check_invariants(build_mesh(soup)), IsEmpty());
  EXPECT_GT(report.volume, 0);
  EXPECT_EQ(report.pieces, 1);
}

INSTANTIATE_TEST_SUITE_P(Files, SceneMeshTest, ::testing::Values("wall_small", "voussoir.msh"));

}  // namespace
}  // namespace griffith
