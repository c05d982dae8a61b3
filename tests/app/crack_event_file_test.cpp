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
    EXPECT_EQ(events[i]["elements"].size(), event.elements.size());
    EXPECT_EQ(events[i]["elements"][0]["tensile"][1], event.elements[0].force.tensile.y());
  }
}

}  // namespace
}  // namespace griffith::app
