#include "app/key_latch.h"

#include <gtest/gtest.h>

namespace griffith::app {
namespace {

TEST(KeyLatch, TapWithinAFrameIsReleasedAfterIt) {
  KeyLatch latch;
  latch.press(' ');
  latch.press('M');
  EXPECT_FALSE(latch.release(' '));
  EXPECT_EQ(latch.end_frame(), std::vector<int>{' '});
  EXPECT_TRUE(latch.release('M')) << "M was seen by the frame";
  EXPECT_TRUE(latch.end_frame().empty());
}

TEST(KeyLatch, KeyItWasNotToldOfIsReleasedAtOnce) {
  KeyLatch latch;
  EXPECT_TRUE(latch.release('F'));
  EXPECT_TRUE(latch.end_frame().empty());
}

}  // namespace
}  // namespace griffith::app
