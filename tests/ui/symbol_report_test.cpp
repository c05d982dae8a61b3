// Explanations of crack planes, contacts and principal axes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/elasticity/principal_stress.h"
#include "sim/world/world.h"
#include "tests/world/scenes.h"
#include "ui/model/quantity_parser.h"
#include "ui/model/symbol.h"

namespace griffith::ui {
namespace {

using ::testing::HasSubstr;

std::string value_of(const SymbolReport& report, const std::string& label) {
  const auto row = std::ranges::find(report.rows, label, &SymbolReport::Row::label);
  return row == report.rows.end() ? "no row " + label : row->value;
}

double number_of(const SymbolReport& report, const std::string& label, const char* unit) {
  return parse_quantity(value_of(report, label), unit).value_or(std::nan(""));
}

/// A block of 100 kg that rests on the ground.
Scene resting_block() {
  Scene scene;
  BodyDescription block;
  block.name = "block";
  block.shape = BoxShape{Vec3(1, 0.5, 1), Vec3::Constant(0.5), BoxPattern::kuhn};
  block.position = Vec3(0, 0.25, 0);
  block.material.density = 200;
  scene.bodies = {block};
  return scene;
}

TEST(SymbolReport, ContactsOfARestingBlockCarryItsWeight) {
  const Scene scene = resting_block();
  World world(scene);
  for (int step = 0; step < 5; ++step) world.step();
  const Frame frame = world.frame();
  ASSERT_FALSE(frame.contacts.empty());
  double force = 0;
  for (int i = 0; i < static_cast<int>(frame.contacts.size()); ++i) {
    const auto report = symbol_report({SymbolKind::contact, i}, frame, scene, scene.simulation.time_step);
    ASSERT_TRUE(report);
    EXPECT_THAT(report->sentence, HasSubstr("The ground pushed block, piece 0"));
    EXPECT_EQ(value_of(*report, "Normal"), "0.00, 1.00, 0.00");
    force += number_of(*report, "Normal force", "N");
    EXPECT_LT(frame.contacts[static_cast<std::size_t>(i)].depth, 1e-4) << "it rests on the ground";
    EXPECT_NEAR(number_of(*report, "Separation speed", "m/s"), 0, 0.01);
  }
  EXPECT_NEAR(force, 100 * 9.81, 0.02 * 100 * 9.81);
}

TEST(SymbolReport, ContactsOfWhatStrikesTheGroundTellItsSpeed) {
  constexpr double kSpeed = 2;
  for (const Integrator integrator : {Integrator::implicit, Integrator::explicit_}) {
    Scene scene = resting_block();
    scene.gravity = Vec3::Zero();
    scene.bodies[0].position.y() += 0.01;
    scene.bodies[0].velocity = Vec3(0, -kSpeed, 0);
    scene.simulation.integrator = integrator;
    World world(scene);
    double fastest = 0;
    for (int step = 0; step < 5; ++step) {
      world.step();
      const Frame frame = world.frame();
      for (int i = 0; i < static_cast<int>(frame.contacts.size()); ++i) {
        const auto report = symbol_report({SymbolKind::contact, i}, frame, scene, scene.simulation.time_step);
        ASSERT_TRUE(report);
        fastest = std::max(fastest, number_of(*report, "Approach speed", "m/s"));
        EXPECT_GE(frame.contacts[static_cast<std::size_t>(i)].depth, 0);
      }
    }
    EXPECT_NEAR(fastest, kSpeed, 0.1 * kSpeed) << (integrator == Integrator::implicit ? "implicit" : "explicit");
  }
}

TEST(SymbolReport, OverlapsAreTold) {
  const Scene scene = resting_block();
  World world(scene);
  for (int step = 0; step < 5; ++step) world.step();
  Frame frame = world.frame();
  std::vector<ContactView> contacts(frame.contacts.begin(), frame.contacts.end());
  contacts.front().depth = 0.0125;
  frame.contacts = contacts;
  EXPECT_NEAR(number_of(*symbol_report({SymbolKind::contact, 0}, frame, scene, 0.01), "Overlap", "m"), 0.0125, 1e-6);
  contacts.front().depth = 0;
  EXPECT_EQ(value_of(*symbol_report({SymbolKind::contact, 0}, frame, scene, 0.01), "Overlap"), "none");
}

TEST(SymbolReport, PlanesSayWhatTheEventsSay) {
  const Scene scene = testing::shot_wall(Vec3(2, 2, 0.25), 0.5, testing::brick(0.05));
  World world(scene);
  while (world.frame().crack_events.empty()) world.step();
  const Frame frame = world.frame();
  for (int i = 0; i < static_cast<int>(frame.crack_events.size()); ++i) {
    const CrackEvent& crack = frame.crack_events[static_cast<std::size_t>(i)];
    const auto report = symbol_report({SymbolKind::fracture_plane, i}, frame, scene, 1);
    ASSERT_TRUE(report);
    EXPECT_THAT(report->sentence, HasSubstr("Node " + std::to_string(crack.node.index()) + " "));
    EXPECT_NEAR(number_of(*report, "Load", "Pa"), crack.load, 1e-3 * crack.load);
    EXPECT_NEAR(number_of(*report, "Resistance", "Pa"), crack.resistance, 1e-3 * crack.resistance);
    EXPECT_THAT(value_of(*report, "Time"), HasSubstr("in step " + std::to_string(frame.step)));
  }
}

TEST(SymbolReport, AxesSayWhatTheTensorsSay) {
  const Scene scene = testing::shot_wall(Vec3(2, 2, 0.25), 0.5, testing::brick(100));
  World world(scene);
  for (int step = 0; step < 12; ++step) world.step();
  const Frame frame = world.frame();
  for (int tet = 0; tet < static_cast<int>(frame.elements.tets.size()); tet += 7)
    for (int axis = 0; axis < 3; ++axis) {
      const double value = principal_values(frame.elements.stresses[TetId(tet)]).values[axis];
      const auto report = symbol_report({SymbolKind::stress_axis, tet, axis}, frame, scene, 1);
      ASSERT_TRUE(report);
      EXPECT_NEAR(number_of(*report, "Principal value", "Pa"), value, 1e-3 * std::abs(value));
      if (value == 0) continue;
      EXPECT_THAT(report->sentence, HasSubstr(value > 0 ? "pulled" : "pressed"));
    }
}

TEST(SymbolReport, NothingIsSaidOfWhatTheFrameLacks) {
  const Scene scene = resting_block();
  const World world(scene);
  for (const SymbolKind kind :
       {SymbolKind::fracture_plane, SymbolKind::contact, SymbolKind::stress_axis, SymbolKind::separation_axis})
    for (const int index : {-1, 1'000'000}) EXPECT_FALSE(symbol_report({kind, index}, world.frame(), scene, 1));
}

}  // namespace
}  // namespace griffith::ui
