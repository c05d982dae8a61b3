#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "editor_fixture.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;

class EditorPlots : public EditorTest {
 protected:
  void make_steps(int count) {
    for (int i = 0; i < count; ++i) editor_.run().step();
    draw();
  }

  std::string text_of(const std::filesystem::path& file) const {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
};

TEST_F(EditorPlots, PShowsThemAndAClickInThemGoesBack) {
  make_steps(20);
  EXPECT_FALSE(ui::find_tag(editor_.tags(), "plots/strip/0"));
  press_key('P');
  draw(3);
  EXPECT_THAT(value("plots/strip/0"), HasSubstr("Kinetic, Elastic ["));
  click("plots/strip/0");
  EXPECT_GT(editor_.run().frame().step, 5);
  EXPECT_LT(editor_.run().frame().step, 15);
  EXPECT_EQ(editor_.run().timeline().last_step(), 20);
  press_key('P');
  EXPECT_FALSE(ui::find_tag(editor_.tags(), "plots/strip/0"));
}

TEST_F(EditorPlots, AreSavedAsWhatTheyShow) {
  make_steps(6);
  const auto file = test_folder() / "run.csv";
  std::filesystem::remove(file);
  editor_.state().preferences.plotted = {"pieces", "", "energy.gravity"};
  editor_.execute({.name = "file.write_plots", .path = file});
  std::istringstream lines(text_of(file));
  std::string line, last;
  int rows = 0;
  std::getline(lines, line);
  EXPECT_EQ(line, "step,time [s],pieces,energy.gravity [J]");
  while (std::getline(lines, line)) last = line, ++rows;
  EXPECT_EQ(rows, 7);
  double step = 0, time = 0, pieces = 0, gravity = 0;
  ASSERT_EQ(std::sscanf(last.c_str(), "%lf,%lf,%lf,%lf", &step, &time, &pieces, &gravity), 4) << last;
  EXPECT_EQ(step, 6);
  EXPECT_EQ(time, editor_.run().frame().time);
  EXPECT_EQ(pieces, static_cast<double>(editor_.run().frame().bodies.size()));
  EXPECT_EQ(gravity, editor_.run().frame().energy.gravity);
}

TEST_F(EditorPlots, NoFileIsReplacedUnasked) {
  const auto file = test_folder() / "mine.csv";
  std::ofstream(file) << "mine";
  editor_.execute({.name = "file.write_plots", .path = file});
  ASSERT_TRUE(editor_.state().replacement);
  EXPECT_EQ(text_of(file), "mine");
  draw(3);
  click("replace/cancel");
  draw(3);
  ASSERT_TRUE(editor_.state().save_as) << "another name is asked for";
  EXPECT_EQ(editor_.state().save_as->kind, ui::SavedKind::plots);
}

TEST_F(EditorPlots, TheButtonAsksForACsvFile) {
  press_key('P');
  draw(3);
  click("plots/save");
  draw(3);
  EXPECT_THAT(value("save/path"), ::testing::EndsWith(".csv"));
}

TEST_F(EditorPlots, AFolderThatCannotBeWrittenToIsSaid) {
  editor_.execute({.name = "file.write_plots", .path = "/nowhere/run.csv"});
  ASSERT_TRUE(editor_.state().error);
  EXPECT_THAT(editor_.state().error->where, HasSubstr("/nowhere"));
}

TEST_F(EditorPlots, AnotherWorldBeginsAgain) {
  press_key('P');
  make_steps(5);
  click("command/simulation.reset");
  wait_for_work();
  make_steps(2);
  const auto file = test_folder() / "again.csv";
  std::filesystem::remove(file);
  editor_.execute({.name = "file.write_plots", .path = file});
  const std::string csv = text_of(file);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 4) << csv;
}

TEST_F(EditorPlots, APictureOfThemIsSavedFromTheWindow) {
  make_steps(6);
  const auto file = test_folder() / "plots.png";
  std::filesystem::remove(file);
  editor_.execute({.name = "file.plots", .path = file});
  draw(4);
  EXPECT_THAT(value("save/path"), ::testing::EndsWith("plots.png")) << "no .csv behind it";
  click("save/save");
  const auto request = editor_.files().take_picture_request();
  ASSERT_TRUE(request);
  EXPECT_EQ(request->kind, ui::SavedKind::plots);
  draw(2);
  editor_.files().save_window_picture(*request, window_image(), editor_.tags(), "a test");
  const ui::WidgetTag* strips = ui::find_tag(editor_.tags(), "plots/strips");
  ASSERT_TRUE(strips) << "they are shown for it";
  const render::Image image = render::load_png(file);
  EXPECT_EQ(image.width, static_cast<int>(strips->maximum.x) - static_cast<int>(strips->minimum.x));
  const std::array<std::uint8_t, 4> kinetic = {102, 187, 240, 255};
  int drawn = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) drawn += image.pixel(x, y) == kinetic;
  EXPECT_GT(drawn, 20) << "the curve is in it";
}

TEST_F(EditorPlots, TheUtilizationOfTheSelectedNodeIsPlotted) {
  select_node(editor_.state(), editor_.run().frame(), NodeId(5));
  make_steps(6);
  const auto file = test_folder() / "node.csv";
  std::filesystem::remove(file);
  editor_.state().preferences.plotted = {ui::kNodeUtilization};
  editor_.execute({.name = "file.write_plots", .path = file});
  std::istringstream lines(text_of(file));
  std::string line, last;
  while (std::getline(lines, line)) last = line;
  double step = 0, time = 0, utilization = 0;
  ASSERT_EQ(std::sscanf(last.c_str(), "%lf,%lf,%lf", &step, &time, &utilization), 3) << last;
  EXPECT_NEAR(utilization, editor_.run().frame().nodes.separations[5].utilization, 1e-6);
}

}  // namespace
}  // namespace griffith::app
