#include "ui/model/scene_problem.h"

#include <gtest/gtest.h>

#include "ui_driver.h"

namespace griffith::ui {
namespace {

Scene walls_with_parts() {
  Scene scene = two_walls();
  scene.bodies[1].supports.resize(2);
  scene.bodies[1].loads.resize(1);
  scene.projectiles.resize(1);
  scene.probes.resize(1);
  scene.cameras.resize(1);
  return scene;
}

TEST(SceneProblem, PointersLeadToEntriesAndFields) {
  const Scene scene = walls_with_parts();
  const auto place = [&](const char* pointer) { return field_place(scene, pointer); };
  EXPECT_EQ(place("/bodies/1/supports/1/region"), (FieldPlace{SceneEntry{EntryKind::support, 1, 1}, "entry/region"}));
  EXPECT_EQ(place("/bodies/1/loads/0"), (FieldPlace{SceneEntry{EntryKind::load, 0, 1}, "entry"}));
  EXPECT_EQ(place("/bodies/0/shape/box/size"), (FieldPlace{SceneEntry{EntryKind::body, 0}, "body/shape/box/size"}));
  EXPECT_EQ(place("/bodies/0/material/density"), (FieldPlace{SceneEntry{EntryKind::body, 0}, "material/density"}));
  EXPECT_EQ(place("/projectiles/0/speed"), (FieldPlace{SceneEntry{EntryKind::projectile, 0}, "entry/speed"}));
  EXPECT_EQ(place("/probes/0/at/region"), (FieldPlace{SceneEntry{EntryKind::probe, 0}, "entry/at/region"}));
  EXPECT_EQ(place("/simulation/time_step"), (FieldPlace{std::nullopt, "scene/simulation/time_step"}));
  EXPECT_EQ(place("/bodies/9/position").entry, std::nullopt) << "a body that is gone";
  EXPECT_EQ(place("").entry, std::nullopt);
}

TEST(SceneProblem, PlacesAreReadAsTheOutlinerNamesThem) {
  const Scene scene = walls_with_parts();
  const std::string body = scene.bodies[1].name;
  EXPECT_EQ(place_text(scene, "/bodies/1/supports/1/region"), "Support 2 of " + body + ": region");
  EXPECT_EQ(place_text(scene, "/bodies/1/shape/mesh"), body + ": shape, mesh");
  EXPECT_EQ(place_text(scene, "/simulation/time_step"), "Scene: simulation, time step");
}

TEST(SceneProblem, AFieldIsWithinThePartsAroundIt) {
  EXPECT_TRUE(is_within("body/shape/box", "body"));
  EXPECT_TRUE(is_within("body/shape/box", "body/shape/box"));
  EXPECT_FALSE(is_within("body/shape", "body/shape/box"));
  EXPECT_FALSE(is_within("body/shapes", "body/shape"));
}

}  // namespace
}  // namespace griffith::ui
