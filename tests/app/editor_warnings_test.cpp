// Cards in the view that tell where the shown result is limited.

#include "app/editor/starting_scene.h"
#include "editor_fixture.h"

namespace griffith::app {
namespace {

Scene linear_starting_scene() {
  Scene scene = starting_scene();
  scene.bodies[0].elements = ElementOrder::linear;  // quadratic ones are not scaled
  return scene;
}

class WarningsTest : public EditorTest {
 protected:
  WarningsTest() : EditorTest(linear_starting_scene()) { editor_.state().view.quality = PictureQuality::draft; }

  bool shows(const char* tag) const { return ui::find_tag(editor_.tags(), tag) != nullptr; }
};

TEST_F(WarningsTest, ABodyThatIsComputedSofterSaysSoWhileItIs) {
  int scaled_steps = 0;
  for (int i = 0; i < 40; ++i) {
    editor_.run().step();
    draw();
    const bool scaled =
        std::ranges::any_of(editor_.run().frame().bodies, [](const BodyView& body) { return body.scaled.has_value(); });
    EXPECT_EQ(shows("view/scaled"), scaled) << i;
    scaled_steps += scaled;
  }
  EXPECT_GT(scaled_steps, 0);
  EXPECT_LT(scaled_steps, 40);
}

TEST_F(WarningsTest, MissedConvergenceIsCounted) {
  for (int i = 0; i < 40; ++i) {
    editor_.run().step();
    draw();
    const StepReport& report = editor_.run().frame().report;
    const int failed = report.unconverged_solves + report.unconverged_motions + report.unconverged_contacts;
    ASSERT_EQ(shows("view/unconverged"), failed > 0) << i;
    if (failed == 0) continue;
    EXPECT_EQ(std::stoi(value("view/unconverged")), failed);
  }
}

}  // namespace
}  // namespace griffith::app
