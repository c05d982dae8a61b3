#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "program.h"
#include "renderer/image.h"
#include "sim/core/read_file.h"
#include "sim/world/world.h"

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

TEST(RenderCommand, ExposuresOfAPosterSmoothEdgesWithoutSamplesOfTheirOwn) {
  const std::string poster = "--frame 4 --quality poster";
  const render::Image usual = rendered("poster.png", poster), four = rendered("four.png", poster + " --samples 4");
  EXPECT_EQ(usual, rendered("one.png", poster + " --samples 1"));
  double squares = 0;
  for (std::size_t i = 0; i < usual.rgba.size(); ++i) squares += std::pow(usual.rgba[i] - four.rgba[i], 2);
  const double difference = std::sqrt(squares / static_cast<double>(usual.rgba.size()));
  EXPECT_LT(difference, 1.5) << "of 255";
}

TEST(RenderCommand, ADraftHasRoughEdgesUnlessAskedOtherwise) {
  const std::string draft = "--frame 4 --no-legend --set view/quality=draft";
  EXPECT_EQ(rendered("draft.png", draft), rendered("rough.png", draft + " --samples 1"));
  EXPECT_FALSE(rendered("smooth.png", draft + " --samples 4") == rendered("rough.png", draft + " --samples 1"));
}

TEST(RenderCommand, AQualityIsAsTheSceneHasItOrAsAskedFor) {
  const std::string frame = "--frame 4 --no-legend ";
  std::set<std::string> pictures;
  for (const std::string quality : {"draft", "standard", "high"}) {
    const render::Image asked = rendered("asked.png", frame + "--quality " + quality);
    EXPECT_EQ(asked, rendered("set.png", frame + "--set view/quality=" + quality)) << quality;
    pictures.emplace(asked.rgba.begin(), asked.rgba.end());
  }
  EXPECT_EQ(pictures.size(), 3u);
  const Outcome refused = run_program("render " + small_wall_file().string() + " -o x.png --quality best");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.output.find("draft"), std::string::npos) << refused.output;
}

TEST(RenderCommand, NodeIsExplainedAndOneThatIsNotThereRefused) {
  const std::string common = "render " + small_wall_file().string() + " -o " + (test_folder() / "n.png").string() +
                             " --size 200x120 --frame 6 --view candidate_plane+element_forces --node ";
  const Outcome outcome = run_program(common + "3");
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  for (const char* part : {"Node 3, step 6", "resistance", "plane across", "eigenvalues", "contribution"})
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
TEST(RenderCommand, AMissingLibraryOfGraphicsIsReported) {
  const auto folder = test_folder() / "libraries";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "libEGL.so.1") << "no library";
  const Outcome outcome =
      run_program("render " + small_wall_file().string() + " -o " + (test_folder() / "a.png").string(),
                  "LD_LIBRARY_PATH=" + folder.string());
  EXPECT_EQ(outcome.code, 1) << outcome.output;
  EXPECT_NE(outcome.output.find("libegl1"), std::string::npos) << outcome.output;
}

/// The program's options for pictures of the wall in a folder of their own, and what they left there.
std::set<std::string> files_of_render(const std::string& folder, const std::string& options,
                                      const std::string& size = "160x100") {
  const std::filesystem::path path = test_folder() / folder;
  std::filesystem::remove_all(path);
  std::filesystem::create_directories(path);
  const Outcome outcome = run_program("render " + small_wall_file().string() + " --size " + size + " -o " +
                                      (path / "w.png").string() + " " + options);
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(path)) files.insert(entry.path().filename());
  return files;
}

TEST(RenderCommand, OneRunDrawsFramesViewsAndCamerasAsRunsOfTheirOwnDo) {
  const std::set<std::string> files =
      files_of_render("many", "--frames 2,6 --view body --view utilization --camera front --camera side");
  EXPECT_EQ(files.size(), 8u);
  const render::Image one = render::load_png(test_folder() / "many" / "w_side_utilization_0006.png");
  files_of_render("one", "--frame 6 --view utilization --camera side");
  EXPECT_EQ(render::load_png(test_folder() / "one" / "w.png"), one);
  EXPECT_TRUE(files.contains("w_front_body_0002.png"));
}

TEST(RenderCommand, PanelsOfSeveralViewsDoNotKeepTheViewBefore) {
  files_of_render("many", "--frames 0,3 --view utilization+slice --view body --ui", "640x360");
  files_of_render("one", "--frames 3 --view body --ui", "640x360");
  EXPECT_EQ(render::load_png(test_folder() / "many" / "w_body_0003.png"),
            render::load_png(test_folder() / "one" / "w_0003.png"));
}

TEST(RenderCommand, WithoutBackgroundEveryPixelIsTheObjectsOrNothing) {
  // Without what shades the ground, and without shards and lines of cracks, of which rounding in depth, which the
  // ground changes, shows one or the other.
  const std::string common = "--frame 4 --no-legend --samples 1 --view speed --set view/quality=draft";
  files_of_render("clear", common + " --transparent --records");
  files_of_render("full", common);
  const render::Image clear = render::load_png(test_folder() / "clear/w.png");
  const render::Image full = render::load_png(test_folder() / "full/w.png");
  int opaque = 0, empty = 0;
  for (int y = 0; y < clear.height; ++y) {
    for (int x = 0; x < clear.width; ++x) {
      const auto pixel = clear.pixel(x, y);
      if (pixel[3] == 255) {
        EXPECT_EQ(pixel, full.pixel(x, y)) << x << ", " << y;
      }
      opaque += pixel[3] == 255;
      empty += pixel[3] == 0;
    }
  }
  EXPECT_GT(opaque, 300);
  EXPECT_GT(empty, 3000);
}

TEST(RenderCommand, ContactSheetHasAllPicturesAtTheirPlaces) {
  const std::filesystem::path sheet = test_folder() / "sheet.png";
  files_of_render("many", "--frames 0,4 --view body --view utilization --contact-sheet " + sheet.string());
  const render::Image image = render::load_png(sheet);
  EXPECT_GT(image.width, 2 * 160);
  EXPECT_LT(image.width, 2 * 160 + 40);
  EXPECT_GT(image.height, 2 * 100);
  const render::Image last = render::load_png(test_folder() / "many/w_utilization_0004.png");
  bool found = false;
  for (int y = 0; y <= image.height - 100 && !found; ++y) {
    for (int x = 0; x <= image.width - 160 && !found; ++x) {
      found = image.pixel(x, y) == last.pixel(0, 0) && image.pixel(x + 80, y + 50) == last.pixel(80, 50) &&
              image.pixel(x + 159, y + 99) == last.pixel(159, 99);
    }
  }
  EXPECT_TRUE(found);
}

TEST(RenderCommand, VideoHasAllPicturesOrFfmpegIsReportedMissing) {
  const std::filesystem::path video = test_folder() / "wall.mp4";
  const std::string command =
      "render " + small_wall_file().string() + " --size 160x100 --frames 0:9 --video " + video.string();
  if (std::system("ffprobe -version >/dev/null 2>&1") == 0) {
    const Outcome outcome = run_program(command);
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    const std::string count = (test_folder() / "count").string();
    ASSERT_EQ(std::system(("ffprobe -v error -count_packets -show_entries stream=width,height,nb_read_packets -of "
                           "csv=p=0 " +
                           video.string() + " >" + count)
                              .c_str()),
              0);
    std::ifstream file(count);
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line, "160,100,10");
  }
  const Outcome missing = run_program(command, "env PATH=/nonexistent");
  EXPECT_EQ(missing.code, 2);
  EXPECT_NE(missing.output.find("ffmpeg is missing"), std::string::npos) << missing.output;
}

TEST(RenderCommand, ArgumentsThatDoNotGoTogetherAreRefused) {
  const std::string scene = small_wall_file().string(), png = " -o " + (test_folder() / "x.png").string();
  for (const std::string& arguments :
       {scene, scene + png + " --frames 3:1", scene + png + " --frames 0:4 --frame 4",
        scene + png + " --ui --transparent", scene + " --video x.avi", scene + " -o x.jpg",
        "--job-file none.json" + png, scene + png + " --camera nowhere", scene + png + " --view nothing",
        scene + png + " --view body --view body", std::string("--job-file x.json --size 99x99 -o pictures"),
        scene + png + " --only x", std::string("-o x.png"), scene + " --contact-sheet /nonexistent/a.png"}) {
    const Outcome outcome = run_program("render " + arguments);
    EXPECT_EQ(outcome.code, 2) << arguments << "\n" << outcome.output;
  }
}

TEST(RenderCommand, AFileOfJobsDrawsThemAllAndOneAlone) {
  small_wall_file();
  const std::filesystem::path jobs = test_file("jobs.json", R"({"defaults": {"size": [80, 60]}, "pictures": [
      {"name": "a", "scene": "small_wall.json", "frames": "0:2", "views": ["body", "utilization"]},
      {"name": "b", "scene": "small_wall.json", "transparent": true}]})");
  const std::filesystem::path out = test_folder() / "pictures";
  std::filesystem::remove_all(out);
  const auto count = [&] {
    return std::distance(std::filesystem::directory_iterator(out), std::filesystem::directory_iterator());
  };
  ASSERT_EQ(run_program("render --job-file " + jobs.string() + " --only b -o " + out.string()).code, 0);
  EXPECT_EQ(count(), 1);
  ASSERT_EQ(run_program("render --job-file " + jobs.string() + " -o " + out.string()).code, 0);
  EXPECT_EQ(count(), 7);
  EXPECT_EQ(run_program("render --job-file " + jobs.string() + " --only c -o " + out.string()).code, 2);
}

TEST(RenderCommand, ATurntableGoesOnceAroundTheTarget) {
  const std::filesystem::path folder = test_folder() / "turntable";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const std::string command = "render " + small_wall_file().string() + " --size 160x100 --no-legend --frame 4 -o " +
                              (folder / "wall.png").string();
  ASSERT_EQ(run_program(command + " --turntable 4").code, 0);
  std::set<std::string> pictures;
  for (const char* name : {"wall_000.png", "wall_001.png", "wall_002.png", "wall_003.png"}) {
    const render::Image image = render::load_png(folder / name);
    pictures.emplace(image.rgba.begin(), image.rgba.end());
  }
  EXPECT_EQ(pictures.size(), 4u);
  ASSERT_EQ(run_program(command).code, 0);
  EXPECT_EQ(render::load_png(folder / "wall.png"), render::load_png(folder / "wall_000.png"))
      << "the camera's own view";
  const Outcome refused = run_program(command + " --turntable 8 --ui");
  EXPECT_EQ(refused.code, 2);
}

/// Returns the first step of the small wall with microsteps.
int first_struck_step() {
  World world(small_wall());
  do world.step();
  while (world.frame().report.microsteps == 0);
  return static_cast<int>(world.frame().step);
}

TEST(RenderCommand, MicrostepsOfAnImpactAreDrawnWithTheirTimes) {
  const std::filesystem::path folder = test_folder() / "microsteps";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const std::string command = "render " + small_wall_file().string() + " --size 160x100 --records --microsteps 5 -o " +
                              (folder / "wall.png").string();
  const Outcome refused = run_program(command + " --frame 1");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.output, ::testing::HasSubstr("step 1 has no microsteps"));
  EXPECT_EQ(run_program(command).code, 2) << "nothing comes before frame 0";
  EXPECT_EQ(run_program(command + " --frame 20 --ui").code, 2);
  const int struck = first_struck_step();
  ASSERT_EQ(run_program(command + " --frame " + std::to_string(struck)).code, 0);
  double time = 0;
  for (int i = 0; i < 4; ++i) {
    const std::string name = "wall_00" + std::to_string(i);
    EXPECT_THAT(read_file(folder / (name + ".txt")), ::testing::HasSubstr(" µs"));
    const auto record = nlohmann::json::parse(read_file(folder / (name + ".json")));
    EXPECT_EQ(record.at("frame"), struck);
    EXPECT_GT(record.at("statistics").at("time").get<double>(), time);
    time = record.at("statistics").at("time");
  }
}

TEST(RenderCommand, EveryNthAngleOfAFinerTurntableIsThatOfACoarseOne) {
  const std::filesystem::path folder = test_folder() / "angles";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const auto draw = [&](const std::string& name, int count) {
    const Outcome outcome = run_program("render " + small_wall_file().string() + " --size 160x100 --turntable " +
                                        std::to_string(count) + " -o " + (folder / (name + ".png")).string());
    ASSERT_EQ(outcome.code, 0) << outcome.output;
  };
  draw("coarse", 3);
  draw("fine", 6);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(render::load_png(folder / ("coarse_00" + std::to_string(i) + ".png")),
              render::load_png(folder / ("fine_00" + std::to_string(2 * i) + ".png")));
}

TEST(RenderCommand, SeveralScenesOrAFolderAreDrawnOneAfterTheOther) {
  const std::filesystem::path folder = test_folder() / "batch", scenes = folder / "scenes";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(scenes);
  std::filesystem::copy_file(small_wall_file(), scenes / "a.json");
  std::ofstream(scenes / "b.json") << "{}";
  std::filesystem::copy_file(small_wall_file(), scenes / "c.json");
  const std::string how = " --size 160x100 -o " + (folder / "pictures").string();
  const Outcome outcome = run_program("render " + scenes.string() + how);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.output.find("1 of 3 scenes could not be drawn"), std::string::npos) << outcome.output;
  for (const char* name : {"a.png", "c.png"})
    EXPECT_EQ(render::load_png(folder / "pictures" / name).width, 160) << "those after a bad one too";
  const Outcome list = run_program("render " + (scenes / "a.json").string() + " " + (scenes / "c.json").string() + how +
                                   " --frames 0:4:2 --contact-sheet " + (folder / "sheet.png").string());
  EXPECT_EQ(list.code, 0) << list.output;
  for (const char* name : {"pictures/a_0004.png", "pictures/c_0000.png", "sheet_a.png", "sheet_c.png"})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  const Outcome twice =
      run_program("render " + (scenes / "a.json").string() + " " + (scenes / "a.json").string() + how);
  EXPECT_EQ(twice.code, 2);
  EXPECT_NE(twice.output.find("earlier scene"), std::string::npos) << twice.output;
}

TEST(RenderCommand, SizesHaveLimits) {
  for (const char* size : {"15x100", "70000x100", "30000x30000", "1280"}) {
    const Outcome refused = run_program("render " + small_wall_file().string() + " -o x.png --size " + size);
    EXPECT_EQ(refused.code, 2) << size;
  }
}

}  // namespace
}  // namespace griffith::app
