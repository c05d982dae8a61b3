#include <gtest/gtest.h>

#include <cstdlib>

#include "program.h"
#include "renderer/image.h"

namespace griffith::app {
namespace {

/// No edits of a program that was killed are found, which would be asked for.
std::string clean_state() { return "env XDG_STATE_HOME=" + (test_folder() / "state").string() + " "; }

TEST(Window, OpensDrawsAndLeavesAPictureOfItself) {
  if (std::system("command -v xvfb-run > /dev/null") != 0) GTEST_SKIP() << "xvfb-run is not installed";
  const std::filesystem::path path = test_folder() / "window.png";
  const Outcome outcome = run_program(small_wall_file().string() + " --exit-after 6 --screenshot " + path.string(),
                                      clean_state() + "xvfb-run -a -s '-screen 0 1600x1000x24'");
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  const render::Image image = render::load_png(path);
  EXPECT_EQ(image.width, 1500);
  EXPECT_EQ(image.height, 940);
  // The menu is dark, the picture's sky is light.
  EXPECT_LT(image.pixel(1400, 6)[0], 80);
  EXPECT_GT(image.pixel(700, 100)[2], 150);
}

TEST(Window, IsNoLargerThanTheScreen) {
  if (std::system("command -v xvfb-run > /dev/null") != 0) GTEST_SKIP() << "xvfb-run is not installed";
  const std::filesystem::path path = test_folder() / "small_window.png";
  const Outcome outcome = run_program(small_wall_file().string() + " --exit-after 6 --screenshot " + path.string(),
                                      clean_state() + "xvfb-run -a -s '-screen 0 1280x720x24'");
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  const render::Image image = render::load_png(path);
  EXPECT_EQ(image.width, 1280);
  EXPECT_EQ(image.height, 720);
}

}  // namespace
}  // namespace griffith::app
