#include "app/output/energy_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "program.h"
#include "sim/world/world.h"

namespace griffith::app {
namespace {

TEST(EnergyTable, HasAColumnAnEntryAndARowAFrame) {
  World world(small_wall());
  EnergyTable table(world.frame());
  world.step();
  table.add(world.frame());
  std::istringstream lines(table.csv());
  std::string heading, first, second, more;
  ASSERT_TRUE(std::getline(lines, heading) && std::getline(lines, first) && std::getline(lines, second));
  EXPECT_FALSE(std::getline(lines, more));
  EXPECT_EQ(heading.rfind("step,time [s],kinetic [J],elastic [J],", 0), 0u) << heading;
  for (const std::string& line : {heading, first, second})
    EXPECT_EQ(std::ranges::count(line, ','), 3 + static_cast<long>(energy_entries().size())) << line;
  double step = 0, time = 0, kinetic = 0;
  ASSERT_EQ(std::sscanf(second.c_str(), "%lf,%lf,%lf", &step, &time, &kinetic), 3);
  EXPECT_EQ(step, 1);
  EXPECT_EQ(time, world.frame().time);
  EXPECT_EQ(kinetic, world.frame().energy.kinetic);
}

}  // namespace
}  // namespace griffith::app
