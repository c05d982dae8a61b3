// Impacts of more microsteps than the budget leaves: bodies scaled by dynamic similarity.

#include "sim/world/explicit/similarity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "sim/world/bodies/bodies.h"
#include "sim/world/explicit/explicit_regime.h"
#include "sim/world/motion/elastic_phase.h"
#include "sim/world/motion/motion_phase.h"
#include "sim/world/output/scaled_breaks.h"
#include "sim/world/output/step_counters.h"
#include "sim/world/setup/build_world.h"
#include "sim/world/state/world_state.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

/// Weightless space with one body of boxes.
Scene body_of(const Vec3& size, double element_size) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.time_step = 1.0 / 60;
  BodyDescription body;
  body.shape = BoxShape{size, Vec3::Constant(element_size), BoxPattern::five_tet};
  body.elements = ElementOrder::linear;  // quadratic ones are not scaled
  body.material.tensile_strength = 1e6;
  scene.bodies = {body};
  return scene;
}

/// A bar that lands with its whole end on ground without friction.
Scene landing_bar(double speed) {
  Scene scene = body_of(Vec3(0.2, 1, 0.2), 0.1);
  scene.ground = Ground{0, 0, 0};
  scene.bodies[0].material.friction = 0;
  scene.bodies[0].material.poisson_ratio = 0.3;
  scene.bodies[0].position = Vec3(0, 0.55, 0);
  scene.bodies[0].velocity = Vec3(0, -speed, 0);
  return scene;
}

/// A body that a sphere strikes off its middle.
Scene struck(const Vec3& size, double element_size, double mass, double speed) {
  Scene scene = body_of(size, element_size);
  ProjectileBurst shot;
  shot.position = Vec3(0.02, 0.01, 0.5);
  shot.speed = speed;
  shot.mass = mass;
  shot.radius = 0.05;
  scene.projectiles = {shot};
  return scene;
}

/// The lowest f of any body that a step was made with.
double lowest_factor(const World& world) {
  double lowest = 1;
  for (const BodyView& body : world.frame().bodies)
    if (body.scaled) lowest = std::min(lowest, body.scaled->factor);
  return lowest;
}

struct ShotOutcome {
  bool broke = false;
  double factor = 1;
};

ShotOutcome outcome_of(const Scene& scene, double speed) {
  World world(scene);
  ShotOutcome outcome;
  const double time = 0.6 / speed + 0.03;
  while (world.frame().time < time && world.frame().crack_events.empty()) {
    world.step();
    outcome.factor = std::min(outcome.factor, lowest_factor(world));
  }
  outcome.broke = !world.frame().crack_events.empty();
  return outcome;
}

struct BreakingSpeed {
  double speed = 0;   ///< the lowest that breaks the body, to 1 % [m/s]
  double factor = 1;  ///< the lowest f on the way
};

BreakingSpeed breaking_speed(const std::function<Scene(double)>& scene_at, double time_step, double budget) {
  BreakingSpeed found{300, 1};
  for (double holds = 0.05; found.speed > 1.01 * holds;) {
    const double middle = std::sqrt(holds * found.speed);
    Scene scene = scene_at(middle);
    scene.simulation.time_step = time_step;
    scene.simulation.step_budget = budget;
    const ShotOutcome outcome = outcome_of(scene, middle);
    (outcome.broke ? found.speed : holds) = middle;
    found.factor = std::min(found.factor, outcome.factor);
  }
  return found;
}

TEST(Similarity, BreakingSpeedsDependNeitherOnTheBudgetNorOnTheTimeStep) {
  const std::vector<std::function<Scene(double)>> scenes = {
      [](double speed) { return landing_bar(speed); },
      [](double speed) { return struck(Vec3(1, 0.1, 0.1), 0.1, 0.1, speed); },
      [](double speed) { return struck(Vec3(1, 0.1, 0.1), 0.1, 1, speed); },
      [](double speed) { return struck(Vec3(0.8, 0.8, 0.1), 0.1, 2, speed); },
      [](double speed) { return struck(Vec3(0.6, 0.6, 0.6), 0.15, 20, speed); },
  };
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const double resolved = breaking_speed(scenes[i], 1.0 / 4000, 1e6).speed;
    for (const double time_step : {1.0 / 30, 1.0 / 120}) {
      EXPECT_NEAR(breaking_speed(scenes[i], time_step, 10).speed, resolved, 0.1 * resolved) << "scene " << i;
      const BreakingSpeed scaled = breaking_speed(scenes[i], time_step, 0.1);
      EXPECT_LT(scaled.factor, 1) << "scene " << i;
      EXPECT_NEAR(scaled.speed, resolved, 0.25 * resolved) << "scene " << i << ", f = " << scaled.factor;
    }
  }
}

/// A bar under tension, in explicit dynamics.
struct StretchedBar {
  WorldState world;

  explicit StretchedBar(bool supported) : world(build_world(scene(supported))) {
    for (const NodeId node : IdRange<NodeId>(0, world.mesh->node_count())) {
      const Vec3 rest = world.mesh->rest_positions[node];
      world.nodes.positions[node] = rest + 1e-5 * Vec3(rest.x() + 0.5, 0.2 * (rest.x() + 0.5), 0);
      world.nodes.velocities[node] = Vec3(1, rest.x(), 0.3);
    }
    update_elements(world);
    update_motion(world, body());
    begin_explicit(world, body(), 1);
  }
  static Scene scene(bool supported) {
    Scene scene = body_of(Vec3(1, 0.2, 0.2), 0.1);
    if (supported) scene.bodies[0].supports = {{HalfSpaceRegion{Vec3(-0.5, 0, 0), -Vec3::UnitX()}}};
    return scene;
  }
  Body& body() { return world.bodies[0]; }
};

TEST(Similarity, ScalingKeepsStressAndEnergy) {
  for (const bool supported : {false, true}) {
    StretchedBar bar(supported);
    const std::vector<ElementState> before = bar.world.elements.states;
    const double energy = mechanical_energy(bar.world, bar.body());
    for (const double factor : {0.5, 0.125}) {
      set_similarity(bar.world, bar.body(), factor);
      update_elements(bar.world, bar.body());
      EXPECT_NEAR(mechanical_energy(bar.world, bar.body()), energy, 1e-9 * energy);
      for (const TetId tet : IdRange<TetId>(0, bar.world.mesh->tet_count()))
        EXPECT_LT((bar.world.elements.states[tet].stress.full() - before[tet].stress.full()).norm(),
                  1e-6 * before[tet].stress.full().norm());
    }
  }
}

// What a body deforms by while it is scaled is 1/f times as much as it would have been.
TEST(Similarity, TheEndGivesTheShapeThatBelongsToTheStress) {
  for (const bool supported : {false, true}) {
    StretchedBar bar(supported);
    WorldState& world = bar.world;
    set_similarity(world, bar.body(), 0.25);
    for (const NodeId node : IdRange<NodeId>(0, world.mesh->node_count()))
      world.nodes.positions[node].x() += 4e-5 * (world.mesh->rest_positions[node].x() + 0.5);
    update_elements(world, bar.body());
    const std::vector<ElementState> scaled = world.elements.states;
    const RigidMotion motion = motion_of(world, bar.body());
    end_explicit(world, bar.body());
    for (const TetId tet : IdRange<TetId>(0, world.mesh->tet_count()))
      EXPECT_LT((world.elements.states[tet].stress.full() - scaled[tet].stress.full()).norm(),
                1e-3 * scaled[tet].stress.full().norm());
    for (const NodeId node : bar.body().nodes) {
      if (world.nodes.has_support[node] == 0) continue;
      EXPECT_LT((world.nodes.positions[node] - world.mesh->rest_positions[node]).norm(), 1e-12);
    }
    if (supported) continue;
    const RigidMotion after = motion_of(world, bar.body());
    EXPECT_LT((after.velocity - motion.velocity).norm(), 1e-12);
    EXPECT_LT((after.center - motion.center).norm(), 1e-12);
    const Vec3 spin = motion.inertia * motion.angular_velocity;
    EXPECT_LT((after.inertia * after.angular_velocity - spin).norm(), 1e-9 * spin.norm());
  }
}

/// A hanging bar, drawn to just below its strength, that a sphere touches.
Scene loaded_bar(double mass) {
  Scene scene = struck(Vec3(1, 0.1, 0.1), 0.1, mass, 2);
  BodyDescription& bar = scene.bodies[0];
  bar.material.poisson_ratio = 0;
  bar.supports = {{HalfSpaceRegion{Vec3(-0.5, 0, 0), -Vec3::UnitX()}}};
  Load pull;
  pull.region = HalfSpaceRegion{Vec3(0.5, 0, 0), Vec3::UnitX()};
  pull.kind = LoadKind::traction;
  pull.traction = Vec3(0.97 * bar.material.tensile_strength, 0, 0);
  bar.loads = {pull};
  scene.simulation.step_budget = 0.1;
  return scene;
}

TEST(Similarity, WhatStrainedABodyBeforeIsHeldAgainstItsFullStrength) {
  World touched(loaded_bar(1e-6)), hit(loaded_bar(1));
  double lowest = 1;
  for (int i = 0; i < 30; ++i) {
    touched.step();
    hit.step();
    lowest = std::min(lowest, lowest_factor(touched));
  }
  EXPECT_LT(lowest, 0.5) << "the touch was an impact";
  EXPECT_TRUE(touched.frame().crack_events.empty());
  EXPECT_FALSE(hit.frame().crack_events.empty()) << "and an impact does break it";
}

TEST(Similarity, WhatIsScaledIsTold) {
  Scene scene = struck(Vec3(1, 0.1, 0.1), 0.1, 1, 2);
  scene.simulation.step_budget = 0.1;
  World world(scene);
  std::optional<ScaledImpact> impact;
  for (int i = 0; i < 200 && !impact; ++i) {
    world.step();
    impact = world.frame().bodies[0].scaled;
  }
  ASSERT_TRUE(impact);
  const Material& material = scene.bodies[0].material;
  const double speed = material.tensile_strength / std::sqrt(material.young_modulus * material.density);
  const double effective = impact->tensile_strength / std::sqrt(impact->young_modulus * material.density);
  EXPECT_NEAR(effective, speed, 1e-9 * speed);
  EXPECT_EQ(impact->tets, 50);
  EXPECT_EQ(reason(*impact).find("50 tetrahedra would take "), 0u) << reason(*impact);
  EXPECT_GT(impact->microsteps, impact->affordable);
}

/// A pane that a ball breaks while it is scaled.
Scene scaled_pane() {
  Scene scene = struck(Vec3(1, 1, 0.1), 0.1, 5, 15);
  scene.simulation.step_budget = 1;
  return scene;
}

/// The body and those that it broke off, itself first.
std::vector<BodyId> line_of(const Frame& frame, BodyId body) {
  std::vector<BodyId> line;
  for (; body.valid(); body = frame.bodies[body].parent) line.push_back(body);
  return line;
}

/// The least factor of the cracks of a body itself; 1: none was scaled.
double least_of_own_cracks(const Frame& frame, BodyId body) {
  double least = 1;
  for (const CrackEvent& event : frame.crack_events)
    if (event.body == body && event.scaled) least = std::min(least, event.scaled->factor);
  return least;
}

TEST(Similarity, WhatBrokeScaledIsMarkedForEver) {
  World world(scaled_pane());
  while (world.frame().time < 1.0) world.step();
  const Frame frame = world.frame();
  ASSERT_GT(frame.fragments, 5);
  double least = 1;
  int marked = 0;
  for (const BodyView& body : frame.bodies) {
    EXPECT_FALSE(body.scaled) << "explicit dynamics has ended";
    double least_of_line = 1;
    for (const BodyId id : line_of(frame, body.id))
      least_of_line = std::min(least_of_line, least_of_own_cracks(frame, id));
    const double factor = body.broke_scaled ? body.broke_scaled->factor : 1;
    EXPECT_LE(factor, least_of_own_cracks(frame, body.id)) << "body " << body.id.index();
    EXPECT_GE(factor, least_of_line) << "body " << body.id.index();
    least = std::min(least, factor);
    marked += body.broke_scaled.has_value();
  }
  EXPECT_LT(least, 1);
  EXPECT_EQ(marked, static_cast<int>(frame.bodies.size())) << "all came from what broke scaled";
  const std::vector<ScaledBreak> breaks = scaled_breaks(frame);
  ASSERT_EQ(breaks.size(), 1u);
  EXPECT_EQ(breaks[0].pieces, marked);
  EXPECT_EQ(breaks[0].least.factor, least);
}

TEST(Similarity, WhatBreaksUnderItsFullStiffnessIsNotMarked) {
  Scene scene = scaled_pane();
  scene.simulation.step_budget = 1e6;
  World world(scene);
  while (world.frame().time < 0.1) world.step();
  EXPECT_GT(world.frame().fragments, 0);
  EXPECT_TRUE(scaled_breaks(world.frame()).empty());
  for (const CrackEvent& event : world.frame().crack_events) EXPECT_FALSE(event.scaled);
}

/// The budget asks for far less than what the speed of the impact, the strength or the least factor allow.
TEST(Similarity, WhatKeepsTheFactorIsTold) {
  const auto limit_of = [](double speed, double strength) {
    Scene scene = struck(Vec3(1, 1, 0.1), 0.1, 5, speed);
    scene.bodies[0].material.tensile_strength = strength;
    scene.simulation.step_budget = 0.1;
    World world(scene);
    while (!world.frame().bodies[0].scaled && world.frame().time < 1) world.step();
    return world.frame().bodies[0].scaled.value_or(ScaledImpact());
  };
  const Material material = scaled_pane().bodies[0].material;
  const double wave_speed = std::sqrt(material.young_modulus / material.density);
  const ScaledImpact slow = limit_of(2, 1e6), fast = limit_of(60, 1e6),
                     strong = limit_of(20, 0.002 * material.young_modulus);
  EXPECT_EQ(slow.limit, ScalingLimit::least);
  EXPECT_EQ(slow.factor, 1.0 / 16);
  EXPECT_EQ(fast.limit, ScalingLimit::speed);
  EXPECT_NEAR(fast.factor, 5 * 60 / wave_speed, 0.02);
  EXPECT_EQ(strong.limit, ScalingLimit::strain);
  EXPECT_NEAR(strong.factor, 0.1, 1e-9);
  EXPECT_NE(reason(fast).find("too fast"), std::string::npos) << reason(fast);
  EXPECT_EQ(scale_text(slow), "E/256, σ/16");
  EXPECT_EQ(scale_text(strong), "E/100, σ/10");
}

/// A light and stiff box between the ground and a heavy ball: its pieces rattle far faster than the step.
Scene pressed_box() {
  Scene scene = body_of(Vec3(4e-3, 3e-3, 2e-3), 2e-3);
  scene.ground = Ground{-2e-3};
  scene.simulation.step_budget = 1;
  Material& material = scene.bodies[0].material;
  material.young_modulus = 1.2e11;
  material.density = 12;
  material.tensile_strength = 1.8e5;
  material.fracture_toughness = 1e5;
  ProjectileBurst ball;
  ball.position = Vec3(1e-4, 6e-3, 0);
  ball.direction = Vec3(0, -1, 0);
  ball.speed = 1;
  ball.mass = 1;
  ball.radius = 8e-4;
  scene.projectiles = {ball};
  return scene;
}

TEST(Similarity, AStepTakesNoMoreMicrostepsThanItsLimit) {
  const Scene scene = pressed_box();
  World world(scene);
  StepReport total;
  for (int i = 0; i < 30; ++i) {
    world.step();
    const StepReport& report = world.frame().report;
    const int alone = 200 * report.impacts;  // of those that are followed alone, at most
    EXPECT_LE(report.microsteps, 1e4 * scene.simulation.step_budget + report.substeps + alone)
        << "rounded up in each substep";
    EXPECT_EQ(report.non_finite_values, 0);
    add_step(report, total);
  }
  EXPECT_GT(total.microsteps, 1e4 * scene.simulation.step_budget) << "the next step goes on with them";
  EXPECT_GT(total.unfinished_explicit, 0) << "and this is reported";
}

}  // namespace
}  // namespace griffith
