#include <gtest/gtest.h>

#include <array>

#include "sim/mesh/box_mesh.h"
#include "sim/mesh/tet_edges.h"
#include "sim/mesh/topology.h"
#include "tests/all_tets.h"
#include "tests/irregular_soup.h"
#include "tests/random_values.h"

namespace griffith {
namespace {

using testing::all_tets;
using testing::RandomValues;

double field(const Vec3& x) { return 1 + x.x() - 2 * x.y() + 3 * x.x() * x.z() - x.y() * x.y() + 0.5 * x.y() * x.z(); }

/// Offset of a quadratic function at the midpoint of an edge from the mean of its ends.
double offset(const TetMesh& mesh, const std::array<NodeId, 2>& ends) {
  const Vec3 &a = mesh.rest_positions[ends[0]], &b = mesh.rest_positions[ends[1]];
  return field((a + b) / 2) - (field(a) + field(b)) / 2;
}

/// A quadratic function on a mesh, given at its nodes and edges, follows bisections exactly.
void bisect_at_random(const TetSoup& soup, unsigned seed) {
  RandomValues random(seed);
  TetMesh mesh = build_mesh(soup);
  TetEdges edges;
  add_edges(mesh, all_tets(mesh), edges);
  std::vector<double> offsets, values;
  for (const std::array<NodeId, 2>& ends : edges.ends) offsets.push_back(offset(mesh, ends));
  for (const Vec3& place : mesh.rest_positions) values.push_back(field(place));
  for (int i = 0; i < 50; ++i) {
    const auto& tet = mesh.tets[random.index(mesh.tet_count())];
    const int corner = random.index(4);
    Subdivision log;
    bisect_edge(mesh, tet[corner], tet[(corner + 1 + random.index(3)) % 4], random.uniform(0.2, 0.8), log);
    edges.of_tet.resize(mesh.tets.size());
    ASSERT_EQ(log.nodes.size(), 1u);
    const EdgeNode& node = log.nodes[0];
    const BisectedEdges made = bisect_edges(node, log.tets, edges);
    values.push_back(node.interpolate(values[node.a.index()], values[node.b.index()]) +
                     4 * node.weight * (1 - node.weight) * offsets[made.bisected.index()]);
    for (const EdgePart& part : made.parts) {
      double sum = 0;
      for (std::size_t k = 0; k < 3 && part.from[k].valid(); ++k)
        sum += part.weights[k] * offsets[part.from[k].index()];
      offsets.push_back(sum);
    }
  }
  for (const TetId tet : all_tets(mesh))
    for (int i = 0; i < 6; ++i) {
      const NodeId a = mesh.tets[tet][kTetEdges[i][0]], b = mesh.tets[tet][kTetEdges[i][1]];
      const EdgeId edge = edges.of_tet[tet][i];
      const std::array<NodeId, 2> ends = {std::min(a, b), std::max(a, b)};
      ASSERT_EQ(edges.ends[edge], ends);
      EXPECT_NEAR(offsets[edge.index()], offset(mesh, ends), 1e-12);
    }
  for (int i = 0; i < mesh.node_count(); ++i) EXPECT_NEAR(values[i], field(mesh.rest_positions[NodeId(i)]), 1e-12);
}

TEST(BisectEdges, AQuadraticFieldStaysTheSame) {
  unsigned seed = 0;
  for (const BoxPattern pattern : {BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc})
    bisect_at_random(make_box(Vec3(2, 1, 1), Vec3::Constant(0.5), pattern), ++seed);
  bisect_at_random(testing::irregular_soup(), ++seed);
}

TEST(BisectEdges, LinearTetsHaveNone) {
  TetMesh mesh = build_mesh(make_box(Vec3::Ones(), Vec3::Ones(), BoxPattern::kuhn));
  TetEdges edges;
  Subdivision log;
  bisect_edge(mesh, mesh.tets[TetId(0)][0], mesh.tets[TetId(0)][1], 0.5, log);
  EXPECT_TRUE(bisect_edges(log.nodes[0], log.tets, edges).parts.empty());
}

}  // namespace
}  // namespace griffith
