#include "sim/fracture/split.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "sim/mesh/box_mesh.h"
#include "sim/mesh/topology.h"
#include "tests/mesh/mesh_invariants.h"
#include "tests/moving_mesh.h"

namespace griffith {
namespace {

using testing::conserved;
using testing::MovingMesh;
using testing::RandomValues;

/// A box to be split.
struct Splittable : MovingMesh {
  explicit Splittable(BoxPattern pattern, unsigned seed, const Vec3& size = Vec3(2, 1, 1))
      : MovingMesh(make_box(size, Vec3::Constant(0.4), pattern), seed, 0.03) {}
  SplitResult split(NodeId node, const Vec3& normal, int min_fragment = 1) {
    SplitResult result = split_node(mesh, positions, node, normal, min_fragment);
    follow(result.copies);
    return result;
  }
};

/// Pieces that hang together by shared nodes.
int pieces_by_nodes(const TetMesh& mesh) {
  std::vector<int> parent(mesh.node_count());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int node) {
    while (parent[node] != node) node = parent[node] = parent[parent[node]];
    return node;
  };
  for (const auto& tet : mesh.tets)
    for (int i = 1; i < 4; ++i) parent[root(tet[i].index())] = root(tet[0].index());
  int pieces = 0;
  for (int node = 0; node < mesh.node_count(); ++node) pieces += root(node) == node;
  return pieces;
}

TEST(Split, RandomAbuseKeepsEveryInvariant) {
  for (BoxPattern pattern : {BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc})
    for (unsigned seed = 0; seed < 8; ++seed) {
      Splittable body(pattern, seed);
      RandomValues random(seed + 100);
      const Eigen::VectorXd before = conserved(body);
      for (int i = 0; i < 60; ++i) {
        body.split(NodeId(random.index(body.mesh.node_count())), random.direction());
        ASSERT_THAT(testing::check_invariants(body.mesh), ::testing::IsEmpty()) << "seed " << seed << ", split " << i;
        ASSERT_EQ(pieces_by_nodes(body.mesh), static_cast<int>(connected_components(body.mesh).size()));
      }
      EXPECT_LT((conserved(body) - before).norm(), 1e-10 * before.norm()) << "everything is left alone";
      EXPECT_GT(body.mesh.node_count(), 60);
    }
}

TEST(Split, APlaneOfSplitsPartsTheBoxInTwo) {
  Splittable bar(BoxPattern::five_tet, 0);
  bar.positions = bar.mesh.rest_positions;
  const int nodes = bar.mesh.node_count();
  for (int node = 0; node < nodes; ++node)
    if (std::abs(bar.mesh.rest_positions[node].x() - 0.2) < 1e-9) bar.split(NodeId(node), Vec3::UnitX());
  const auto pieces = connected_components(bar.mesh);
  ASSERT_EQ(pieces.size(), 2u);
  for (const auto& piece : pieces)
    for (TetId tet : piece)
      EXPECT_EQ(rest_centroid(bar.mesh, tet).x() > 0.2, rest_centroid(bar.mesh, piece.front()).x() > 0.2);
}

TEST(Split, DoesNothingWhenAllTetsLieOnOneSide) {
  Splittable bar(BoxPattern::kuhn, 0);
  bar.positions = bar.mesh.rest_positions;
  for (int node = 0; node < bar.mesh.node_count(); ++node) {
    if (bar.mesh.rest_positions[node].x() < 0.999) continue;
    const SplitResult result = bar.split(NodeId(node), Vec3::UnitX());
    EXPECT_TRUE(result.copies.empty());
    EXPECT_TRUE(result.changed_tets.empty());
  }
  EXPECT_THAT(testing::check_invariants(bar.mesh), ::testing::IsEmpty());
}

TEST(Split, TheFirstCutLeavesACrackFrontAndTheNormalsSignDoesNotMatter) {
  Splittable a(BoxPattern::kuhn, 3, Vec3(2, 2, 2)), b(BoxPattern::kuhn, 3, Vec3(2, 2, 2));
  RandomValues random(4);
  const Vec3 normal = random.direction();
  NodeId surface_node;
  for (int node = 0; node < a.mesh.node_count(); ++node)
    if ((a.mesh.rest_positions[node] - Vec3(1, 0.2, 0.2)).norm() < 0.3) surface_node = NodeId(node);
  ASSERT_TRUE(surface_node.valid());
  const SplitResult plus = a.split(surface_node, normal), minus = b.split(surface_node, -normal);
  EXPECT_EQ(plus.copies.size(), minus.copies.size());
  EXPECT_EQ(plus.changed_tets, minus.changed_tets);
  EXPECT_FALSE(plus.front.empty());
  for (NodeId node : plus.front) EXPECT_EQ(star_components(a.mesh, node).size(), 1u);
}

TEST(Split, RefusesFragmentsBelowTheLimitAndLeavesNoTrace) {
  RandomValues random(5);
  Splittable body(BoxPattern::five_tet, 1);
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    const TetMesh before = body.mesh;
    const SplitResult result = body.split(NodeId(random.index(body.mesh.node_count())), random.direction(), 4);
    if (result.too_small) {
      ++refused;
      EXPECT_EQ(body.mesh.neighbors, before.neighbors);
      EXPECT_EQ(body.mesh.tets, before.tets);
    }
    for (const auto& piece : connected_components(body.mesh)) ASSERT_GE(piece.size(), 4u);
  }
  EXPECT_GT(refused, 0);
}

TEST(Split, RefusesJustWhatWouldLeaveAPieceThatIsTooSmall) {
  for (int min_fragment : {2, 20, 100}) {
    RandomValues random(static_cast<unsigned>(min_fragment));
    Splittable body(BoxPattern::five_tet, 7);
    int refused = 0, made = 0;
    for (int k = 0; k < 300; ++k) {
      const NodeId node(random.index(body.mesh.node_count()));
      const Vec3 normal = random.direction();
      Splittable unrestrained = body;
      const SplitResult expected = unrestrained.split(node, normal);
      bool leaves_small = false;
      for (const auto& piece : connected_components(unrestrained.mesh))
        if (static_cast<int>(piece.size()) < min_fragment) leaves_small = true;
      const SplitResult result = body.split(node, normal, min_fragment);
      EXPECT_EQ(result.too_small, leaves_small);
      EXPECT_EQ(result.copies.size(), leaves_small ? 0 : expected.copies.size());
      ++(result.too_small ? refused : made);
    }
    EXPECT_GT(refused, 0) << min_fragment;
    EXPECT_GT(made, 0) << min_fragment;
  }
}

}  // namespace
}  // namespace griffith
