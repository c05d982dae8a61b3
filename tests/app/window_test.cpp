#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "program.h"
#include "renderer/image.h"

namespace griffith::app {
namespace {

/// No edits of a program that was killed are found, which would be asked for.
std::string clean_state() {
  return "env XDG_STATE_HOME=" + (test_folder() / "state").string() +
         " XDG_CONFIG_HOME=" + (test_folder() / "config").string() + " ";
}

TEST(Window, OpensDrawsAndLeavesAPictureOfItself) {
  if (std::system("command -v xvfb-run > /dev/null") != 0) GTEST_SKIP() << "xvfb-run is not installed";
  const std::filesystem::path path = test_folder() / "window.png";
  const Outcome outcome = run_program(small_wall_file().string() + " --exit-after 6 --screenshot " + path.string(),
                                      clean_state() + "xvfb-run -a -s '-screen 0 1600x1000x24'");
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  const render::Image image = render::load_png(path);
  EXPECT_EQ(image.width, 1500);
  EXPECT_EQ(image.height, 940);
  // The menu is darker than the backdrop of the picture.
  EXPECT_LT(image.pixel(1400, 6)[0], 60);
  EXPECT_GT(image.pixel(700, 100)[2], 60);
}

TEST(Window, PlaysAScriptAndTakesPreferences) {
  if (std::system("command -v xvfb-run > /dev/null") != 0) GTEST_SKIP() << "xvfb-run is not installed";
  const std::filesystem::path picture = test_folder() / "script.png";
  const std::filesystem::path script =
      test_file("a.script",
                "step 2\nexpect toolbar/step \"step 2\"\nclick command/simulation.step\n"
                "expect toolbar/step \"step 3\"\nscreenshot " +
                    picture.string() + "\ncommand file.quit\n");
  std::filesystem::create_directories(test_folder() / "config/griffith");
  std::ofstream(test_folder() / "config/griffith/preferences.json") << R"({"left_width": 400})";
  const Outcome outcome = run_program(small_wall_file().string() + " --exit-after 400 --script " + script.string(),
                                      clean_state() + "xvfb-run -a -s '-screen 0 1600x1000x24'");
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  const render::Image image = render::load_png(picture);
  EXPECT_LT(image.pixel(390, 500)[2], 80) << "the side panel is as wide as preferred";
  EXPECT_GT(image.pixel(410, 400)[2], 100) << "and no wider";
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
