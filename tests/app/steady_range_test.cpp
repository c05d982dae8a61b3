#include "app/picture/steady_range.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/picture/quantities.h"
#include "program.h"
#include "sim/world/world.h"

namespace griffith::app {
namespace {

Vec2 range_now(const Frame& frame, const std::string& quantity) {
  return automatic_range(frame, quantity, quantity_values(frame, *find_quantity(quantity)));
}

TEST(SteadyRange, GrowsAtOnceAndShrinksSlowlyWhereTheRangeOfAFrameAloneJumps) {
  World world(small_wall());
  SteadyRange steady;
  steady.follow(world.frame(), "von_mises");
  double largest_fall = 0, largest_own_fall = 0, before = (*steady.range())[1], own_before = before;
  for (int step = 0; step < 60; ++step) {
    world.step();
    steady.follow(world.frame(), "von_mises");
    const double now = (*steady.range())[1], own = range_now(world.frame(), "von_mises")[1];
    EXPECT_GE(now, own);
    largest_fall = std::max(largest_fall, 1 - now / before);
    largest_own_fall = std::max(largest_own_fall, 1 - own / own_before);
    before = now;
    own_before = own;
  }
  EXPECT_LE(largest_fall, 0.0801);
  EXPECT_GT(largest_own_fall, 0.2);  // or the impact tests nothing
}

TEST(SteadyRange, HangsOnStepsNotOnHowOftenItIsAsked) {
  World world(small_wall());
  SteadyRange once, often;
  for (int step = 0; step < 20; ++step) {
    once.follow(world.frame(), "pressure");
    for (int i = 0; i <= step % 3; ++i) often.follow(world.frame(), "pressure");
    EXPECT_TRUE(*once.range() == *often.range()) << step;
    world.step();
  }
}

TEST(SteadyRange, AnotherQuantityOrWorldStartsAgain) {
  World world(small_wall());
  for (int step = 0; step < 12; ++step) world.step();
  SteadyRange steady;
  steady.follow(world.frame(), "speed");
  steady.follow(world.frame(), "von_mises");
  EXPECT_TRUE(*steady.range() == range_now(world.frame(), "von_mises"));
  const World fresh(small_wall());
  steady.follow(fresh.frame(), "von_mises");
  EXPECT_TRUE(*steady.range() == range_now(fresh.frame(), "von_mises"));
  steady.follow(fresh.frame(), "body");
  EXPECT_FALSE(steady.range());
}

}  // namespace
}  // namespace griffith::app
