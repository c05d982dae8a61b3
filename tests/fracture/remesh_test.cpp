#include "sim/fracture/remesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <set>

#include "sim/mesh/box_mesh.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/read_mesh.h"
#include "tests/irregular_soup.h"
#include "tests/mesh/mesh_invariants.h"
#include "tests/moving_mesh.h"

namespace griffith {
namespace {

using testing::conserved;
using testing::MovingMesh;
using testing::RandomValues;

constexpr std::array kPatterns = {BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc};

struct Remeshable : MovingMesh {
  std::vector<std::uint8_t> at_crack_front;

  using MovingMesh::MovingMesh;
  struct Result {
    StarCut cut;
    SplitResult split;
  };
  Result remesh(NodeId node, const Vec3& normal, const RemeshOptions& options = {}) {
    Result result;
    at_crack_front.resize(mesh.node_count(), 0);
    result.cut = cut_star(mesh, positions, at_crack_front, node, normal, options);
    result.split = split_node(mesh, node, result.cut.above);
    follow(result.cut.subdivision);
    follow(result.split.copies);
    at_crack_front.resize(mesh.node_count(), 0);
    for (const NodeCopy& copy : result.split.copies) at_crack_front[copy.original] = 0;
    for (NodeId front : result.split.front) at_crack_front[front] = 1;
    return result;
  }
  double quality(TetId tet) const {
    const auto& [a, b, c, d] = mesh.tets[tet];
    const auto& x = mesh.rest_positions;
    return tet_quality(x[a], x[b], x[c], x[d]);
  }
  double height(NodeId node, const Vec3& origin, const Vec3& normal) const {
    return normal.dot(positions[node] - origin);
  }
  double worst_quality() const {
    double worst = 1;
    for (int tet = 0; tet < mesh.tet_count(); ++tet) worst = std::min(worst, quality(TetId(tet)));
    return worst;
  }
};

Remeshable box(BoxPattern pattern, unsigned seed, double noise = 0) {
  return {make_box(Vec3(2, 1, 1), Vec3::Constant(0.25), pattern), seed, noise};
}

/// Returns options that take only nodes on the plane as part of it, and never refuse.
RemeshOptions exact() { return {.limits = {}, .snap_fraction = 0, .snap_angle = 1e-9, .crack_angle = 1e-9}; }

NodeId node_nearest(const Remeshable& body, const Vec3& place) {
  int nearest = 0;
  for (int node = 0; node < body.mesh.node_count(); ++node)
    if ((body.positions[node] - place).norm() < (body.positions[nearest] - place).norm()) nearest = node;
  return NodeId(nearest);
}

std::vector<std::pair<TetSoup, double>> soups_with_sizes() {
  std::vector<std::pair<TetSoup, double>> soups;
  for (BoxPattern pattern : kPatterns) soups.emplace_back(make_box(Vec3(2, 1, 1), Vec3::Constant(0.4), pattern), 0.4);
  for (TetSoup soup : {testing::irregular_soup(), read_mesh(GRIFFITH_SOURCE_DIR "/scenes/meshes/voussoir.msh")}) {
    const MeshReport report = prepare(soup);
    soups.emplace_back(std::move(soup), std::cbrt(6 * report.volume / report.tets));
  }
  return soups;
}

TEST(Remesh, RandomAbuseKeepsEveryInvariant) {
  unsigned seed = 0;
  for (const auto& [soup, size] : soups_with_sizes()) {
    RandomValues random(++seed);
    Remeshable body(soup, seed, 0.05 * size);
    const double quality = std::min(body.worst_quality(), 0.1);
    RemeshOptions options;
    options.limits = {.min_length = size / 4, .min_quality = 0.1};
    const Eigen::VectorXd before = conserved(body);
    const int tets = body.mesh.tet_count(), cuts = 60;
    for (int i = 0; i < cuts; ++i) {
      const double energy = conserved(body)[11];
      body.remesh(NodeId(random.index(body.mesh.node_count())), random.direction(), options);
      ASSERT_LE(conserved(body)[11], energy * (1 + 1e-12));
      if (i % 6 != 0 && tets > 1000) continue;
      ASSERT_THAT(testing::check_invariants(body.mesh), ::testing::IsEmpty()) << seed << ", " << i;
    }
    EXPECT_LT((conserved(body) - before).head<8>().norm(), 1e-12 * before.norm()) << "mass, its center, momentum";
    EXPECT_GE(body.worst_quality(), quality);
    EXPECT_GT(body.mesh.tet_count(), tets);
  }
}

TEST(Remesh, ThePlaneIsTheInterfaceOfTheTwoSides) {
  RandomValues random(3);
  for (BoxPattern pattern : kPatterns)
    for (unsigned seed = 0; seed < 20; ++seed) {
      Remeshable body = box(pattern, seed, 0.03);
      const NodeId node = node_nearest(body, Vec3(0.3, 0.5, random.uniform(-0.3, 0.3)));
      const Vec3 origin = body.positions[node], normal = random.direction();
      const Remeshable::Result result = body.remesh(node, normal, exact());
      EXPECT_EQ(result.cut.refused_edges, 0);
      ASSERT_FALSE(result.split.copies.empty()) << "a node on the surface parts at once";
      std::set<NodeId> parts = {node};
      for (const NodeCopy& copy : result.split.copies)
        if (copy.original == node) parts.insert(copy.copy);
      for (NodeId part : parts) {
        double lowest = 0, highest = 0;
        for (NodeId corner : nodes_of(body.mesh, body.mesh.stars[part])) {
          lowest = std::min(lowest, body.height(corner, origin, normal));
          highest = std::max(highest, body.height(corner, origin, normal));
        }
        EXPECT_LT(std::min(highest, -lowest), 1e-12) << "all of a part lies on one side";
      }
    }
}

/// Separates nodes with one normal, starting from one on the surface, as a crack front runs through a body.
void run_crack(Remeshable& body, NodeId start, const Vec3& normal, const RemeshOptions& options) {
  for (std::deque<NodeId> queue = {start}; !queue.empty(); queue.pop_front()) {
    const NodeId node = queue.front();
    if (node != start && !body.at_crack_front[node]) continue;
    const Remeshable::Result result = body.remesh(node, normal, options);
    queue.insert(queue.end(), result.split.front.begin(), result.split.front.end());
  }
}

double surface_area(const Remeshable& body) {
  double area = 0;
  for (const SurfaceFace& face : surface_faces(body.mesh)) {
    const auto [a, b, c] = face_nodes(body.mesh, face.tet, face.face);
    area += (body.positions[b] - body.positions[a]).cross(body.positions[c] - body.positions[a]).norm() / 2;
  }
  return area;
}

/// Returns the volume of a piece's smaller part when the plane cuts it in two.
double volume_across(const Remeshable& body, const std::vector<TetId>& piece, const Vec3& origin, const Vec3& normal) {
  double above = 0, below = 0;
  for (TetId tet : piece)
    (normal.dot(rest_centroid(body.mesh, tet) - origin) > 0 ? above : below) += rest_volume(body.mesh, tet);
  return std::min(above, below);
}

TEST(Remesh, ACrackRunsThroughABoxAlongItsPlane) {
  RandomValues random(5);
  for (BoxPattern pattern : kPatterns)
    for (unsigned seed = 0; seed < 3; ++seed) {
      Remeshable body = box(pattern, seed);
      body.positions = body.mesh.rest_positions;
      const double surface = surface_area(body);
      const Vec3 normal = (Vec3::UnitX() + random.vector(0.4)).normalized();
      const NodeId start = node_nearest(body, Vec3(0, 0.5, 0.1));
      run_crack(body, start, normal, exact());
      const auto pieces = connected_components(body.mesh);
      EXPECT_EQ(pieces.size(), 2u);
      for (const auto& piece : pieces) EXPECT_LT(volume_across(body, piece, body.positions[start], normal), 1e-12);
      EXPECT_NEAR((surface_area(body) - surface) / 2, 1 / std::abs(normal.x()), 1e-9) << "the box is 1 m × 1 m across";
      EXPECT_THAT(testing::check_invariants(body.mesh), ::testing::IsEmpty());
    }
}

TEST(Remesh, ThousandsOfCutsComeToAnEnd) {
  for (BoxPattern pattern : kPatterns) {
    RandomValues random(6);
    Remeshable body = box(pattern, 6);
    const BisectionLimits limits{.min_length = 0.1, .min_quality = 0.1};
    for (int i = 0; i < 3000; ++i) {
      const NodeId node(random.index(body.mesh.node_count()));
      body.remesh(node, random.direction(), {.limits = limits});
    }
    EXPECT_THAT(testing::check_invariants(body.mesh), ::testing::IsEmpty());
    EXPECT_GE(body.worst_quality(), limits.min_quality);
    // No tet is smaller than one of the least quality with the shortest edges.
    const double min_volume = limits.min_quality * std::pow(limits.min_length, 3) / (6 * std::sqrt(2));
    EXPECT_LT(body.mesh.tet_count(), 2 / min_volume);
  }
}

TEST(Remesh, TheNormalsSignDoesNotMatter) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    Remeshable a = box(BoxPattern::five_tet, seed, 0.03), b = a;
    RandomValues random(seed);
    const NodeId node(random.index(a.mesh.node_count()));
    const Vec3 normal = random.direction();
    const Remeshable::Result plus = a.remesh(node, normal), minus = b.remesh(node, -normal);
    EXPECT_EQ(a.mesh.rest_positions, b.mesh.rest_positions);
    EXPECT_EQ(plus.split.changed_tets, minus.split.changed_tets);
    EXPECT_EQ(plus.cut.refused_edges, minus.cut.refused_edges);
  }
}

TEST(Remesh, WhereNothingMayBeCutItFollowsFaces) {
  RandomValues random(8);
  Remeshable body = box(BoxPattern::five_tet, 8);
  const int tets = body.mesh.tet_count(), nodes = body.mesh.node_count();
  int refused = 0;
  for (int node = 0; node < nodes; ++node)
    refused += body.remesh(NodeId(node), random.direction(), {.limits = {.min_length = 1}}).cut.refused_edges;
  EXPECT_EQ(body.mesh.tet_count(), tets);
  EXPECT_GT(body.mesh.node_count(), nodes) << "nodes are parted all the same";
  EXPECT_GT(refused, nodes / 2);
  EXPECT_THAT(testing::check_invariants(body.mesh), ::testing::IsEmpty());
}

}  // namespace
}  // namespace griffith
