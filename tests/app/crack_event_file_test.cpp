#include "app/output/crack_event_file.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sim/world/world.h"
#include "tests/world/scenes.h"

namespace griffith::app {
namespace {

TEST(CrackEventFile, HoldsEveryEventWithItsElements) {
  World world(testing::shot_wall(Vec3(3, 3, 1), 1.5, testing::brick(0.02)));
  for (int i = 0; i < 40; ++i) world.step();
  const Frame frame = world.frame();
  ASSERT_GT(frame.crack_events.size(), 0u);
  const nlohmann::json events = nlohmann::json::parse(crack_events_json(frame));
  ASSERT_EQ(events.size(), frame.crack_events.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    const CrackEvent& event = frame.crack_events[i];
    EXPECT_EQ(events[i]["node"], event.node.index());
    EXPECT_EQ(events[i]["load"], event.load);
    EXPECT_GT(events[i]["load"], events[i]["resistance"]);
    EXPECT_EQ(events[i]["scale_factor"], event.scaled ? event.scaled->factor : 1.0);
    EXPECT_EQ(events[i].contains("scaled_because"), event.scaled.has_value());
    EXPECT_EQ(events[i]["elements"].size(), event.elements.size());
    EXPECT_EQ(events[i]["elements"][0]["tensile"][1], event.elements[0].force.tensile.y());
  }
}

TEST(CrackEventFile, ReportsTheScaleAtWhichEachOpened) {
  Scene scene = testing::shot_wall(Vec3(3, 3, 1), 0.75, testing::brick(0.02));
  scene.bodies[0].material.young_modulus *= 100;  // for more microsteps than the budget pays for
  scene.simulation.step_budget = 0.1;
  World world(scene);
  for (int i = 0; i < 20; ++i) world.step();
  const nlohmann::json events = nlohmann::json::parse(crack_events_json(world.frame()));
  ASSERT_GT(events.size(), 0u);
  EXPECT_LT(events[0]["scale_factor"], 1);
  EXPECT_GE(events[0]["scale_factor"], 1.0 / 16);
  EXPECT_NE(events[0]["scaled_because"].get<std::string>().find("the budget leaves"), std::string::npos);
}

}  // namespace
}  // namespace griffith::app
