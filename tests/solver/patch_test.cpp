#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "sim/solver/aggregates.h"
#include "tests/random_values.h"
#include "tests/solver/cracked_wall.h"

namespace griffith {
namespace {

using testing::ElasticBox;
using testing::RandomValues;

constexpr ImplicitStep kStep{.dt = 1.0 / 120, .relative_residual = 1e-13, .max_iterations = 1000};

enum class Supports { none, held, sliding };

ElasticBox random_box(Supports supports, BoxPattern pattern, RandomValues& random) {
  ElasticBox box(make_box(Vec3(2, 1, 1), Vec3::Constant(0.25), pattern), 1e6);
  for (std::size_t i = 0; i < box.positions.size(); ++i) {
    box.positions[i] += random.vector(0.02);
    box.velocities[i] = random.vector();
    box.forces[i] = random.vector(10);
    if (box.mesh.rest_positions[i].y() > -0.49) continue;
    if (supports == Supports::held) box.constraints[i] = NodeConstraint::held(random.vector());
    if (supports == Supports::sliding) box.constraints[i] = NodeConstraint::sliding(random.direction(), 0.3);
  }
  box.update_states();
  return box;
}

std::vector<NodeId> nodes_of(const ElasticBox& box, const std::vector<TetId>& tets) {
  std::set<NodeId> nodes;
  for (TetId tet : tets) nodes.insert(box.mesh.tets[tet].begin(), box.mesh.tets[tet].end());
  return {nodes.begin(), nodes.end()};
}

/// The largest piece of a body, which goes on as the body itself.
std::vector<TetId> surviving_piece(const ElasticBox& box, const std::vector<TetId>& tets) {
  const auto pieces = connected_components(box.mesh, tets);
  return *std::max_element(pieces.begin(), pieces.end(),
                           [](const auto& a, const auto& b) { return a.size() < b.size(); });
}

void expect_equal(const BlockSparseMatrix& a, const BlockSparseMatrix& b) {
  ASSERT_EQ(a.row_starts, b.row_starts);
  ASSERT_EQ(a.columns, b.columns);
  ASSERT_EQ(a.blocks.size(), b.blocks.size());
  for (std::size_t k = 0; k < a.blocks.size(); ++k) ASSERT_EQ(a.blocks[k], b.blocks[k]) << "block " << k;
}

/// Solves the same step with both systems: the same velocities and reactions but for the residual left.
void expect_same_step(const ElasticBox& box, const std::vector<NodeId>& nodes, ElasticSystem& patched,
                      ElasticSystem& built) {
  ElasticBox with_patched = box, with_built = box;
  EXPECT_TRUE(with_patched.solve(patched, kStep).converged);
  EXPECT_TRUE(with_built.solve(built, kStep).converged);
  for (NodeId node : nodes)
    ASSERT_LT((with_patched.velocities[node] - with_built.velocities[node]).norm(), 1e-10) << "node " << node.index();
  ASSERT_EQ(patched.reaction_forces().size(), built.reaction_forces().size());
  for (std::size_t i = 0; i < built.reaction_forces().size(); ++i) {
    const Vec3& force = built.reaction_forces()[i];
    ASSERT_LT((patched.reaction_forces()[i] - force).norm(), 1e-8 * (1 + force.norm()));
  }
}

void compare_with_new(ElasticBox& box, const std::vector<TetId>& tets, ElasticSystem& patched) {
  const std::vector<NodeId> nodes = nodes_of(box, tets);
  patched.patch(box.mesh, nodes, box.constraints, box.rows);
  const std::vector<int> patched_rows = box.rows;
  ElasticSystem built(box.mesh, tets, box.constraints, box.rows);
  EXPECT_EQ(patched_rows, box.rows);
  ASSERT_TRUE(std::ranges::equal(patched.nodes(), built.nodes()));
  ASSERT_TRUE(std::ranges::equal(patched.supports(), built.supports()));
  box.assemble(patched, kStep);
  box.assemble(built, kStep);
  expect_equal(patched.matrix(), built.matrix());
  expect_same_step(box, nodes, patched, built);
}

TEST(Patch, GivesTheSystemThatBuildingGivesUnderRandomAbuse) {
  for (Supports supports : {Supports::none, Supports::held, Supports::sliding})
    for (BoxPattern pattern : {BoxPattern::five_tet, BoxPattern::kuhn}) {
      RandomValues random(1 + static_cast<unsigned>(supports));
      ElasticBox box = random_box(supports, pattern, random);
      std::vector<TetId> tets = box.tets;
      ElasticSystem system = box.system();
      for (int patch = 0; patch < 25; ++patch) {
        for (int split = random.index(4); split >= 0; --split)
          box.split(NodeId(random.index(box.mesh.node_count())), random.direction());
        tets = surviving_piece(box, tets);
        compare_with_new(box, tets, system);
        if (::testing::Test::HasFatalFailure()) return;
      }
      EXPECT_LT(tets.size(), box.tets.size()) << "no piece has come off";
    }
}

TEST(Patch, FollowsABodyThatIsCutInHalf) {
  RandomValues random(5);
  ElasticBox box = random_box(Supports::held, BoxPattern::five_tet, random);
  ElasticSystem system = box.system();
  box.positions = box.mesh.rest_positions;
  box.update_states();
  const int nodes = box.mesh.node_count();
  for (int node = 0; node < nodes; ++node)
    if (std::abs(box.mesh.rest_positions[node].x()) < 1e-9) box.split(NodeId(node), Vec3::UnitX());
  const auto pieces = connected_components(box.mesh, box.tets);
  ASSERT_EQ(pieces.size(), 2u);
  compare_with_new(box, pieces[1], system);
}

TEST(Patch, KeepsTheIterationsBoundedAsACrackRuns) {
  for (double young_modulus : {1e6, 3e10}) {
    ElasticBox wall = testing::cracked_wall(32, 2, BoxPattern::five_tet, testing::Damage::intact, young_modulus, 1);
    ElasticSystem system = wall.system();
    RandomValues random(3);
    const ImplicitStep step{.dt = 1.0 / 120, .relative_residual = 1e-3};
    const int nodes = wall.mesh.node_count();
    for (int node = 0; node < nodes; ++node) {
      const Vec3& rest = wall.mesh.rest_positions[node];
      if (std::abs(rest.x()) > 1e-9 || rest.y() < 0) continue;
      wall.split(NodeId(node), random.direction());
      system.patch(wall.mesh, nodes_of(wall, wall.tets), wall.constraints, wall.rows);
    }
    wall.assemble(system, step);
    testing::apply(wall, testing::Load::impact);
    const SolveReport report = wall.solve(system, step);
    EXPECT_TRUE(report.converged);
    EXPECT_LE(report.iterations, 40) << "E " << young_modulus;
  }
}

/// True if each aggregate is one piece of the graph: the links within aggregates leave one piece for each.
bool are_connected(const BlockSparseMatrix& matrix, const std::vector<int>& aggregates) {
  std::set<int> seen;
  std::vector<bool> reached(matrix.rows(), false);
  for (int seed = 0; seed < matrix.rows(); ++seed) {
    if (reached[seed]) continue;
    if (!seen.insert(aggregates[seed]).second) return false;
    std::vector<int> stack = {seed};
    reached[seed] = true;
    while (!stack.empty()) {
      const int row = stack.back();
      stack.pop_back();
      for (int k = matrix.row_starts[row]; k < matrix.row_starts[row + 1]; ++k) {
        const int other = matrix.columns[k];
        if (reached[other] || aggregates[other] != aggregates[row]) continue;
        reached[other] = true;
        stack.push_back(other);
      }
    }
  }
  return true;
}

TEST(Patch, AggregatesStayConnectedAndNumberedWithoutGaps) {
  RandomValues random(9);
  ElasticBox box = random_box(Supports::none, BoxPattern::five_tet, random);
  std::vector<TetId> tets = box.tets;
  std::vector<int> aggregates;
  std::map<NodeId, int> aggregate_of_node;
  for (int patch = 0; patch < 60; ++patch) {
    const ElasticSystem system(box.mesh, tets, box.constraints, box.rows);
    aggregates.clear();
    for (NodeId node : system.nodes())
      aggregates.push_back(aggregate_of_node.contains(node) ? aggregate_of_node[node] : -1);
    aggregates = patch_aggregates(system.matrix(), 20, aggregates);
    EXPECT_TRUE(are_connected(system.matrix(), aggregates)) << "patch " << patch;
    const std::set<int> numbers(aggregates.begin(), aggregates.end());
    EXPECT_EQ(*numbers.begin(), 0);
    EXPECT_EQ(*numbers.rbegin() + 1, static_cast<int>(numbers.size()));
    EXPECT_LE(numbers.size(), system.nodes().size() / 5);
    aggregate_of_node.clear();
    for (std::size_t row = 0; row < aggregates.size(); ++row) aggregate_of_node[system.nodes()[row]] = aggregates[row];
    for (int split = 0; split < 3; ++split) box.split(NodeId(random.index(box.mesh.node_count())), random.direction());
    tets = surviving_piece(box, tets);
  }
}

TEST(Patch, AggregatesStandWhereNothingChanged) {
  ElasticBox box(Vec3(2, 1, 1), 0.25, 1e6);
  const ElasticSystem system = box.system();
  const std::vector<int> aggregates = aggregate_rows(system.matrix(), 20);
  EXPECT_EQ(patch_aggregates(system.matrix(), 20, aggregates), aggregates);
}

}  // namespace
}  // namespace griffith
