// The list of all that a scene holds: choosing, naming, hiding, and what is done with the chosen ones.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"
#include "tests/random_values.h"
#include "ui/model/entry_choice.h"
#include "ui/panels/outliner_rows.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two bodies with supports and loads, shots, probes and cameras.
Scene full_scene() {
  Scene scene = two_walls();
  scene.bodies[0].supports.resize(2);
  scene.bodies[1].loads.resize(1);
  scene.projectiles.resize(2);
  scene.probes = {probe_of("left", "tip"), probe_of("right", "foot")};
  scene.cameras = {Camera{.name = "front"}, Camera{.name = "side"}};
  return scene;
}

std::vector<SceneEntry> chosen(const UiDriver& ui) { return selected_entries(ui.state, ui.history.scene()); }

/// Clicks while a key is held down.
void click_with(UiDriver& ui, int modifier, const std::string& tag) {
  ui.queue.key(modifier, true);
  ui.click(tag);
  ui.queue.key(modifier, false);
}

/// Waits until the box for the entry's name has the focus.
void begin_renaming(UiDriver& ui, const SceneEntry& entry) {
  ui.state.renamed = entry;
  ui.state.new_name = entry_name(ui.history.scene(), entry);
  for (int i = 0; i < 4; ++i) ui.frame();
}

TEST(Outliner, ListsAllThatASceneHolds) {
  UiDriver ui(full_scene());
  for (const char* tag : {"bodies/0", "bodies/0/supports/0", "bodies/0/supports/1", "bodies/1", "bodies/1/loads/0",
                          "projectiles/0", "projectiles/1", "probes/0", "probes/1", "cameras/0"})
    EXPECT_NE(find_tag(ui.tags, tag), nullptr) << tag;
  EXPECT_EQ(ui.value("bodies/0/supports/1"), "Support 2");
  EXPECT_EQ(ui.value("probes/1"), "foot");
  EXPECT_EQ(scene_entries(full_scene()).size(), 11u);
}

TEST(Outliner, AClickShowsTheFieldsOfTheEntryAndAnEditIsOfIt) {
  UiDriver ui(full_scene());
  ui.click("bodies/1/loads/0");
  EXPECT_EQ(ui.state.selected_body, 1);
  EXPECT_EQ(find_tag(ui.tags, "material/density"), nullptr);
  ui.click("entry/force/1", 1);
  ui.type("-5 kN");
  EXPECT_EQ(ui.history.scene().bodies[1].loads[0].force, Vec3(0, -5000, 0));
  ASSERT_EQ(ui.history.entries().size(), 1u);
  EXPECT_EQ(ui.history.entries()[0].label, "Set Force of Load 1 of right");
  ui.history.undo();
  EXPECT_EQ(ui.history.scene(), full_scene());
  ui.click("bodies/0");
  EXPECT_NE(find_tag(ui.tags, "material/density"), nullptr);
}

TEST(Outliner, CtrlAndShiftChooseSeveral) {
  UiDriver ui(full_scene());
  const SceneEntry left{EntryKind::body, 0}, tip{EntryKind::probe, 0}, foot{EntryKind::probe, 1};
  ui.click("bodies/0");
  click_with(ui, key::kLeftControl, "probes/1");
  EXPECT_THAT(chosen(ui), ElementsAre(left, foot));
  click_with(ui, key::kLeftControl, "probes/1");
  EXPECT_THAT(chosen(ui), ElementsAre(left));
  ui.click("probes/1");
  click_with(ui, key::kLeftShift, "projectiles/1");
  EXPECT_THAT(chosen(ui), ElementsAre(SceneEntry{EntryKind::projectile, 1}, tip, foot));
  click_with(ui, key::kLeftShift, "probes/0");
  EXPECT_THAT(chosen(ui), ElementsAre(tip, foot)) << "a range is counted from where the first one began";
}

TEST(Outliner, ArrowKeysGoAlongTheListThatWasClicked) {
  UiDriver ui(full_scene());
  const SceneEntry side{EntryKind::camera, 1}, front{EntryKind::camera, 0}, foot{EntryKind::probe, 1};
  ui.press_key(key::kDown);
  EXPECT_THAT(chosen(ui), ElementsAre(SceneEntry{EntryKind::body, 0})) << "the list has no focus yet";
  ui.click("probes/1");
  ui.press_key(key::kDown);
  EXPECT_THAT(chosen(ui), ElementsAre(front));
  for (int i = 0; i < 3; ++i) ui.press_key(key::kDown);
  EXPECT_THAT(chosen(ui), ElementsAre(side)) << "the last one stays";
  ui.press_key(key::kUp, false, true);
  ui.press_key(key::kUp, false, true);
  EXPECT_THAT(chosen(ui), ElementsAre(foot, front, side));
  ui.press_key(key::kDown, false, true);
  EXPECT_THAT(chosen(ui), ElementsAre(front, side)) << "a range shrinks as it grew";
  EXPECT_TRUE(ui.history.entries().empty());
}

TEST(Outliner, ANameIsTypedInPlaceAndUndone) {
  UiDriver ui(full_scene());
  ui.state.hidden_bodies = {"left"};
  begin_renaming(ui, {EntryKind::body, 0});
  ui.type("pillar");
  EXPECT_EQ(ui.history.scene().bodies[0].name, "pillar");
  EXPECT_EQ(ui.history.scene().probes[0].body, "pillar") << "probes follow";
  EXPECT_TRUE(ui.state.hidden_bodies.contains("pillar")) << "what is hidden stays so";
  EXPECT_FALSE(ui.state.renamed);
  ui.history.undo();
  EXPECT_EQ(ui.history.scene(), full_scene());
}

TEST(Outliner, ATakenNameIsRefusedAndEscapeLeavesTheOldOne) {
  UiDriver ui(full_scene());
  begin_renaming(ui, {EntryKind::camera, 0});
  ui.type("side");
  EXPECT_EQ(ui.history.scene(), full_scene());
  EXPECT_THAT(ui.value("field_note"), HasSubstr("There is already one with the name \"side\""));
  begin_renaming(ui, {EntryKind::camera, 0});
  for (const char letter : {'u', 'p'}) ui.queue.text(static_cast<unsigned>(letter));
  ui.press_key(key::kEscape);
  EXPECT_FALSE(ui.state.renamed);
  EXPECT_EQ(ui.history.scene(), full_scene());
  EXPECT_TRUE(ui.history.entries().empty());
}

TEST(Outliner, ADoubleClickAndF2AskForAName) {
  UiDriver ui(full_scene());
  ui.click("probes/0");
  ui.press_key(key::kF1 + 1);
  ui.click("cameras/0");
  ui.click("cameras/0");
  EXPECT_THAT(ui.issued(), ElementsAre("edit.rename", "edit.rename"));
  ui.click("projectiles/0");
  ui.press_key(key::kF1 + 1);
  EXPECT_FALSE(app::command_info("edit.rename").disabled_reason(ui.context()).empty()) << "a projectile has no name";
}

TEST(Outliner, TheContextMenuIsOfTheRowUnderTheCursor) {
  UiDriver ui(full_scene());
  ui.click("probes/1", 1);
  ui.frame();
  EXPECT_THAT(chosen(ui), ElementsAre(SceneEntry{EntryKind::probe, 1}));
  EXPECT_EQ(find_tag(ui.tags, "context/view.hide"), nullptr) << "a probe is no body";
  ui.click("context/edit.delete");
  EXPECT_THAT(ui.issued(), ElementsAre("edit.delete"));
}

TEST(Outliner, TheEyeAsksToHideItsBody) {
  UiDriver ui(full_scene());
  ui.click("bodies/1/eye");
  EXPECT_THAT(ui.issued(), ElementsAre("view.hide"));
  EXPECT_THAT(chosen(ui), ElementsAre(SceneEntry{EntryKind::body, 1}));
  ui.state.hidden_bodies = {"right"};
  ui.frame();
  EXPECT_EQ(ui.value("bodies/1/eye"), "hidden");
  EXPECT_EQ(ui.value("bodies/0/eye"), "shown");
}

TEST(Outliner, TheIconOfACameraAsksToLookThroughIt) {
  UiDriver ui(full_scene());
  EXPECT_FALSE(find_tag(ui.tags, "bodies/0/look"));
  ui.click("cameras/0/look");
  EXPECT_THAT(ui.issued(), ElementsAre("view.look_through"));
  EXPECT_THAT(chosen(ui), ElementsAre(SceneEntry{EntryKind::camera, 0}));
}

TEST(Outliner, TwoClicksOnTwoRowsInOnePlaceAreNoDoubleClick) {
  UiDriver ui(full_scene());
  ui.click("cameras/0");
  ui.history.change("Delete", [](Scene& scene) { remove_entries(scene, {{EntryKind::camera, 0}}); });
  ui.state.entries = {{EntryKind::camera, 7}};
  ui.click("cameras/0");
  EXPECT_TRUE(ui.commands.empty()) << "no name is asked for";
}

TEST(Outliner, ScrollsToWhatIsChosenElsewhere) {
  Scene scene = two_walls();
  for (int i = 0; i < 40; ++i) scene.cameras.push_back(Camera{.name = "camera " + std::to_string(i)});
  UiDriver ui(scene);
  EXPECT_EQ(find_tag(ui.tags, "cameras/35"), nullptr) << "far below";
  select_entries(ui.state, scene, {{EntryKind::camera, 35}});
  ui.frame();
  ui.frame();
  EXPECT_NE(find_tag(ui.tags, "cameras/35"), nullptr);
  ui.click("cameras/36");
  const ImVec2 place = ui.find("cameras/36");
  ui.frame();
  EXPECT_EQ(ui.find("cameras/36").y, place.y) << "a click in the list scrolls nothing";
}

/// Where the column behind the names begins.
float end_of_names(const std::string& name) {
  Scene scene = two_walls();
  scene.bodies[0].name = name;
  BodyView piece;
  piece.tets = 1;
  UiDriver ui(scene);
  ui.input.frame.bodies = std::span(&piece, 1);
  for (int i = 0; i < 3; ++i) ui.frame();
  return ui.find("bodies/0/state").x;
}

TEST(Outliner, LongNamesTakeTheRoomOfNumbers) {
  EXPECT_GT(end_of_names("the northern wall"), end_of_names("wall") + 20);
}

TEST(Outliner, ATapThatArrivesInOneFrameIsAClick) {
  UiDriver ui(full_scene());
  const ImVec2 place = ui.find("probes/1");
  ui.queue.move(place);
  ui.queue.button(0, true);
  ui.queue.button(0, false);
  while (!ui.queue.empty()) {
    ui.queue.play(ImGui::GetIO());
    ui.frame();
  }
  EXPECT_THAT(chosen(ui), ElementsAre(SceneEntry{EntryKind::probe, 1}));
}

TEST(Outliner, TheFilterFindsNotesTooAndShowsWhatTheyAreOf) {
  UiDriver ui(full_scene());
  ui.click("bodies/filter");
  ui.type("FIXED");
  EXPECT_NE(find_tag(ui.tags, "bodies/0/supports/0"), nullptr);
  EXPECT_NE(find_tag(ui.tags, "bodies/0"), nullptr);
  EXPECT_EQ(find_tag(ui.tags, "bodies/1"), nullptr);
  EXPECT_EQ(find_tag(ui.tags, "cameras/0"), nullptr);
}

TEST(Outliner, TheFilterTakesAllOfABodyAndNoNumberForAName) {
  const Scene scene = full_scene();
  const std::vector<BodyRow> bodies = body_rows(scene, {});
  EXPECT_EQ(outliner_rows(scene, bodies, "LEF").size(), 4u) << "the body, its supports and its probe";
  EXPECT_EQ(outliner_rows(scene, bodies, "1").size(), 0u) << "Support 1 is no name";
  EXPECT_EQ(outliner_rows(scene, bodies, "").size(), scene_entries(scene).size());
}

TEST(SceneEntries, RemovingAnyOfThemLeavesTheOthersAndAValidScene) {
  testing::RandomValues random(5);
  for (int round = 0; round < 200; ++round) {
    Scene scene = full_scene();
    std::vector<SceneEntry> entries = scene_entries(scene), removed;
    for (const SceneEntry& entry : entries)
      if (random.index(3) == 0) removed.push_back(entry);
    std::vector<std::string> kept;
    for (const SceneEntry& entry : entries) {
      const std::optional<int> body = body_of(scene, entry);
      const bool goes = std::ranges::count(removed, entry) > 0 ||
                        (body && std::ranges::count(removed, SceneEntry{EntryKind::body, *body}) > 0);
      if (!goes && has_name(entry.kind)) kept.push_back(entry_name(scene, entry));
    }
    remove_entries(scene, removed);
    std::vector<std::string> left;
    for (const SceneEntry& entry : scene_entries(scene))
      if (has_name(entry.kind)) left.push_back(entry_name(scene, entry));
    EXPECT_EQ(left, kept);
    EXPECT_TRUE(check_scene_text(scene_to_json(scene), "scene").empty());
  }
}

TEST(SceneEntries, ACopyIsEqualButForItsName) {
  for (const SceneEntry& entry : scene_entries(full_scene())) {
    Scene scene = full_scene();
    const SceneEntry copy = append_copy(scene, entry);
    EXPECT_EQ(scene_entries(scene).size(), scene_entries(full_scene()).size() + 1 + 2 * (entry == SceneEntry{}) +
                                               (entry == SceneEntry{EntryKind::body, 1}))
        << "a body's supports and loads come along";
    EXPECT_TRUE(check_scene_text(scene_to_json(scene), "scene").empty()) << full_name(scene, entry);
    EXPECT_NE(copy, entry);
    EXPECT_TRUE(!has_name(entry.kind) || entry_name(scene, copy) != entry_name(scene, entry));
    remove_entries(scene, {copy});
    EXPECT_EQ(scene, full_scene());
  }
}

TEST(Names, AFreeNameCountsOn) {
  std::vector<BodyDescription> bodies(3);
  bodies[0].name = "leg";
  bodies[1].name = "leg 2";
  bodies[2].name = "mark 07";
  EXPECT_EQ(free_name(bodies, "arm"), "arm");
  EXPECT_EQ(free_name(bodies, "arm 5"), "arm 5");
  EXPECT_EQ(free_name(bodies, "leg"), "leg 3");
  EXPECT_EQ(free_name(bodies, "leg 2"), "leg 3");
  EXPECT_EQ(free_name(bodies, "mark 07"), "mark 07 2") << "no number of its own";
  bodies[2].name = "9";
  EXPECT_EQ(free_name(bodies, "9"), "9 2");
}

TEST(Outliner, EntriesMoveUpAndDownWithWhatBelongsToThem) {
  Scene scene = full_scene();
  std::vector<SceneEntry> moved = move_entries(scene, {{EntryKind::body, 1}, {EntryKind::load, 0, 1}}, -1);
  EXPECT_EQ(scene.bodies[0].name, "right");
  EXPECT_EQ(scene.bodies[0].loads.size(), 1u);
  EXPECT_THAT(moved, ElementsAre(SceneEntry{EntryKind::body, 0}, SceneEntry{EntryKind::load, 0, 0}));
  moved = move_entries(scene, {{EntryKind::camera, 0}}, 1);
  EXPECT_EQ(scene.cameras[1].name, "front");
  EXPECT_THAT(moved, ElementsAre(SceneEntry{EntryKind::camera, 1}));
}

TEST(Outliner, WhatStandsAtTheEndStaysAndHoldsWhatFollowsIt) {
  Scene scene;
  for (const char* name : {"a", "b", "c", "d"}) scene.cameras.push_back(Camera{.name = name});
  const auto names = [&scene] {
    std::string all;
    for (const Camera& camera : scene.cameras) all += camera.name;
    return all;
  };
  const auto cameras = [](std::initializer_list<int> indices) {
    std::vector<SceneEntry> entries;
    for (const int index : indices) entries.push_back({EntryKind::camera, index});
    return entries;
  };
  EXPECT_EQ(move_entries(scene, cameras({3, 1}), -1), cameras({2, 0}));
  EXPECT_EQ(names(), "badc");
  EXPECT_EQ(move_entries(scene, cameras({0, 1, 3}), -1), cameras({0, 1, 2}));
  EXPECT_EQ(names(), "bacd");
  EXPECT_EQ(move_entries(scene, cameras({1, 2}), 1), cameras({2, 3}));
  EXPECT_EQ(names(), "bdac");
  EXPECT_FALSE(can_move(scene, cameras({0, 1}), -1));
  EXPECT_TRUE(can_move(scene, cameras({0, 1}), 1));
  EXPECT_FALSE(can_move(scene, cameras({0, 1, 2, 3}), 1));
}

TEST(Outliner, KeysMoveWhatIsChosen) {
  UiDriver ui(full_scene());
  ui.click("cameras/1");
  ui.press_key(key::kUp, true);
  EXPECT_THAT(ui.issued(), ElementsAre("edit.move_up"));
  ui.press_key(key::kDown, true);
  EXPECT_FALSE(app::command_info("edit.move_down").disabled_reason(ui.context()).empty()) << "it is the last";
  EXPECT_EQ(chosen(ui), (std::vector<SceneEntry>{{EntryKind::camera, 1}})) << "Ctrl does not choose";
}

}  // namespace
}  // namespace griffith::ui
