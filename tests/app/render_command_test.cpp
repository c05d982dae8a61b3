#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
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
  for (const char* options : {"--frame 12 --view utilization", "--frame 12 --ui"}) {
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
  EXPECT_EQ(run_program("render " + small_wall_file().string() + " -o x.png --view utilizations").code, 2);
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

/// The limit on file sizes, four kilobytes, stands in for a full disk.
TEST(RenderCommand, APictureThatFindsNoRoomLeavesTheOldOne) {
  const auto path = test_file("a.png", "the old picture");
  const auto files = [] { return std::distance(std::filesystem::directory_iterator(test_folder()), {}); };
  const std::string scene = small_wall_file().string();
  const auto before = files();
  const Outcome outcome = run_program("render " + scene + " --size 640x400 -o " + path.string(),
                                      "ulimit -f 8; MESA_SHADER_CACHE_DISABLE=true");
  EXPECT_EQ(outcome.code, 2) << outcome.output;
  EXPECT_NE(outcome.output.find("a.png: cannot be written: File too large"), std::string::npos) << outcome.output;
  std::ifstream old(path);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(old), {}), "the old picture");
  EXPECT_EQ(files(), before);
}

/// A file that is no library stands in for one that is missing.
TEST(RenderCommand, AMissingLibraryOfGraphicsIsTold) {
  const auto folder = test_folder() / "libraries";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "libEGL.so.1") << "no library";
  const Outcome outcome =
      run_program("render " + small_wall_file().string() + " -o " + (test_folder() / "a.png").string(),
                  "LD_LIBRARY_PATH=" + folder.string());
  EXPECT_EQ(outcome.code, 1) << outcome.output;
  EXPECT_NE(outcome.output.find("libegl1"), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace griffith::app
