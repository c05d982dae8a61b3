// The panels that edit what a scene file says, and the list of bodies.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "sim/scene/scene_fields.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"
#include "tests/random_values.h"
#include "ui/panels/body_rows.h"
#include "ui/widgets/field_range.h"
#include "ui_driver.h"

namespace griffith::ui {
namespace {

/// Tall enough that no row of an open part is out of sight.
void open(UiDriver& ui, const std::vector<std::string>& tags) {
  ImGui::GetIO().DisplaySize = {1500, 4000};
  for (int i = 0; i < 3; ++i) ui.frame();
  for (const std::string& tag : tags) ui.click(tag);
}

/// The archive that lists the fields of a value.
struct FieldNames {
  std::vector<std::string> names;
  template <class T, class Values>
  void field(std::string_view name, T&, const Values&, std::string_view) {
    names.emplace_back(name);
  }
  void require(bool, std::string_view, const char*, const char*) {}
};

template <class T>
std::vector<std::string> fields_of(T value) {
  FieldNames fields;
  describe(fields, value);
  return fields.names;
}

void expect_valid(const UiDriver& ui) {
  for (const InputError& problem : check_scene_text(scene_to_json(ui.history.scene()), "scene"))
    ADD_FAILURE() << problem.what();
}

TEST(ScenePanels, LabelsDoNotRepeatTheUnitOfTheNumber) {
  Scene scene = two_walls();
  scene.cameras = {{}};
  UiDriver ui(scene);
  ui.state.entries = {{EntryKind::camera, 0}};
  open(ui, {});
  EXPECT_NE(find_tag(ui.tags, "label/Field of view"), nullptr);
  EXPECT_EQ(find_tag(ui.tags, "label/Field of view degrees"), nullptr);
}

TEST(ScenePanels, EveryFieldOfBodyAndSceneHasARow) {
  UiDriver ui(two_walls());
  open(ui, {"body", "scene"});
  const std::set<std::string> listed = {"material",    "supports", "loads",   "bodies",
                                        "projectiles", "probes",   "cameras", "view"};  // elsewhere
  for (const std::string& name : fields_of(BodyDescription{})) {
    const bool shown = find_tag(ui.tags, "body/" + name) || find_tag(ui.tags, "body/" + name + "/0");
    EXPECT_EQ(shown, !listed.contains(name)) << name;
  }
  for (const std::string& name : fields_of(Scene{})) {
    const bool shown = find_tag(ui.tags, "scene/" + name) || find_tag(ui.tags, "scene/" + name + "/0");
    EXPECT_EQ(shown, !listed.contains(name)) << name;
  }
  EXPECT_EQ(ui.history.scene(), two_walls()) << "looking changes nothing";
}

TEST(ScenePanels, ATypedNumberIsOneEdit) {
  UiDriver ui(two_walls());
  open(ui, {"body"});
  ui.click("body/position/1", 1);
  ui.type("250 ells");  // no unit of ours
  EXPECT_EQ(ui.history.scene(), two_walls());
  ui.click("body/position/1", 1);
  ui.type("2.5 m");
  EXPECT_EQ(ui.history.scene().bodies[0].position, Vec3(two_walls().bodies[0].position.x(), 2.5, 0));
  ASSERT_EQ(ui.history.entries().size(), 1u);
  EXPECT_EQ(ui.history.entries()[0].label, "Set Position of " + two_walls().bodies[0].name);
  ui.history.undo();
  EXPECT_EQ(ui.history.scene(), two_walls());
}

TEST(ScenePanels, ABareNumberIsInTheUnitThatItsRowShows) {
  Scene scene = two_walls();
  std::get<BoxShape>(scene.bodies[0].shape).size = Vec3(1.2, 0.25, 0.4);
  scene.bodies[0].position = Vec3(0.01, 0, 0);
  UiDriver ui(scene);
  open(ui, {"body", "body/shape"});
  ui.click("body/shape/box/size/1");
  ui.type("0.1");
  EXPECT_EQ(std::get<BoxShape>(ui.history.scene().bodies[0].shape).size, Vec3(1.2, 0.1, 0.4));
  EXPECT_NE(find_tag(ui.tags, "label/Position [mm]"), nullptr);
  EXPECT_EQ(ui.value("body/position/0"), "10");
  ui.click("body/position/1");
  ui.type("604");
  EXPECT_EQ(ui.history.scene().bodies[0].position, Vec3(0.01, 0.604, 0));
}

TEST(ScenePanels, ARowOfNumbersHasOnePrefix) {
  Scene scene = two_walls();
  BoxShape& box = std::get<BoxShape>(scene.bodies[0].shape);
  box.size = Vec3(1.2, 0.25, 0.4);
  box.element_size = Vec3(0.1, 0.0625, 0.02);
  UiDriver ui(scene);
  open(ui, {"body", "body/shape"});
  EXPECT_NE(find_tag(ui.tags, "label/Size [m]"), nullptr);
  EXPECT_EQ(ui.value("body/shape/box/size/0"), "1.2");
  EXPECT_EQ(ui.value("body/shape/box/size/1"), "0.25");
  EXPECT_NE(find_tag(ui.tags, "label/Element size [mm]"), nullptr);
  EXPECT_EQ(ui.value("body/shape/box/element_size/0"), "100");
  EXPECT_EQ(ui.value("body/shape/box/element_size/1"), "62.5");
}

TEST(ScenePanels, WhatANumberTakesInAFileItTakesInItsPanel) {
  UiDriver ui(two_walls());
  open(ui, {"body"});
  const Numbers place = range_of<BodyDescription>("position");
  ui.click("body/position/0", 1);
  ui.type("1e6 m");
  EXPECT_EQ(ui.history.scene().bodies[0].position.x(), place.maximum);
  EXPECT_EQ(find_tag(ui.tags, "field_note"), nullptr);
  ui.click("body/position/0", 1);
  ui.type("-2e6 m");
  EXPECT_EQ(ui.history.scene().bodies[0].position.x(), place.minimum);
  EXPECT_THAT(ui.value("field_note"), ::testing::HasSubstr("below the minimum -1 Mm and was set to it"));
}

TEST(ScenePanels, WhatIsNotTakenIsReportedAtItsField) {
  UiDriver ui(two_walls());
  open(ui, {"body", "body/weakness"});
  const Scene before = ui.history.scene();
  ui.click("body/name");
  ui.press_key('A', true);
  ui.press_key(259);  // Backspace
  EXPECT_THAT(ui.value("field_note"), ::testing::HasSubstr("cannot be empty"));
  EXPECT_EQ(ui.state.field_note.tag, "body/name");
  ui.click("scene");
  EXPECT_EQ(find_tag(ui.tags, "field_note"), nullptr) << "it is of an old edit";
  EXPECT_EQ(ui.history.scene(), before);
}

TEST(ScenePanels, ShapesAndRegionsChangeTheirKind) {
  UiDriver ui(two_walls());
  open(ui, {"body", "body/shape", "body/shape/kind_of", "body/shape/kind_of/sphere"});
  EXPECT_TRUE(std::holds_alternative<SphereShape>(ui.history.scene().bodies[0].shape));
  ui.history.change("hold", [](Scene& scene) { scene.bodies[0].supports.resize(1); });
  ui.frame();
  ui.click("bodies/0/supports/0");
  ui.click("entry/region");
  ui.click("entry/region/kind_of");
  ui.click("entry/region/kind_of/half space");
  EXPECT_TRUE(std::holds_alternative<HalfSpaceRegion>(ui.history.scene().bodies[0].supports[0].region));
  expect_valid(ui);
}

TEST(ScenePanels, WhatBelongsToAnotherKindOfLoadGoesWithIt) {
  Scene scene = two_walls();
  scene.bodies[0].loads.resize(1);
  UiDriver ui(scene);
  open(ui, {"bodies/0/loads/0"});
  ui.click("entry/force/1", 1);
  ui.type("-5 kN");
  EXPECT_EQ(ui.history.scene().bodies[0].loads[0].force, Vec3(0, -5000, 0));
  EXPECT_EQ(find_tag(ui.tags, "entry/pressure"), nullptr);
  ui.click("entry/kind");
  ui.click("entry/kind/pressure");
  EXPECT_EQ(ui.history.scene().bodies[0].loads[0].kind, LoadKind::pressure);
  EXPECT_NE(find_tag(ui.tags, "entry/pressure"), nullptr);
  EXPECT_TRUE(ui.state.field_note.text.empty()) << ui.state.field_note.text;
  expect_valid(ui);
}

TEST(ScenePanels, WhatBreaksARuleIsNotTakenAndTheRuleIsShown) {
  UiDriver ui(two_walls());
  open(ui, {"body", "body/splinters"});
  EXPECT_TRUE(ui.history.scene().bodies[0].splinters);
  const Scene before = ui.history.scene();
  ui.click("body/remeshing");
  EXPECT_EQ(ui.history.scene(), before);
  EXPECT_THAT(ui.value("field_note"), ::testing::HasSubstr("Remeshing is set together with splinters"));
  ui.click("body/splinters");
  ui.click("body/remeshing");
  EXPECT_TRUE(ui.history.scene().bodies[0].remeshing);
  EXPECT_EQ(find_tag(ui.tags, "field_note"), nullptr) << "it is of an old edit";
}

TEST(ScenePanels, ProbesFollowTheNameOfTheirBody) {
  Scene scene = two_walls();
  scene.probes = {probe_of("left", "tip"), probe_of("right", "foot")};
  UiDriver ui(scene);
  open(ui, {"body"});
  ui.click("body/name");
  ui.type("X");
  EXPECT_NE(ui.history.scene().bodies[0].name, two_walls().bodies[0].name);
  EXPECT_EQ(ui.history.scene().probes[0].body, ui.history.scene().bodies[0].name);
  EXPECT_EQ(ui.history.scene().probes[1].body, "right");
  expect_valid(ui);
}

TEST(ScenePanels, ATypedNameIsOneEdit) {
  UiDriver ui(two_walls());
  open(ui, {"body"});
  ui.click("body/name");
  ui.type("abc");
  EXPECT_NE(ui.history.scene().bodies[0].name, "left");
  ASSERT_EQ(ui.history.entries().size(), 1u);
  EXPECT_EQ(ui.history.entries()[0].label, "Set Name of left");
  ui.history.undo();
  EXPECT_EQ(ui.history.scene(), two_walls());
}

TEST(ScenePanels, TwoBodiesCannotHaveOneName) {
  Scene scene = two_walls();
  scene.bodies[0].name = "wall";
  scene.bodies[1].name = "wallX";
  UiDriver ui(scene);
  open(ui, {"body"});
  ui.click("body/name");
  ui.type("wallX");
  EXPECT_NE(ui.history.scene().bodies[0].name, "wallX");
  expect_valid(ui);
}

TEST(ScenePanels, RandomClicksKeepTheSceneValid) {
  testing::RandomValues random(7);
  Scene scene = two_walls();
  scene.bodies[0].supports.resize(2);
  scene.bodies[1].loads.resize(1);
  scene.projectiles.resize(1);
  scene.probes = {probe_of("left", "tip")};
  scene.cameras.resize(2);
  scene.cameras[1].name = "other";
  UiDriver ui(scene);
  open(ui, {"body", "scene", "body/shape", "scene/simulation", "scene/ground"});
  for (int i = 0; i < 1500; ++i) {
    const WidgetTag tag = ui.tags[static_cast<std::size_t>(random.index(static_cast<int>(ui.tags.size())))];
    const std::string part = tag.name.substr(0, tag.name.find('/'));
    const std::set<std::string> parts = {"body", "bodies", "scene", "entry", "projectiles", "probes", "cameras"};
    if (!parts.contains(part)) continue;
    if (random.index(3) == 0) {
      ui.drag(tag.name, static_cast<float>(random.index(400) - 200));
    } else {
      ui.click(tag.name);
    }
    if (i % 20 == 0) expect_valid(ui);
  }
  ui.history.finish();
  EXPECT_GT(ui.history.entries().size(), 20u);
  expect_valid(ui);
}

/// Pieces of two bodies in random states.
std::vector<BodyView> random_pieces(int count) {
  testing::RandomValues random(3);
  std::vector<BodyView> pieces(count);
  for (int i = 0; i < count; ++i) {
    pieces[i].id = BodyId(i);
    pieces[i].scene_body = random.index(2);
    pieces[i].tets = random.index(5);
    pieces[i].mass = pieces[i].tets * 0.5;
    pieces[i].rigid = random.index(2) == 0;
    pieces[i].asleep = pieces[i].rigid && random.index(2) == 0;
  }
  return pieces;
}

TEST(BodyRows, AddUpToWhatThereIs) {
  const std::vector<BodyView> pieces = random_pieces(200);
  Frame frame;
  frame.bodies = pieces;
  for (const auto& rows : {body_rows(two_walls(), frame), piece_rows(two_walls(), frame)}) {
    int tets = 0, count = 0, asleep = 0;
    double mass = 0;
    for (const BodyRow& row : rows) tets += row.tets, count += row.pieces(), asleep += row.asleep, mass += row.mass;
    int all_tets = 0, all = 0, all_asleep = 0;
    for (const BodyView& piece : pieces)
      all_tets += piece.tets, all += piece.tets > 0, all_asleep += piece.tets > 0 && piece.asleep;
    EXPECT_EQ(tets, all_tets);
    EXPECT_EQ(count, all);
    EXPECT_EQ(asleep, all_asleep);
    EXPECT_DOUBLE_EQ(mass, 0.5 * all_tets);
  }
}

TEST(BodyRows, SortByEachColumnEitherWay) {
  const std::vector<BodyView> pieces = random_pieces(200);
  Frame frame;
  frame.bodies = pieces;
  std::vector<BodyRow> rows = piece_rows(two_walls(), frame);
  const std::size_t count = rows.size();
  sort_rows(rows, BodyColumn::mass, true);
  EXPECT_TRUE(std::ranges::is_sorted(rows, std::greater<>(), &BodyRow::mass));
  sort_rows(rows, BodyColumn::tets, false);
  EXPECT_TRUE(std::ranges::is_sorted(rows, std::less<>(), &BodyRow::tets));
  sort_rows(rows, BodyColumn::state, false);
  EXPECT_TRUE(std::ranges::is_sorted(rows, std::less<>(), [](const BodyRow& row) { return row.state(); }));
  EXPECT_EQ(rows.size(), count);
  std::vector<BodyRow> named(3);
  named[0].name = "brick 10", named[1].name = "brick 9", named[2].name = "arch 11";
  sort_rows(named, BodyColumn::name, false);
  EXPECT_EQ(named[0].name, "arch 11");
  EXPECT_EQ(named[1].name, "brick 9");
}

TEST(BodyRows, FilterByNameAndState) {
  const std::vector<BodyView> pieces = random_pieces(200);
  Frame frame;
  frame.bodies = pieces;
  std::vector<BodyRow> rows = piece_rows(two_walls(), frame);
  const auto asleep = std::ranges::count(rows, 1, &BodyRow::asleep);
  ASSERT_GT(asleep, 0);
  filter_rows(rows, "ASLEEP");
  EXPECT_EQ(static_cast<std::ptrdiff_t>(rows.size()), asleep);
  filter_rows(rows, "no such");
  EXPECT_TRUE(rows.empty());
}

TEST(BodyRows, TheListAndTheMaterialSayWhatBrokeScaled) {
  Scene scene = two_walls();
  UiDriver ui(scene);
  std::vector<BodyView> pieces = random_pieces(200);
  ui.input.frame.bodies = pieces;
  for (int i = 0; i < 3; ++i) ui.frame();
  EXPECT_EQ(find_tag(ui.tags, "bodies/0/broke_scaled"), nullptr);
  EXPECT_EQ(find_tag(ui.tags, "material/broke_scaled"), nullptr);
  EXPECT_EQ(find_tag(ui.tags, "value/Broke while scaled"), nullptr);
  for (BodyView& piece : pieces)
    if (piece.scene_body == 0) piece.broke_scaled.emplace().factor = piece.id.index() % 2 == 0 ? 0.25 : 0.5;
  for (int i = 0; i < 3; ++i) ui.frame();
  EXPECT_EQ(ui.value("bodies/0/broke_scaled"), "E/16, σ/4");
  EXPECT_EQ(find_tag(ui.tags, "bodies/1/broke_scaled"), nullptr);
  EXPECT_EQ(ui.value("material/broke_scaled"), "E/16, σ/4") << "next to the full stiffness in the slider";
  EXPECT_NE(ui.value("value/Broke while scaled").find("E/16, σ/4"), std::string::npos);
}

TEST(BodyRows, TheListShowsStatesAndSelectsPieces) {
  Scene scene = two_walls();
  UiDriver ui(scene);
  const std::vector<BodyView> pieces = random_pieces(200);
  ui.input.frame.bodies = pieces;
  for (int i = 0; i < 3; ++i) ui.frame();
  EXPECT_EQ(ui.value("bodies/0/state"), "elastic");
  ui.click("bodies/filter");
  ui.type("asleep");
  EXPECT_EQ(find_tag(ui.tags, "bodies/0"), nullptr) << "its liveliest piece is awake";
  ui.click("bodies/pieces");
  EXPECT_EQ(ui.value("bodies/0/state"), "asleep");
}

TEST(SceneFields, ARightClickTypesOverAText) {
  UiDriver ui(two_walls());
  ui.state.open_sections = true;
  ui.frame();
  ui.click("body/name", 1);
  ui.type("left wall");
  EXPECT_EQ(ui.history.scene().bodies[0].name, "left wall");
}

}  // namespace
}  // namespace griffith::ui
