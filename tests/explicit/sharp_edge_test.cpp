// Edges that cross, against the best separating axis of two boxes (Gottschalk 1996).

#include "sim/explicit/sharp_edge.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <vector>

#include "sim/explicit/obstacle.h"
#include "tests/random_values.h"

namespace griffith::explicit_dynamics {
namespace {

using testing::RandomValues;

struct TurnedBox {
  Vec3 size, center;
  Mat3 turn;

  std::vector<SharpEdge> edges() const {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
      corners.emplace_back(0.5 *
                           Vec3(i & 1 ? size[0] : -size[0], i & 2 ? size[1] : -size[1], i & 4 ? size[2] : -size[2]));
    std::vector<SharpEdge> edges = convex_solid(convex_hull(corners), 1e9).edges;
    for (SharpEdge& edge : edges)
      for (int i = 0; i < 2; ++i) edge.ends[i] = center + turn * edge.ends[i], edge.normals[i] = turn * edge.normals[i];
    return edges;
  }
  double reach(const Vec3& axis) const { return 0.5 * (turn.transpose() * axis).cwiseAbs().dot(size); }
};

/// Axis along which two boxes are farthest apart, or overlap least.
struct BestAxis {
  double gap = -std::numeric_limits<double>::infinity();  ///< [m]
  bool is_of_edges = false;
};

BestAxis best_axis(const TurnedBox& a, const TurnedBox& b) {
  BestAxis best;
  const auto examine = [&](const Vec3& axis, bool is_of_edges) {
    if (axis.norm() < 1e-3) return;
    const Vec3 unit = axis.normalized();
    const double gap = std::abs(unit.dot(a.center - b.center)) - a.reach(unit) - b.reach(unit);
    if (gap > best.gap) best = {gap, is_of_edges};
  };
  for (int i = 0; i < 3; ++i) {
    examine(a.turn.col(i), false), examine(b.turn.col(i), false);
    for (int j = 0; j < 3; ++j) examine(a.turn.col(i).cross(b.turn.col(j)), true);
  }
  return best;
}

TurnedBox random_box(RandomValues& random, const Vec3& center) {
  return {Vec3::Constant(0.6) + random.vector(0.4), center, random.rotation()};
}

/// Returns the least depth of contacts of edges of two boxes; infinite if there is none [m].
double least_depth(const TurnedBox& a, const TurnedBox& b, double deepest) {
  double least = std::numeric_limits<double>::infinity();
  for (const SharpEdge& edge : a.edges())
    for (const SharpEdge& other : b.edges()) {
      const EdgeTest test = test_edges(edge, other, deepest);
      if (!test.contact) continue;
      least = std::min(least, test.contact->depth);
      EXPECT_NEAR(test.contact->normal.norm(), 1, 1e-12);
      EXPECT_GT(test.contact->normal.dot(b.center - a.center), 0);
    }
  return least;
}

TEST(SharpEdge, ABoxHasTwelve) {
  RandomValues random(1);
  EXPECT_EQ(random_box(random, Vec3::Zero()).edges().size(), 12U);
}

TEST(SharpEdge, EdgesTouchWhereBoxesOverlapLeastAlongTheirCommonNormal) {
  constexpr double kDeepest = 0.02;  // [m]
  RandomValues random(2);
  int crossing = 0, found = 0;
  for (int seed = 0; seed < 20000; ++seed) {
    const TurnedBox a = random_box(random, Vec3::Zero()), b = random_box(random, random.vector(1));
    const BestAxis best = best_axis(a, b);
    if (best.gap < -kDeepest || best.gap > kDeepest) continue;
    const double depth = least_depth(a, b, kDeepest);
    if (best.gap > 0) {
      EXPECT_TRUE(std::isinf(depth)) << seed;
    } else if (std::isfinite(depth)) {
      EXPECT_GT(depth, -best.gap - 1e-9) << "no axis has less, seed " << seed;
    }
    if (best.gap > 0 || !best.is_of_edges) continue;
    ++crossing;
    found += std::abs(depth + best.gap) < 1e-9;
  }
  EXPECT_GT(crossing, 50);
  EXPECT_GT(found, 0.85 * crossing) << "others meet at a corner, or nearly along a face";
}

/// Moves an edge with its faces so that its ends move by at most `way` [m]: half of it by turning.
SharpEdge moved(const SharpEdge& edge, RandomValues& random, double way) {
  const Vec3 middle = 0.5 * (edge.ends[0] + edge.ends[1]), shift = 0.5 * way * random.direction();
  const Mat3 turn = Eigen::AngleAxisd(std::min(3.0, way / edge.length()), random.direction()).toRotationMatrix();
  SharpEdge other = edge;
  for (int i = 0; i < 2; ++i) {
    other.ends[i] = middle + shift + turn * (edge.ends[i] - middle);
    other.normals[i] = turn * edge.normals[i];
  }
  return other;
}

TEST(SharpEdge, NothingTouchesBeforeItHasComeAsFarAsIsClear) {
  RandomValues random(3);
  int cleared = 0;
  for (int seed = 0; seed < 2000; ++seed) {
    const TurnedBox a = random_box(random, Vec3::Zero()), b = random_box(random, random.vector(1));
    const std::vector<SharpEdge> edges = a.edges(), others = b.edges();
    for (const SharpEdge& edge : edges)
      for (const SharpEdge& other : others) {
        const EdgeTest test = test_edges(edge, other, 0.02);
        if (test.contact || test.clear == 0) continue;
        ++cleared;
        EXPECT_FALSE(test_edges(edge, moved(other, random, 0.999 * test.clear), 0.02).contact) << seed;
      }
  }
  EXPECT_GT(cleared, 0.99 * 2000 * 144) << "pairs rest";
}

}  // namespace
}  // namespace griffith::explicit_dynamics
