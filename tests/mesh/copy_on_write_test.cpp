#include "sim/core/copy_on_write.h"

#include <gtest/gtest.h>

#include <numeric>
#include <thread>
#include <utility>
#include <vector>

namespace griffith {
namespace {

SharedArray<int> counted(int count) {
  SharedArray<int> array;
  array.edit().resize(count);
  std::iota(array.edit().begin(), array.edit().end(), 0);
  return array;
}

TEST(CopyOnWrite, CopiesShareUntilOneIsEdited) {
  SharedArray<int> original = counted(4);
  const SharedArray<int> copy = original;
  EXPECT_TRUE(copy.shares_with(original));
  EXPECT_EQ(copy.data(), original.data());
  original.edit()[2] = 7;
  EXPECT_FALSE(copy.shares_with(original));
  EXPECT_EQ(copy[2], 2);
  EXPECT_EQ(original[2], 7);
}

TEST(CopyOnWrite, EditsOfWhatIsOwnedAloneStayInPlace) {
  SharedArray<int> array = counted(4);
  const int* place = array.data();
  array.edit()[0] = 5;
  EXPECT_EQ(array.data(), place);
  const SharedArray<int> copy = array;
  array.edit()[0] = 6;
  EXPECT_NE(array.data(), place);
  place = array.data();
  array.edit()[0] = 7;
  EXPECT_EQ(array.data(), place) << "once is enough";
  EXPECT_EQ(copy[0], 5);
}

TEST(CopyOnWrite, WhatIsMovedKeepsWhomItSharesWith) {
  SharedArray<int> original = counted(4);
  const SharedArray<int> copy = original;
  SharedArray<int> moved = std::move(original);
  SharedArray<int> assigned;
  assigned = std::move(moved);
  EXPECT_TRUE(assigned.shares_with(copy));
  assigned.edit()[1] = 9;
  EXPECT_EQ(copy[1], 1);
  SharedArray<int> alone = counted(4);
  const int* place = alone.data();
  SharedArray<int> taken = std::move(alone);
  taken.edit()[1] = 9;
  EXPECT_EQ(taken.data(), place);
}

TEST(CopyOnWrite, AssignmentTakesTheValueOfTheOther) {
  SharedArray<int> array = counted(2);
  const SharedArray<int> other = counted(5);
  array = other;
  EXPECT_EQ(array.size(), 5u);
  array.edit().clear();
  EXPECT_EQ(other.size(), 5u);
}

/// Copies go from thread to thread as worlds do: one is read and copied while others are edited. Thread sanitizers see
/// whether what is written may still be read elsewhere.
TEST(CopyOnWrite, CopiesLiveOnThreadsOfTheirOwn) {
  constexpr int kCount = 1000, kRounds = 200;
  SharedArray<int> shown = counted(kCount);
  for (int round = 0; round < kRounds; ++round) {
    SharedArray<int> next = shown;
    std::thread edits([&next] {
      for (int& value : next.edit()) ++value;
    });
    const SharedArray<int> kept = shown;
    ASSERT_EQ(std::accumulate(kept.begin(), kept.end(), 0), kCount * (kCount - 1) / 2 + kCount * round);
    edits.join();
    shown = std::move(next);
  }
}

}  // namespace
}  // namespace griffith
