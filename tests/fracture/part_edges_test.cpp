#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sim/fracture/split.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/tet_edges.h"
#include "sim/mesh/topology.h"
#include "tests/all_tets.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

using testing::all_tets;
using testing::RandomValues;

/// Edges of tets join the nodes that they should, there is one for each two nodes, and none without tets.
void expect_exact(const TetMesh& mesh, const TetEdges& edges) {
  std::set<std::array<NodeId, 2>> pairs;
  for (const TetId tet : all_tets(mesh))
    for (int i = 0; i < 6; ++i) {
      const NodeId a = mesh.tets[tet][kTetEdges[i][0]], b = mesh.tets[tet][kTetEdges[i][1]];
      const std::array<NodeId, 2> ends = {std::min(a, b), std::max(a, b)};
      ASSERT_EQ(edges.ends[edges.of_tet[tet][i]], ends);
      pairs.insert(ends);
    }
  EXPECT_EQ(static_cast<int>(pairs.size()), edges.edge_count());
}

TEST(TetEdges, AreNumberedOnceForEachTwoNodes) {
  TetMesh mesh = build_mesh(make_box(Vec3(3, 2, 1), Vec3::Ones(), BoxPattern::kuhn));
  TetEdges edges;
  const std::vector<TetId> tets = all_tets(mesh);
  add_edges(mesh, std::span(tets).first(10), edges);
  EXPECT_TRUE(edges.is_quadratic(TetId(9)));
  EXPECT_FALSE(edges.is_quadratic(TetId(10)));
  edges = {};
  add_edges(mesh, tets, edges);
  expect_exact(mesh, edges);
  const std::vector<EdgeId> all = edges_of(edges, tets);
  EXPECT_EQ(static_cast<int>(all.size()), edges.edge_count());
}

TEST(TetEdges, PartWithTheirNodes) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    RandomValues random(seed);
    TetMesh mesh = build_mesh(make_box(Vec3(3, 3, 2), Vec3::Ones(), BoxPattern::five_tet));
    TetEdges edges;
    add_edges(mesh, all_tets(mesh), edges);
    for (int crack = 0; crack < 30; ++crack) {
      const std::vector<std::array<EdgeId, 6>> before = edges.of_tet;
      const int first_copy = edges.edge_count();
      const NodeId node(random.index(mesh.node_count()));
      std::vector<NodeId> copied;
      for (const NodeCopy& copy : split_node(mesh, mesh.rest_positions, node, random.direction()).copies)
        copied.push_back(copy.copy);
      const std::vector<EdgeCopy> copies = part_edges(mesh, copied, edges);
      expect_exact(mesh, edges);
      for (std::size_t i = 0; i < copies.size(); ++i)
        EXPECT_EQ(copies[i].copy.index(), first_copy + static_cast<int>(i));
      // A tet that has got another edge has got the copy of the one that it had.
      for (const TetId tet : all_tets(mesh))
        for (int i = 0; i < 6; ++i) {
          const EdgeId now = edges.of_tet[tet][i], was = before[tet][i];
          if (now == was) continue;
          EXPECT_EQ(copies[now.index() - first_copy].original, was);
        }
    }
  }
}

}  // namespace
}  // namespace griffith
