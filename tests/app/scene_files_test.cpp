#include "app/shared/scene_files.h"

#include <gmock/gmock.h>

#include "program.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;

/// Works in the test's folder, which has samples.
class SceneFiles : public ::testing::Test {
 protected:
  SceneFiles() {
    fs::remove_all(test_folder());
    for (const char* folder : {"scenes", "mine"}) fs::create_directories(test_folder() / folder);
    for (const char* file : {"scenes/a.json", "scenes/b.json", "mine/c.json"}) test_file(file, "{}");
    fs::current_path(test_folder());
  }
  ~SceneFiles() override {
    fs::current_path(before_);
    fs::remove_all(test_folder());
  }

 private:
  fs::path before_ = fs::current_path();
};

TEST_F(SceneFiles, TheSamplesStayBesideThoseOfAnotherFolder) {
  EXPECT_THAT(scene_files("mine/c.json"), ElementsAre("mine/c.json", "scenes/a.json", "scenes/b.json"));
}

TEST_F(SceneFiles, NoneComesTwice) {
  EXPECT_THAT(scene_files("scenes/a.json"), ElementsAre("scenes/a.json", "scenes/b.json"));
  EXPECT_THAT(scene_files(""), ElementsAre("scenes/a.json", "scenes/b.json"));
}

}  // namespace
}  // namespace griffith::app
