#include "sim/core/ids.h"

#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <span>
#include <vector>

namespace griffith {
namespace {

template <class Left, class Right>
concept Comparable = requires(Left a, Right b) {
  a == b;
}
|| requires(Left a, Right b) { a < b; };
template <class Left, class Right>
concept Computable = requires(Left a, Right b) {
  a + b;
}
|| requires(Left a, Right b) { a - b; }
|| requires(Left a, Right b) { a* b; }
|| requires(Left a, Right b) { a += b; };
template <class T>
concept Countable = requires(T a) {
  ++a;
}
|| requires(T a) { a--; }
|| requires(T a) { -a; };
template <class T>
concept Conditional = requires(T a) {
  a ? 1 : 0;
}
|| requires(T a) { !a; };
template <class Array, class Index>
concept Subscriptable = requires(Array array, Index i) {
  array[i];
};
template <class T>
concept Printable = requires(T a) {
  std::cout << a;
};

static_assert(!std::is_convertible_v<NodeId, int> && !std::is_convertible_v<NodeId, std::int64_t>);
static_assert(!std::is_convertible_v<NodeId, double> && !std::is_convertible_v<NodeId, bool>);
static_assert(!std::is_convertible_v<int, NodeId> && !std::is_constructible_v<int, NodeId>);
static_assert(!std::is_constructible_v<NodeId, TetId> && !std::is_assignable_v<NodeId&, TetId>);
static_assert(Comparable<NodeId, NodeId> && !Comparable<NodeId, TetId>);
static_assert(!Comparable<NodeId, int> && !Comparable<NodeId, std::size_t> && !Comparable<int, NodeId>);
static_assert(!Computable<NodeId, int> && !Computable<NodeId, std::size_t> && !Computable<NodeId, NodeId>);
static_assert(!Computable<NodeId, TetId> && !Computable<int, NodeId> && !Computable<int*, NodeId>);
static_assert(!Countable<NodeId> && !Conditional<NodeId> && !Printable<NodeId>);
static_assert(Subscriptable<std::vector<double>, NodeId> && Subscriptable<std::span<double>, NodeId>);
static_assert(Subscriptable<std::array<double, 3>, NodeId> && !Subscriptable<double*, NodeId>);

TEST(Ids, LookUpWhatStandsAtTheirIndex) {
  const std::vector<double> values = {1, 2, 3};
  EXPECT_EQ(values[NodeId(2)], 3);
  EXPECT_EQ(NodeId(2).index(), 2);
  EXPECT_EQ(NodeId(2).shifted(NodeId(40)), NodeId(42));
}

TEST(Ids, OfNothingIsTheOnlyInvalidOneAndComesFirst) {
  EXPECT_FALSE(TetId().valid());
  EXPECT_TRUE(TetId(0).valid());
  EXPECT_LT(TetId(), TetId(0));
}

TEST(Ids, OfARangeComeInOrderAndNoneOfAnEmptyOne) {
  std::vector<TetId> found;
  for (const TetId tet : IdRange<TetId>(2, 4)) found.push_back(tet);
  EXPECT_EQ(found, (std::vector<TetId>{TetId(2), TetId(3)}));
  for (const TetId tet : IdRange<TetId>(4, 2)) ADD_FAILURE() << tet.index();
}

}  // namespace
}  // namespace griffith
