#include "sim/mesh/bisect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/mesh/box_mesh.h"
#include "sim/mesh/mesh_report.h"
#include "tests/irregular_soup.h"
#include "tests/mesh/mesh_invariants.h"
#include "tests/moving_mesh.h"

namespace griffith {
namespace {

using testing::conserved;
using testing::MovingMesh;
using testing::RandomValues;

std::pair<NodeId, NodeId> random_edge(const TetMesh& mesh, RandomValues& random) {
  const auto& tet = mesh.tets[random.index(mesh.tet_count())];
  const int i = random.index(4);
  return {tet[i], tet[(i + 1 + random.index(3)) % 4]};
}

std::vector<TetSoup> soups() {
  std::vector<TetSoup> soups;
  for (BoxPattern pattern : {BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc})
    soups.push_back(make_box(Vec3(2, 1, 1), Vec3::Constant(0.5), pattern));
  soups.push_back(testing::irregular_soup());
  return soups;
}

/// Returns the loss of angular momentum (3 entries) and kinetic energy by bisecting an edge.
Eigen::Vector4d predicted_loss(const MovingMesh& body, NodeId a, NodeId b, double weight) {
  double mass = 0;
  for (const auto& piece : edge_components(body.mesh, a, b))
    for (TetId tet : piece) mass += rest_volume(body.mesh, tet);
  const Vec3 edge = body.positions[a] - body.positions[b], stretching = body.velocities[a] - body.velocities[b];
  const Vec3 angular = edge.cross(stretching);
  return mass / 4 * weight * (1 - weight) *
         Eigen::Vector4d(angular.x(), angular.y(), angular.z(), stretching.squaredNorm() / 2);
}

TEST(Bisect, RandomAbuseKeepsTheMeshAndWhatItShouldConserve) {
  unsigned seed = 0;
  for (const TetSoup& soup : soups()) {
    RandomValues random(++seed);
    MovingMesh body(soup, seed, 0);
    for (int i = 0; i < 100; ++i) {
      const auto [a, b] = random_edge(body.mesh, random);
      const double weight = random.uniform(0.2, 0.8);
      const Eigen::VectorXd before = conserved(body);
      Eigen::VectorXd expected = before;
      expected.tail<4>() -= predicted_loss(body, a, b, weight);
      const int tets = body.mesh.tet_count();
      Subdivision log;
      bisect_edge(body.mesh, a, b, weight, log);
      body.follow(log);
      ASSERT_EQ(body.mesh.tet_count(), tets + static_cast<int>(log.tets.size()));
      ASSERT_LT((conserved(body) - expected).norm(), 1e-12 * before.norm()) << "bisection " << i;
      ASSERT_LE(conserved(body)[11], before[11]);
      if (i % 20 != 0) continue;
      ASSERT_THAT(testing::check_invariants(body.mesh), ::testing::IsEmpty()) << "bisection " << i;
    }
    EXPECT_THAT(testing::check_invariants(body.mesh), ::testing::IsEmpty());
  }
}

TEST(Bisect, AnAffineDeformationStaysTheSameInEveryTet) {
  RandomValues random(7);
  MovingMesh body(make_box(Vec3(1, 1, 1), Vec3::Constant(0.5), BoxPattern::five_tet), 7, 0);
  const Mat3 gradient = Mat3::Identity() + random.matrix(0.3);
  for (Vec3& position : body.positions) position = gradient * position;
  for (int i = 0; i < 50; ++i) {
    const auto [a, b] = random_edge(body.mesh, random);
    Subdivision log;
    bisect_edge(body.mesh, a, b, random.uniform(0.1, 0.9), log);
    body.follow(log);
  }
  for (int node = 0; node < body.mesh.node_count(); ++node)
    EXPECT_LT((body.positions[node] - gradient * body.mesh.rest_positions[node]).norm(), 1e-14);
}

TEST(Bisect, TheRecordSaysWhatBecameOfEveryCorner) {
  RandomValues random(8);
  MovingMesh body(make_box(Vec3(1, 1, 1), Vec3::Constant(0.5), BoxPattern::kuhn), 8, 0);
  for (int i = 0; i < 50; ++i) {
    const TetMesh before = body.mesh;
    const auto [a, b] = random_edge(body.mesh, random);
    Subdivision log;
    bisect_edge(body.mesh, a, b, 0.5, log);
    ASSERT_EQ(log.nodes.size(), 1u);
    for (const auto& [tet, child, kept, moved, middle] : log.tets) {
      EXPECT_EQ(before.tets[tet][kept], a);
      EXPECT_EQ(before.tets[tet][moved], b);
      auto near_a = before.tets[tet], near_b = before.tets[tet];
      near_a[moved] = near_b[kept] = middle;
      EXPECT_EQ(body.mesh.tets[tet], near_a);
      EXPECT_EQ(body.mesh.tets[child], near_b);
    }
  }
}

TEST(Bisect, APinchedEdgeGetsANodeForEachOfItsPieces) {
  TetMesh mesh = build_mesh(make_box(Vec3(2, 2, 2), Vec3::Ones(), BoxPattern::kuhn));
  NodeId a, b;  // the ends of the inner edge along z
  for (int node = 0; node < mesh.node_count(); ++node) {
    if (mesh.rest_positions[node].isZero()) a = NodeId(node);
    if (mesh.rest_positions[node].isApprox(Vec3::UnitZ())) b = NodeId(node);
  }
  const std::vector<std::vector<TetId>> round = edge_components(mesh, a, b);
  ASSERT_EQ(round.size(), 1u);
  // Cut the faces at the edge in the plane x = 0: two pieces touch there, and are connected elsewhere.
  for (TetId tet : round[0])
    for (int face = 0; face < 4; ++face) {
      const TetId other = mesh.neighbors[tet][face];
      if (!other.valid() || local_corner(mesh, other, a) < 0 || local_corner(mesh, other, b) < 0) continue;
      if (rest_centroid(mesh, tet).x() * rest_centroid(mesh, other).x() > 0) continue;
      mesh.neighbors[other][face_toward(mesh, other, tet)] = TetId();
      mesh.neighbors[tet][face] = TetId();
    }
  ASSERT_EQ(edge_components(mesh, a, b).size(), 2u);
  Subdivision log;
  bisect_edge(mesh, a, b, 0.5, log);
  ASSERT_EQ(log.nodes.size(), 2u);
  EXPECT_EQ(log.tets.size(), round[0].size());
  for (const EdgeNode& node : log.nodes) EXPECT_EQ(star_components(mesh, node.node).size(), 1u);
  EXPECT_THAT(edge_components(mesh, a, b), ::testing::IsEmpty());
}

TEST(Bisect, LimitsAreKept) {
  RandomValues random(9);
  MovingMesh body(make_box(Vec3(1, 1, 1), Vec3::Constant(0.5), BoxPattern::bcc), 9, 0);
  const BisectionLimits limits{.min_length = 0.06, .min_quality = 0.15};
  int made = 0, refused = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto [a, b] = random_edge(body.mesh, random);
    const double weight = random.uniform(0.1, 0.9);
    const bool allowed = can_bisect(body.mesh, a, b, weight, limits);
    Subdivision log;
    if (allowed) bisect_edge(body.mesh, a, b, weight, log);
    ++(allowed ? made : refused);
  }
  for (const auto& [a, b, c, d] : body.mesh.tets) {
    const auto& x = body.mesh.rest_positions;
    ASSERT_GE(tet_quality(x[a], x[b], x[c], x[d]), limits.min_quality);
    for (const auto& [p, q] : {std::pair(a, b), {a, c}, {a, d}, {b, c}, {b, d}, {c, d}})
      ASSERT_GE((x[p] - x[q]).norm(), limits.min_length);
  }
  EXPECT_GT(made, 100);
  EXPECT_GT(refused, 10 * made) << "bisection has come to its end";
  EXPECT_THAT(testing::check_invariants(body.mesh), ::testing::IsEmpty());
}

}  // namespace
}  // namespace griffith
