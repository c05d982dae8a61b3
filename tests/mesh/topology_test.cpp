#include "sim/mesh/topology.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "sim/mesh/box_mesh.h"
#include "sim/mesh/mesh_report.h"
#include "tests/mesh/mesh_invariants.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

using ::testing::IsEmpty;
using testing::RandomValues;

TetSoup five_tet_box() { return make_box(Vec3(3, 2, 2), Vec3::Ones(), BoxPattern::five_tet); }
TetMesh box_mesh() { return build_mesh(five_tet_box()); }

std::vector<int> shuffled(int count, RandomValues& random) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  for (int i = count - 1; i > 0; --i) std::swap(order[i], order[random.index(i + 1)]);
  return order;
}

TEST(TopologyTest, DoesNotDependOnTheNumbering) {
  const TetSoup soup = five_tet_box();
  const TetMesh mesh = build_mesh(soup);
  RandomValues random(1);
  const auto node_of = shuffled(static_cast<int>(soup.points.size()), random);
  const auto tet_of = shuffled(static_cast<int>(soup.tets.size()), random);
  TetSoup other = soup;
  for (std::size_t i = 0; i < soup.points.size(); ++i) other.points[node_of[i]] = soup.points[i];
  for (std::size_t t = 0; t < soup.tets.size(); ++t)
    for (int c = 0; c < 4; ++c) other.tets[tet_of[t]][c] = node_of[soup.tets[t][c]];
  const TetMesh renumbered = build_mesh(other);
  EXPECT_THAT(testing::check_invariants(renumbered), IsEmpty());
  for (int t = 0; t < mesh.tet_count(); ++t)
    for (int face = 0; face < 4; ++face) {
      const TetId neighbor = mesh.neighbors[t][face];
      EXPECT_EQ(renumbered.neighbors[tet_of[t]][face], neighbor.valid() ? TetId(tet_of[neighbor]) : TetId());
    }
}

TEST(TopologyTest, AppendKeepsWhatWasThereAndLinksNothingToIt) {
  TetMesh mesh = box_mesh();
  const TetMesh before = mesh;
  const AppendedRange range = append(mesh, before);
  EXPECT_EQ(range.first_node.index(), before.node_count());
  EXPECT_EQ(range.first_tet.index(), before.tet_count());
  EXPECT_THAT(testing::check_invariants(mesh), IsEmpty());
  for (int t = 0; t < before.tet_count(); ++t) EXPECT_EQ(mesh.neighbors[t], before.neighbors[t]);
  const auto pieces = connected_components(mesh);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[1].front(), range.first_tet);
}

TEST(TopologyTest, SurfaceIsClosed) {
  const TetMesh mesh = box_mesh();
  Vec3 area = Vec3::Zero();
  std::set<std::pair<NodeId, NodeId>> edges;
  for (const auto& [tet, face] : surface_faces(mesh)) {
    const auto nodes = face_nodes(mesh, tet, face);
    const auto& x = mesh.rest_positions;
    area += (x[nodes[1]] - x[nodes[0]]).cross(x[nodes[2]] - x[nodes[0]]);
    EXPECT_GT(
        (x[nodes[0]] - rest_centroid(mesh, tet)).dot((x[nodes[1]] - x[nodes[0]]).cross(x[nodes[2]] - x[nodes[0]])), 0)
        << "seen from outside";
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(edges.emplace(nodes[i], nodes[(i + 1) % 3]).second);
  }
  EXPECT_NEAR(area.norm(), 0, 1e-12);
  for (auto [a, b] : edges) EXPECT_TRUE(edges.contains({b, a})) << "each edge once in each direction";
}

TEST(TopologyTest, ComponentsArePartedByCutLinksAlone) {
  TetMesh mesh = box_mesh();
  const auto left = [&](TetId tet) { return rest_centroid(mesh, tet).x() < 0.5; };
  for (int t = 0; t < mesh.tet_count(); ++t)
    for (TetId& neighbor : mesh.neighbors[t])
      if (neighbor.valid() && left(TetId(t)) != left(neighbor)) neighbor = TetId();
  const auto pieces = connected_components(mesh);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].size() + pieces[1].size(), mesh.tets.size());
  for (const auto& piece : pieces) {
    EXPECT_TRUE(std::is_sorted(piece.begin(), piece.end()));
    for (TetId tet : piece) EXPECT_EQ(left(tet), left(piece.front()));
    std::vector<TetId> backwards(piece.rbegin(), piece.rend());
    EXPECT_THAT(connected_components(mesh, backwards), ::testing::ElementsAre(piece));
  }
}

TEST(TopologyTest, LocalCornerInvertsTheCornerList) {
  const TetMesh mesh = box_mesh();
  for (int t = 0; t < mesh.tet_count(); ++t) {
    for (int corner = 0; corner < 4; ++corner) EXPECT_EQ(local_corner(mesh, TetId(t), mesh.tets[t][corner]), corner);
    EXPECT_EQ(local_corner(mesh, TetId(t), NodeId(mesh.node_count())), -1);
  }
}

TEST(InvariantsTest, NoticeEverySingleDamage) {
  const TetMesh good = box_mesh();
  ASSERT_THAT(testing::check_invariants(good), IsEmpty());
  RandomValues random(2);
  for (int round = 0; round < 200; ++round) {
    TetMesh bad = good;
    const int tet = random.index(bad.tet_count()), face = random.index(4), node = random.index(bad.node_count());
    switch (round % 6) {
      case 0:  // a link lost, or out of nowhere
        bad.neighbors[tet][face] = bad.neighbors[tet][face].valid() ? TetId() : TetId((tet + 1) % bad.tet_count());
        break;
      case 1:
        bad.stars[node].pop_back();
        break;
      case 2:
        bad.stars[node].push_back(TetId(bad.tet_count()));
        break;
      case 3:
        std::swap(bad.tets[tet][0], bad.tets[tet][1]);
        break;
      case 4:
        bad.tets[tet][face] = NodeId(bad.node_count());
        break;
      case 5:
        bad.rest_positions.push_back(Vec3::Zero());
        bad.stars.emplace_back();
        break;
    }
    EXPECT_THAT(testing::check_invariants(bad), ::testing::Not(IsEmpty())) << "round " << round;
  }
}

TEST(VolumeTest, IsInvariantUnderMotionAndScalesWithTheDeterminant) {
  RandomValues random(3);
  for (int round = 0; round < 100; ++round) {
    std::array<Vec3, 4> x;
    for (Vec3& corner : x) corner = random.vector();
    const Mat3 map = random.matrix();
    const Vec3 shift = random.vector();
    const double volume = signed_volume(x[0], x[1], x[2], x[3]);
    for (Vec3& corner : x) corner = map * corner + shift;
    EXPECT_NEAR(signed_volume(x[0], x[1], x[2], x[3]), map.determinant() * volume, 1e-13);
    EXPECT_NEAR(signed_volume(x[1], x[0], x[2], x[3]), -map.determinant() * volume, 1e-13);
  }
}

}  // namespace
}  // namespace griffith
