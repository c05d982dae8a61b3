#include "app/regress/compare_ids.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "app/output/id_picture.h"
#include "renderer/error.h"

namespace griffith::app {
namespace {

TEST(CompareIds, PicturesKeepThem) {
  const render::IdImage ids{4, 2, {-1, 0, 1, 2, 1000, 123456, 16777213, 16777214}};
  EXPECT_EQ(ids_of_picture(render::decode_png(render::encode_png(id_picture(ids)))), ids);
  EXPECT_THROW(id_picture({1, 1, {16777215}}), render::RenderError);
  EXPECT_THROW(id_picture({1, 1, {-2}}), render::RenderError);
}

TEST(CompareIds, NeighborsHaveColorsFarApart) {
  render::IdImage ids{1000, 1, {}};
  for (int id = -1; id < 999; ++id) ids.ids.push_back(id);
  const render::Image picture = id_picture(ids);
  for (int x = 0; x + 1 < 1000; ++x) {
    const auto one = picture.pixel(x, 0), next = picture.pixel(x + 1, 0);
    EXPECT_GT(std::abs(one[0] - next[0]) + std::abs(one[1] - next[1]) + std::abs(one[2] - next[2]), 60) << x;
  }
}

TEST(CompareIds, WhatIsGoneAndNewIsNamed) {
  const render::IdImage golden{64, 32, std::vector<std::int32_t>(64 * 32, 3)};
  render::IdImage actual = golden;
  EXPECT_TRUE(compare_ids(golden, actual).passed);
  actual.ids[5] = 4;
  EXPECT_TRUE(compare_ids(golden, actual).passed) << "one pixel at an edge";
  for (std::int32_t i = 0; i < 10; ++i) actual.ids[i] = 10 + i;
  const IdComparison comparison = compare_ids(golden, actual);
  EXPECT_FALSE(comparison.passed);
  EXPECT_EQ(comparison.off.count, 10);
  EXPECT_NE(comparison.reason.find("new: 10, 11, 12, 13, 14, 15 and 4 more"), std::string::npos) << comparison.reason;
  EXPECT_EQ(comparison.reason.find("gone"), std::string::npos) << comparison.reason;
}

TEST(CompareIds, OtherSizesFail) { EXPECT_FALSE(compare_ids({2, 1, {1, 1}}, {1, 2, {1, 1}}).passed); }

}  // namespace
}  // namespace griffith::app
