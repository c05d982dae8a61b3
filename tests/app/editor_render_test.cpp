// The dialog Render: stills of any size, turntables, all scenes of a folder.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "editor_fixture.h"
#include "renderer/image.h"
#include "sim/core/replace_file.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

class EditorRender : public EditorTest {
 protected:
  EditorRender() { fs::remove_all(test_folder()), fs::create_directories(test_folder()); }

  /// Draws what the state asks for.
  void write(const fs::path& path) {
    editor_.execute({.name = "file.write_pictures", .path = path});
    wait_for_work();
  }
  ui::RenderRequest& request() { return editor_.state().render; }
};

TEST_F(EditorRender, TheDialogDrawsAStillInTheSizeThatItAsksFor) {
  press_key('R', true);
  draw(3);
  request().width = 500;
  request().height = 300;
  request().path = (test_folder() / "still.png").string();
  draw(2);
  EXPECT_THAT(value("render/whole_path"), HasSubstr("still.png"));
  const std::uint64_t hash = editor_.run().world().state_hash();
  click("render/render");
  wait_for_work();
  const render::Image image = render::load_png(test_folder() / "still.png");
  EXPECT_EQ(image.width, 500);
  EXPECT_EQ(image.height, 300);
  EXPECT_FALSE(request().shown);
  EXPECT_EQ(editor_.run().world().state_hash(), hash);
  EXPECT_THAT(editor_.state().log.back().text, HasSubstr("still.png"));
}

TEST_F(EditorRender, ATurntableIsNumberedAndBeginsWithTheView) {
  request().width = 200;
  request().height = 120;
  write(test_folder() / "still.png");
  request().subject = ui::RenderedSubject::turntable;
  request().pictures = 4;
  write(test_folder() / "turn.png");
  EXPECT_EQ(render::load_png(test_folder() / "turn_000.png"), render::load_png(test_folder() / "still.png"));
  EXPECT_NE(render::load_png(test_folder() / "turn_001.png"), render::load_png(test_folder() / "turn_003.png"));
  EXPECT_FALSE(fs::exists(test_folder() / "turn_004.png"));
}

TEST_F(EditorRender, APosterIsTheMeanOfItsExposures) {
  request().width = 160;
  request().height = 90;
  write(test_folder() / "still.png");
  request().shown = true;
  draw(2);
  click("render/quality");
  click("render/quality/poster");
  ASSERT_TRUE(request().poster);
  request().shown = false;
  draw(2);
  write(test_folder() / "poster.png");
  write(test_folder() / "again.png");
  const render::Image poster = render::load_png(test_folder() / "poster.png");
  const render::Image still = render::load_png(test_folder() / "still.png");
  ASSERT_EQ(poster.rgba.size(), still.rgba.size());
  EXPECT_EQ(poster, render::load_png(test_folder() / "again.png"));
  EXPECT_NE(poster, still);
  double difference = 0;
  for (std::size_t i = 0; i < poster.rgba.size(); ++i) difference += std::abs(poster.rgba[i] - still.rgba[i]);
  EXPECT_LT(difference / static_cast<double>(poster.rgba.size()), 12) << "of the same view";
}

TEST_F(EditorRender, PicturesOfOthersAreNotReplacedUnasked) {
  request().subject = ui::RenderedSubject::turntable;
  request().pictures = 3;
  replace_file(test_folder() / "turn_001.png", "not mine");
  write(test_folder() / "turn.png");
  draw(2);
  ASSERT_TRUE(editor_.state().replacement);
  EXPECT_FALSE(fs::exists(test_folder() / "turn_000.png"));
}

TEST_F(EditorRender, RefusesWhatItCannotDraw) {
  write(test_folder() / "still.jpg");
  ASSERT_TRUE(editor_.state().error);
  EXPECT_THAT(editor_.state().error->remedy, HasSubstr(".png"));
  EXPECT_TRUE(request().shown) << "the dialog is there again once the error is closed";
  editor_.state().error.reset();
  request().width = request().height = 30000;
  write(test_folder() / "still.png");
  ASSERT_TRUE(editor_.state().error);
  EXPECT_THAT(editor_.state().error->problem, HasSubstr("30000x30000"));
}

}  // namespace
}  // namespace griffith::app
