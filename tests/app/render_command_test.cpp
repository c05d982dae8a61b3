#include <gtest/gtest.h>

#include <set>

#include "program.h"
#include "renderer/image.h"

namespace griffith::app {
namespace {

int color_count(const render::Image& image) {
  std::set<std::array<std::uint8_t, 4>> colors;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) colors.insert(image.pixel(x, y));
  }
  return static_cast<int>(colors.size());
}

render::Image rendered(const std::string& name, const std::string& options) {
  const std::filesystem::path path = test_folder() / name;
  const Outcome outcome =
      run_program("render " + small_wall_file().string() + " -o " + path.string() + " --size 320x200 " + options);
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  return render::load_png(path);
}

TEST(RenderCommand, PictureHasItsSizeAndShowsSomething) {
  const render::Image image = rendered("a.png", "--frame 10");
  EXPECT_EQ(image.width, 320);
  EXPECT_EQ(image.height, 200);
  EXPECT_GT(color_count(image), 100);
}

TEST(RenderCommand, SameInputGivesTheSameBytes) {
  for (const char* options : {"--frame 12 --view margin", "--frame 12 --ui"}) {
    EXPECT_EQ(rendered("a.png", options), rendered("b.png", options)) << options;
  }
}

TEST(RenderCommand, OptionsChangeThePicture) {
  const render::Image plain = rendered("plain.png", "--frame 4");
  for (const char* options : {"--frame 4 --no-legend", "--frame 4 --view body", "--frame 4 --camera side",
                              "--frame 4 --ui", "--frame 4 --samples 1"}) {
    EXPECT_FALSE(rendered("other.png", options) == plain) << options;
  }
  EXPECT_EQ(rendered("other.png", "--frame 4 --legend --camera front"), plain);
}

TEST(RenderCommand, NodeIsExplainedAndOneThatIsNotThereRefused) {
  const std::string common = "render " + small_wall_file().string() + " -o " + (test_folder() / "n.png").string() +
                             " --size 200x120 --frame 6 --view candidate_plane+element_forces --node ";
  const Outcome outcome = run_program(common + "3");
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  for (const char* part : {"Node 3, step 6", "resistance", "plane across", "eigenvalues", "adds to the load"})
    EXPECT_NE(outcome.output.find(part), std::string::npos) << part;
  const Outcome refused = run_program(common + "99999");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.output.find("there is no node 99999"), std::string::npos);
  EXPECT_EQ(run_program("render " + small_wall_file().string() + " -o x.png --view margins").code, 2);
}

TEST(RenderCommand, SequenceIsNumberedAndAgreesWithSinglePictures) {
  run_program("render " + small_wall_file().string() + " -o " + (test_folder() / "s.png").string() +
              " --size 320x200 --frame 8 --every 4");
  for (const int frame : {0, 4, 8}) {
    const std::string number = "000" + std::to_string(frame);
    EXPECT_EQ(render::load_png(test_folder() / ("s_" + number + ".png")),
              rendered("single.png", "--frame " + std::to_string(frame)));
  }
  EXPECT_FALSE(std::filesystem::exists(test_folder() / "s.png"));
}

}  // namespace
}  // namespace griffith::app
