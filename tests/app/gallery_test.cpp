#include "app/render/gallery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "app/render/read_render_jobs.h"
#include "sim/scene/scene_reader.h"
#include "tests/app/program.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

std::string file_text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Gallery, HasEachPictureWithItsSceneAndCommand) {
  small_wall_file();
  std::ofstream(test_folder() / "jobs.json") << R"({"defaults": {"size": [64, 36], "quality": "draft"}, "pictures": [
             {"name": "one", "scene": "small_wall.json"},
             {"name": "two", "scene": "small_wall.json", "frames": 3, "cameras": ["side"], "views": ["material"],
              "environment": "sky", "legend": false}]})";
  const fs::path page = test_folder() / "page.md";
  const Outcome outcome = run_program("gallery " + (test_folder() / "jobs.json").string() + " -o " + page.string());
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  const std::string text = file_text_of(page);
  for (const char* part :
       {"![small wall](page/one.jpg)", "![small wall](page/two.jpg)",
        "--frame 3 --view material --camera side --quality draft --environment sky --no-legend --size 64x36"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  for (const char* name : {"one", "two"}) {
    const render::Image image =
        render::decode_image(file_text_of(test_folder() / "page" / (std::string(name) + ".jpg")), 100, 100);
    EXPECT_EQ(image.width, 64);
    EXPECT_EQ(image.height, 36);
  }
}

TEST(Gallery, ThatOfTheDocsHasAllSampleScenesWithTheirCameras) {
  const fs::path source = GRIFFITH_SOURCE_DIR;
  std::set<std::string> shown;
  for (const RenderJob& job : read_render_jobs(source / "docs" / "gallery.json")) {
    shown.insert(job.scene.filename().string());
    const Scene scene = read_scene(job.scene);
    for (const std::string& camera : job.cameras)
      EXPECT_TRUE(std::ranges::any_of(scene.cameras, [&](const Camera& known) { return known.name == camera; }))
          << job.name;
  }
  for (const fs::path& file : fs::directory_iterator(source / "scenes")) {
    const bool is_scene = file.extension() == ".json" && file.filename() != "scene.schema.json";
    if (!is_scene || file.filename() == "wall_small_csv.json")
      continue;  // that one differs in its file of a mesh alone
    EXPECT_TRUE(shown.contains(file.filename().string())) << file;
  }
}

}  // namespace
}  // namespace griffith::app
