#include "app/render/frame_list.h"

#include <gtest/gtest.h>

#include "sim/core/error.h"

namespace griffith::app {
namespace {

using Frames = std::vector<int>;

TEST(FrameList, NumbersRangesAndListsOfThemAreAscendingAndEachOnce) {
  EXPECT_EQ(frames_from_text("60", ""), Frames({60}));
  EXPECT_EQ(frames_from_text("0:3", ""), Frames({0, 1, 2, 3}));
  EXPECT_EQ(frames_from_text("0:10:4", ""), Frames({0, 4, 8}));
  EXPECT_EQ(frames_from_text("9,2:6:2,4,0", ""), Frames({0, 2, 4, 6, 9}));
  EXPECT_EQ(frames_from_text("5:5", ""), Frames({5}));
}

TEST(FrameList, OtherTextIsRefusedWithItsPlace) {
  for (const char* text :
       {"", "-1", "1.5", "a", "3:1", "0:9:0", "0:9:-2", "1:2:3:4", "1,,2", ":", "99999999999", " 3"}) {
    try {
      frames_from_text(text, "--frames");
      ADD_FAILURE() << "\"" << text << "\" was taken";
    } catch (const InputError& error) {
      EXPECT_EQ(error.where(), "--frames");
    }
  }
  EXPECT_THROW(frames_from_text("0:10000000,0:9", ""), InputError);
}

}  // namespace
}  // namespace griffith::app
