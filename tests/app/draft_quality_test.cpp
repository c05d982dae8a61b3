#include "app/editor/draft_quality.h"

#include "editor_fixture.h"

namespace griffith::app {
namespace {

TEST(DraftQuality, IsForSlowPicturesInMotionAlone) {
  DraftQuality draft;
  draft.drew_full(1);
  draft.follow(true);
  EXPECT_FALSE(draft.on()) << "not allowed";
  draft.allow(0.03);
  EXPECT_TRUE(draft.on());
  int frames = 0;
  for (; draft.on() && frames < 100; ++frames) draft.follow(false);
  EXPECT_GT(frames, 1) << "a hand that rests for one frame still moves";
  EXPECT_LT(frames, 100);
  draft.follow(true);
  draft.drew_full(0.005);
  EXPECT_FALSE(draft.on()) << "a fast picture needs no draft";
}

TEST_F(EditorTest, ADraftIsFollowedByTheFullPictureWithoutAnyEvent) {
  editor_.viewport().allow_drafts(0);  // any picture is too slow
  const ui::WidgetTag* view = ui::find_tag(editor_.tags(), "viewport");
  ASSERT_TRUE(view);
  const auto turn = [&] {
    ui::drag(queue_, view->center(), {80, 10});
    play();
  };
  turn();  // measures the first full picture
  draw(20);
  turn();
  ASSERT_TRUE(editor_.viewport().draws_draft());
  for (int i = 0; i < 100 && editor_.viewport().draws_draft(); ++i) {
    EXPECT_EQ(editor_.seconds_to_next_frame(), 0) << "it goes on drawing";
    draw();
  }
  EXPECT_FALSE(editor_.viewport().draws_draft());
  EXPECT_TRUE(editor_.viewport().draw(editor_.run().shown(), 1)) << "the full picture is still to be drawn";
  EXPECT_FALSE(editor_.viewport().draw(editor_.run().shown(), 1)) << "and then nothing more";
}

}  // namespace
}  // namespace griffith::app
