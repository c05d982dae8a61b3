// Positions of elements in windows of different sizes, which must not overlap.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ui/widgets/bubble.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

TEST(Room, TheFirstFragmentMovesNoSlider) {
  UiDriver ui(two_walls());
  const auto place = [&ui](const char* tag) { return ui.find(tag).y; };
  const float before = place("material/young_modulus");
  std::vector<BodyView> pieces(300);
  for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].id = BodyId(static_cast<int>(i)), pieces[i].tets = 1;
  ui.input.frame.bodies = std::span(pieces).first(20);
  for (int i = 0; i < 3; ++i) ui.frame();
  EXPECT_EQ(place("material/young_modulus"), before);
  ui.click("bodies/pieces");
  const float of_pieces = place("material/young_modulus");
  ui.input.frame.bodies = pieces;
  ui.click("bodies/filter");
  ui.type("asleep");
  EXPECT_EQ(place("material/young_modulus"), of_pieces);
}

/// Opens all that can be opened in the side panels, in a window of that size.
void open_everything(UiDriver& ui, ImVec2 size) {
  ImGui::GetIO().DisplaySize = {size.x, 6000};
  ui.history.change("many fields", [](Scene& scene) {
    scene.bodies[0].weakness = Weakness{};
    scene.bodies[0].strength_scatter = StrengthScatter{};
  });
  ui.history.finish();
  for (int i = 0; i < 3; ++i) ui.frame();
  for (const char* tag : {"body", "body/shape", "body/weakness/parts", "body/strength_scatter/parts", "scene",
                          "scene/simulation", "view/element_rows"})
    if (find_tag(ui.tags, tag)) ui.click(tag);
}

/// Returns the number of labels, after a check that none is cut or covered.
int expect_whole_labels(const UiDriver& ui, float width) {
  int labels = 0;
  for (std::size_t i = 0; i + 1 < ui.tags.size(); ++i) {
    const WidgetTag &label = ui.tags[i], &field = ui.tags[i + 1];
    if (!label.name.starts_with("label/")) continue;
    ++labels;
    EXPECT_EQ(label.value.find("…"), std::string::npos) << label.value;
    const bool before = label.maximum.x <= field.minimum.x, above = label.maximum.y <= field.minimum.y;
    EXPECT_TRUE(before || above) << label.value << " is covered at " << width;
    const bool left = label.minimum.x < width / 2;
    EXPECT_LE(label.maximum.x, left ? ui.state.left_width : width) << label.value << " is cut at " << width;
  }
  return labels;
}

TEST(Room, LabelsStandWholeBesideTheirFieldsInEveryWindow) {
  for (const ImVec2 size : {ImVec2(1024, 600), ImVec2(1280, 720), ImVec2(2560, 1440)}) {
    Scene scene = two_walls();
    scene.bodies[0].supports.resize(1);
    scene.bodies[0].loads.resize(1);
    scene.projectiles.resize(1);
    scene.probes = {probe_of("left", "tip")};
    scene.cameras.resize(1);
    UiDriver ui(scene);
    open_everything(ui, size);
    EXPECT_GT(expect_whole_labels(ui, size.x), 50);
    for (const char* tag : {"bodies/0/supports/0", "bodies/0/loads/0", "projectiles/0", "probes/0", "cameras/0"}) {
      ui.click(tag);
      for (const char* part : {"entry/region", "entry/at"})
        if (find_tag(ui.tags, part)) ui.click(part);
      EXPECT_GT(expect_whole_labels(ui, size.x), 30) << tag;
    }
  }
}

TEST(Room, NumbersOfARowHaveRoomForWhatTheyShow) {
  for (const ImVec2 size : {ImVec2(1024, 600), ImVec2(1280, 720), ImVec2(2560, 1440)}) {
    UiDriver ui(two_walls());
    ui.history.change("move", [](Scene& scene) { scene.bodies[0].position = Vec3(-1234.56789, 1e-7, 98765.4321); });
    open_everything(ui, size);
    ImGui::NewFrame();
    int numbers = 0;
    for (const WidgetTag& tag : ui.tags) {
      if (!tag.name.ends_with("/0") && !tag.name.ends_with("/1") && !tag.name.ends_with("/2")) continue;
      if (tag.value == "open" || tag.value == "closed" || tag.name.starts_with("bodies/")) continue;
      ++numbers;
      EXPECT_LE(ImGui::CalcTextSize(tag.value.c_str()).x, tag.maximum.x - tag.minimum.x) << tag.name << tag.value;
    }
    EXPECT_GT(numbers, 20);
    ImGui::EndFrame();
  }
}

bool overlap(const Box& a, const Box& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

TEST(Bubbles, StandBesideTheirPanelOnTheScreen) {
  for (const ImVec2 screen : {ImVec2(1024, 600), ImVec2(1280, 720), ImVec2(2560, 1440)}) {
    const Box left = {{0, 70}, {300, screen.y - 26}}, right = {{screen.x - 300, 70}, {screen.x, screen.y - 26}};
    for (const Box& panel : {left, right}) {
      for (float y = panel.low.y; y < panel.high.y - 20; y += 7) {
        const BubblePlace place({{panel.low.x + 120, y}, {panel.high.x - 20, y + 24}}, panel, screen, 16);
        const Box box = place.box({place.text_width(), 90});
        EXPECT_FALSE(overlap(box, panel));
        EXPECT_GE(box.low.x, 0);
        EXPECT_LE(box.high.x, screen.x);
        EXPECT_GE(box.low.y, 0);
        EXPECT_LE(box.high.y, screen.y);
      }
    }
  }
}

TEST(Bubbles, OfWideWindowsStandBelowOrAboveTheirItem) {
  const ImVec2 screen = {1280, 720};
  for (const float y : {20.0f, 690.0f}) {
    const Box item = {{400, y}, {560, y + 24}};
    const BubblePlace place(item, {{0, y - 10}, {1280, y + 30}}, screen, 16);
    const Box box = place.box({300, 40});
    EXPECT_FALSE(overlap(box, item));
    EXPECT_LE(box.high.y, screen.y);
    EXPECT_GE(box.low.y, 0);
  }
}

}  // namespace
}  // namespace griffith::ui
