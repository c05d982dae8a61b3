#include <gtest/gtest.h>

#include <Eigen/LU>

#include "sim/fracture/split.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/topology.h"
#include "sim/splinters/carried_corner.h"
#include "tests/random_values.h"
#include "tests/splinters/patterns.h"

namespace griffith {
namespace {

using testing::NamedPattern;
using testing::RandomValues;

/// A box that is split at random nodes, and its splinters.
class CrackedBox {
 public:
  explicit CrackedBox(const SplinterPattern& pattern)
      : mesh(build_mesh(make_box(Vec3(0.8, 0.6, 0.4), Vec3::Constant(0.2), BoxPattern::five_tet))),
        set(make_splinters(mesh, make_cells(pattern, testing::bounds(mesh)))),
        state(intact_state(set)) {}

  void split(RandomValues& random) {
    const SplitResult result =
        split_node(mesh, mesh.rest_positions, NodeId(random.index(mesh.node_count())), random.direction());
    follow_cracks(set, mesh.neighbors, result.changed_tets, state);
  }

  /// A number for each tet: that of its connected piece.
  std::vector<int> pieces() const {
    std::vector<int> numbers(mesh.tets.size());
    int number = 0;
    for (const std::vector<TetId>& piece : connected_components(mesh)) {
      for (const TetId tet : piece) numbers[tet] = number;
      ++number;
    }
    return numbers;
  }

  TetMesh mesh;
  SplinterSet set;
  SplinterState state;
};

class FollowCracks : public ::testing::TestWithParam<NamedPattern> {};
INSTANTIATE_TEST_SUITE_P(Patterns, FollowCracks, ::testing::ValuesIn(testing::patterns()),
                         [](const auto& test) { return test.param.name; });

TEST_P(FollowCracks, AnIntactBodyShowsNoWall) {
  const CrackedBox box(GetParam().pattern);
  EXPECT_TRUE(box.state.open_walls.empty());
  for (std::size_t f = 0; f < box.set.faces.size(); ++f) EXPECT_EQ(box.state.open[f] != 0, box.set.faces[f].beyond < 0);
  SplinterState state = box.state;
  std::vector<TetId> all;
  for (const TetId tet : IdRange<TetId>(0, box.mesh.tet_count())) all.push_back(tet);
  follow_cracks(box.set, box.mesh.neighbors, all, state);
  EXPECT_TRUE(state.open_walls.empty());
}

TEST_P(FollowCracks, PartsMoveWithTheBodyOfTheirOwner) {
  RandomValues random(5);
  CrackedBox box(GetParam().pattern);
  for (int i = 0; i < 60; ++i) {
    box.split(random);
    const std::vector<int> pieces = box.pieces();
    for (std::size_t p = 0; p < box.set.parts.size(); ++p) {
      const TetId owner = box.set.splinters[box.set.parts[p].splinter].owner;
      EXPECT_EQ(pieces[carrier(box.set.splinters, box.set.parts, box.state.attached, static_cast<int>(p))],
                pieces[owner]);
      EXPECT_TRUE(box.state.attached[p] || box.set.parts[p].tet != owner);
    }
  }
}

TEST_P(FollowCracks, WallsBetweenPiecesAreOpen) {
  RandomValues random(6);
  CrackedBox box(GetParam().pattern);
  int between = 0;
  for (int i = 0; i < 60; ++i) {
    box.split(random);
    const std::vector<int> pieces = box.pieces();
    for (std::size_t f = 0; f < box.set.faces.size(); ++f) {
      const SplinterFace& face = box.set.faces[f];
      if (face.beyond < 0) continue;
      const auto piece = [&](int part) { return pieces[box.set.splinters[box.set.parts[part].splinter].owner]; };
      if (piece(face.part) == piece(face.beyond)) continue;
      EXPECT_TRUE(box.state.open[f]);
      ++between;
    }
  }
  EXPECT_GT(between, 0);
}

/// With every node displaced at random, a gap shows exactly where both sides are not carried alike.
TEST_P(FollowCracks, ClosedWallsHaveNoGap) {
  RandomValues random(7);
  CrackedBox box(GetParam().pattern);
  for (int i = 0; i < 25; ++i) box.split(random);
  std::vector<Vec3> positions;
  for (const Vec3& rest : box.mesh.rest_positions) positions.push_back(rest + random.vector(0.1));
  const auto carried = [&](TetId tet, const Vec3& rest) {
    Mat3 reference, moved;
    const auto& nodes = box.mesh.tets[tet];
    for (int k = 0; k < 3; ++k) {
      reference.col(k) = box.mesh.rest_positions[nodes[k + 1]] - box.mesh.rest_positions[nodes[0]];
      moved.col(k) = positions[nodes[k + 1]] - positions[nodes[0]];
    }
    return Vec3(positions[nodes[0]] + moved * reference.inverse() * (rest - box.mesh.rest_positions[nodes[0]]));
  };
  int open = 0;
  for (std::size_t f = 0; f < box.set.faces.size(); ++f) {
    const SplinterFace& face = box.set.faces[f];
    if (face.beyond < 0) continue;
    if (box.state.open[f] && ++open) continue;
    for (int c = face.first_corner; c < face.first_corner + face.corners; ++c) {
      const Vec3 rest = box.set.corners[c].rest.cast<double>();
      const Vec3 gap = carried(carrier(box.set.splinters, box.set.parts, box.state.attached, face.part), rest) -
                       carried(carrier(box.set.splinters, box.set.parts, box.state.attached, face.beyond), rest);
      EXPECT_LT(gap.norm(), 1e-5);
    }
  }
  EXPECT_GT(open, 0);
  EXPECT_EQ(open, static_cast<int>(box.state.open_walls.size()));
}

TEST_P(FollowCracks, OnlyWhatCracksTouchIsUpdated) {
  RandomValues random(8);
  CrackedBox box(GetParam().pattern);
  SplinterState whole = intact_state(box.set);
  for (int i = 0; i < 30; ++i) box.split(random);
  std::vector<TetId> all;
  for (const TetId tet : IdRange<TetId>(0, box.mesh.tet_count())) all.push_back(tet);
  follow_cracks(box.set, box.mesh.neighbors, all, whole);
  EXPECT_EQ(box.state.attached, whole.attached);
  for (std::size_t f = 0; f < whole.open.size(); ++f) EXPECT_GE(box.state.open[f], whole.open[f]);
}

}  // namespace
}  // namespace griffith
