// Waves against their closed forms: where and when a bar spalls, what passes a step in a bar's area, how fast a crack
// runs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "sim/core/temporary_folder.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/write_mesh.h"
#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"

namespace griffith {
namespace {

/// Without Poisson's ratio, a bar is one-dimensional.
Material bar_material(double tensile_strength) {
  Material material;
  material.young_modulus = 30e9;
  material.poisson_ratio = 0;
  material.density = 2400;
  material.tensile_strength = tensile_strength;
  material.fracture_toughness = 1e9;
  return material;
}

double wave_speed(const Material& material) { return std::sqrt(material.young_modulus / material.density); }

Scene weightless(double time_step) {
  Scene scene;
  scene.gravity.setZero();
  scene.ground.reset();
  scene.simulation.time_step = time_step;
  return scene;
}

constexpr double kLength = 1;  // of a bar along x, which ends at 0 [m]

/// A bar that a flyer of half its length meets end to end.
Scene flyer_and_bar(int elements, double speed, double time_step) {
  const double size = kLength / elements;
  Scene scene = weightless(time_step);
  BodyDescription bar;
  bar.shape = BoxShape{Vec3(kLength, 2 * size, 2 * size), Vec3::Constant(size), BoxPattern::five_tet};
  bar.elements = ElementOrder::linear;  // steep fronts overshoot more with quadratic ones
  bar.material = bar_material(3e6);
  bar.position = Vec3(-kLength / 2, 0, 0);
  BodyDescription flyer = bar;
  flyer.shape = BoxShape{Vec3(kLength / 2, 2 * size, 2 * size), Vec3::Constant(size), BoxPattern::five_tet};
  flyer.material = bar_material(5e8);
  flyer.position = Vec3(kLength / 4 + 1e-4 * size, 0, 0);
  flyer.velocity = Vec3(-speed, 0, 0);
  scene.bodies = {bar, flyer};
  return scene;
}

/// Where along the bar the first crack opens within a few transits, if one does.
std::optional<double> first_crack(const Scene& scene) {
  World world(scene);
  const double time = 4 * kLength / wave_speed(scene.bodies[0].material);
  do {
    world.step();
    if (!world.frame().crack_events.empty()) return world.frame().crack_events[0].rest_position.x();
  } while (world.frame().time < time);
  return std::nullopt;
}

struct Spall : ::testing::TestWithParam<std::tuple<int, double>> {};

TEST_P(Spall, BreaksTheBarALengthOfTheFlyerFromItsFreeEndAtTwiceTheStrengthOverTheImpedance) {
  const auto [elements, time_step] = GetParam();
  const Material material = bar_material(3e6);
  const double closed_form = 2 * material.tensile_strength / (material.density * wave_speed(material));
  double holds = 0.5 * closed_form, breaking = 1.5 * closed_form;
  EXPECT_FALSE(first_crack(flyer_and_bar(elements, holds, time_step)));
  while (breaking > 1.02 * holds) {
    const double middle = 0.5 * (holds + breaking);
    (first_crack(flyer_and_bar(elements, middle, time_step)) ? breaking : holds) = middle;
  }
  // A front that is steeper than the mesh can carry overshoots, the less the finer the mesh.
  EXPECT_NEAR(breaking / closed_form, 1, 0.05 + 2.0 / elements);
  const std::optional<double> place = first_crack(flyer_and_bar(elements, 1.1 * breaking, time_step));
  ASSERT_TRUE(place);
  EXPECT_NEAR(*place, -kLength / 2, 2.1 * kLength / elements);
}

INSTANTIATE_TEST_SUITE_P(MeshesAndSteps, Spall,
                         ::testing::Combine(::testing::Values(20, 40),
                                            ::testing::Values(1.0 / 60, 1.0 / 1000, 1.0 / 4000)));

/// A bar whose ends are pushed or pulled by this stress [Pa] for half of the time that a wave takes through it. It
/// comes and goes in a tenth of that time, four elements: steeper fronts overshoot on a mesh.
Scene pulsed_bar(double right, double left, double time_step) {
  constexpr double kSize = kLength / 40;
  Scene scene = weightless(time_step);
  BodyDescription bar;
  bar.shape = BoxShape{Vec3(kLength, 2 * kSize, 2 * kSize), Vec3::Constant(kSize), BoxPattern::five_tet};
  bar.elements = ElementOrder::linear;
  bar.material = bar_material(3e6);
  bar.position = Vec3(-kLength / 2, 0, 0);
  for (const auto& [side, stress] : {std::pair(1.0, right), std::pair(-1.0, left)}) {
    if (stress == 0) continue;
    Load pulse;
    pulse.kind = LoadKind::traction;
    pulse.region = HalfSpaceRegion{Vec3(side * kLength / 2, 0, 0), Vec3(side, 0, 0)};
    pulse.traction = Vec3(side * stress, 0, 0);
    pulse.start = 1e-5;
    pulse.ramp = 0.1 * kLength / wave_speed(bar.material);
    bar.loads.push_back(pulse);
    pulse.start += 0.5 * kLength / wave_speed(bar.material);
    pulse.traction = -pulse.traction;
    bar.loads.push_back(pulse);
  }
  scene.bodies = {bar};
  return scene;
}

struct SpallByLoads : ::testing::TestWithParam<double> {};

// A push of length cτ at one end comes back from the free end as a pull, which is alone from cτ/2 on.
TEST_P(SpallByLoads, APushBreaksTheBarHalfItsLengthFromTheFreeEndAtTheStrength) {
  EXPECT_FALSE(first_crack(pulsed_bar(0, -0.9 * 3e6, GetParam())));
  const std::optional<double> place = first_crack(pulsed_bar(0, -1.1 * 3e6, GetParam()));
  ASSERT_TRUE(place);
  EXPECT_NEAR(*place, -kLength / 4, 0.1 * kLength);
}

// Two pulls meet in the middle, where they add up.
TEST_P(SpallByLoads, TwoPullsBreakTheBarInItsMiddleAtHalfTheStrength) {
  EXPECT_FALSE(first_crack(pulsed_bar(0.9 * 1.5e6, 0.9 * 1.5e6, GetParam())));
  const std::optional<double> place = first_crack(pulsed_bar(1.1 * 1.5e6, 1.1 * 1.5e6, GetParam()));
  ASSERT_TRUE(place);
  EXPECT_NEAR(*place, -kLength / 2, 0.1 * kLength);
}

INSTANTIATE_TEST_SUITE_P(Steps, SpallByLoads, ::testing::Values(1.0 / 60, 1.0 / 250, 1.0 / 1000, 1.0 / 4000));

/// The support at the left end of a bar starts to pull it at this speed [m/s] and stops after half a transit.
Scene jerked_bar(double speed, double time_step) {
  Scene scene = pulsed_bar(0, 0, time_step);
  Support jerk;
  jerk.kind = SupportKind::prescribed;
  jerk.region = HalfSpaceRegion{Vec3(-kLength / 2, 0, 0), -Vec3::UnitX()};
  jerk.velocity = Vec3(-speed, 0, 0);
  jerk.stop = 0.5 * kLength / wave_speed(scene.bodies[0].material);
  jerk.can_tear = false;
  scene.bodies[0].supports = {jerk};
  return scene;
}

TEST_P(SpallByLoads, ASupportThatJerksTheBarBreaksItAtTheStrengthOverTheImpedance) {
  const Material material = bar_material(3e6);
  const double closed_form = material.tensile_strength / (material.density * wave_speed(material));
  EXPECT_FALSE(first_crack(jerked_bar(0.4 * closed_form, GetParam())));  // it comes back from the held end doubled
  EXPECT_TRUE(first_crack(jerked_bar(1.1 * closed_form, GetParam())));
}

TEST(BarWave, ArrivesAndStaysElasticInTheSceneOfValidation) {
  const Scene scene = read_scene(std::filesystem::path(GRIFFITH_SOURCE_DIR) / "scenes/validation/bar_wave.json");
  const Material& material = scene.bodies[0].material;
  const double length = std::get<BoxShape>(scene.bodies[0].shape).size.x(), transit = length / wave_speed(material);
  const double plateau = 2 * scene.bodies[0].loads[0].traction.x() / (material.density * wave_speed(material));
  World world(scene);
  const auto end_velocity = [&] {
    double sum = 0;
    int count = 0;
    const Frame frame = world.frame();
    for (std::size_t i = 0; i < frame.nodes.positions.size(); ++i)
      if (frame.nodes.rest_positions[i].x() > length / 2 - 1e-9) sum += frame.nodes.velocities[i].x(), ++count;
    return sum / count;
  };
  double arrival = 0;
  while (world.frame().time < 1.5 * transit) {
    world.step();
    EXPECT_FALSE(world.frame().bodies[0].rigid);
    if (arrival == 0 && end_velocity() > 0.5 * plateau) arrival = world.frame().time;
  }
  EXPECT_NEAR(arrival, transit, 0.015 * transit);
  EXPECT_NEAR(end_velocity(), plateau, 0.03 * plateau);
}

/// A bar along x that is four times as thick below 0 as above.
TetSoup stepped_bar(double thin_length, double thick_length, double size) {
  TetSoup soup = make_box(Vec3(2 * thick_length, 4 * size, 4 * size), Vec3::Constant(size), BoxPattern::five_tet);
  std::erase_if(soup.tets, [&](const std::array<int, 4>& tet) {
    Vec3 center = Vec3::Zero();
    for (const int corner : tet) center += soup.points[corner] / 4;
    return center.x() > 0 && (std::abs(center.y()) > size || std::abs(center.z()) > size || center.x() > thin_length);
  });
  return soup;
}

/// Returns the impulse of a pulse in the thick part of the bar over its closed form, 2A₂ / (A₁ + A₂) times the first.
double arriving_fraction(Integrator integrator, double traction, double time_step) {
  constexpr double kThin = 0.8, kThick = 1.6, kSize = 0.04;
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "bar.msh";
  write_gmsh(path, stepped_bar(kThin, kThick, kSize));
  Scene scene = weightless(time_step);
  scene.simulation.integrator = integrator;
  scene.simulation.fracture = false;
  BodyDescription bar;
  bar.shape = MeshFileShape{path};
  bar.elements = ElementOrder::linear;
  bar.material = bar_material(1e6);
  const double speed = wave_speed(bar.material), duration = 0.5 / speed;
  Load pulse;
  pulse.kind = LoadKind::traction;
  pulse.region = HalfSpaceRegion{Vec3(kThin - 1e-6, 0, 0), Vec3::UnitX()};
  pulse.traction = Vec3(traction, 0, 0);
  pulse.duration = duration;
  bar.loads = {pulse};
  scene.bodies = {bar};
  World world(scene);
  while (world.frame().time < (kThin + 0.5 + 0.4) / speed) world.step();
  const Frame& frame = world.frame();
  double momentum = 0;
  for (std::size_t node = 0; node < frame.nodes.positions.size(); ++node)
    if (frame.nodes.rest_positions[node].x() < -1e-6)
      momentum += frame.nodes.masses[node] * frame.nodes.velocities[node].x();
  const double put_in = traction * 4 * kSize * kSize * duration;
  return momentum / (put_in * 2 * 4 / (1 + 4));
}

TEST(SteppedBar, PassesTheImpulseThatItsAreasSayInPressureAndInTension) {
  for (const double traction : {-5e5, 5e5})
    for (const Integrator integrator : {Integrator::hybrid, Integrator::implicit, Integrator::explicit_})
      EXPECT_NEAR(arriving_fraction(integrator, traction, 6.4e-6), 1, 0.03)
          << traction << " " << static_cast<int>(integrator);
}

/// A plate with a notch from its lower edge to −1 m, pulled across harder and harder; its upper edge is at 2 m. `ramp`:
/// duration in which the traction grows to its value [s]; vibrations of the plate take 4 ms.
Scene notched_plate(double traction, double time_step, double budget, double ramp = 0.5) {
  constexpr double kSize = 0.25, kWidth = 4;
  Scene scene = weightless(time_step);
  scene.simulation.step_budget = budget;
  BodyDescription plate;
  plate.shape =
      NotchedBeamShape{Vec3(1.5 * kWidth, kWidth, kSize), kWidth / 4, Vec3::Constant(kSize), BoxPattern::five_tet};
  plate.material = *find_material_preset("concrete");
  for (const double side : {-1.0, 1.0}) {
    Load pull;
    pull.kind = LoadKind::traction;
    pull.region = HalfSpaceRegion{Vec3(side * 0.75 * kWidth, 0, 0), Vec3(side, 0, 0)};
    pull.traction = Vec3(side * traction, 0, 0);
    pull.ramp = ramp;
    plate.loads.push_back(pull);
  }
  scene.bodies = {plate};
  return scene;
}

/// Speed of a crack from the notch to the last nodes before the edge [m/s], and the scale f.
struct RunningCrack {
  double speed = 0, factor = 1;
};

RunningCrack running_crack(const Scene& scene) {
  constexpr double kNotch = -1, kLast = 1.75;
  World world(scene);
  double first = 0;
  std::size_t seen = 0;
  while (world.frame().time < 1) {
    world.step();
    const auto& events = world.frame().crack_events;
    for (; seen < events.size(); ++seen) {
      const CrackEvent& event = events[seen];
      if (event.rest_position.y() < kNotch + 1e-6) first = event.time;
      if (event.rest_position.y() < kLast - 1e-6) continue;
      return {(kLast - kNotch) / (event.time - first), event.scaled ? event.scaled->factor : 1};
    }
  }
  return {};
}

/// Viktorov's approximation for the Rayleigh wave.
double rayleigh_speed(const Material& material) {
  const double shear_modulus = material.young_modulus / (2 * (1 + material.poisson_ratio));
  return std::sqrt(shear_modulus / material.density) * (0.862 + 1.14 * material.poisson_ratio) /
         (1 + material.poisson_ratio);
}

TEST(RunningCrack, CrossesAPlateAtAThirdOfTheRayleighSpeedAtAnyTimeStep) {
  const double rayleigh = rayleigh_speed(*find_material_preset("concrete"));
  for (const double time_step : {1.0 / 30, 1.0 / 60, 1.0 / 250, 1.0 / 1000, 1.0 / 4000}) {
    const double ramp = std::max(0.05, 15 * time_step);
    const RunningCrack crack = running_crack(notched_plate(1e6, time_step, 1e6, ramp));
    EXPECT_EQ(crack.factor, 1);
    EXPECT_GT(crack.speed, 0.2 * rayleigh) << time_step << " s";
    EXPECT_LT(crack.speed, 0.6 * rayleigh) << time_step << " s";
  }
}

TEST(RunningCrack, IsSlowedByDynamicSimilarityAsWavesAre) {
  const double rayleigh = rayleigh_speed(*find_material_preset("concrete"));
  for (const double time_step : {1.0 / 30, 1.0 / 60}) {
    Scene scene = notched_plate(1e6, time_step, 10);
    scene.bodies[0].elements = ElementOrder::linear;  // quadratic ones are not scaled
    const RunningCrack crack = running_crack(scene);
    EXPECT_LT(crack.factor, 1);
    EXPECT_GT(crack.speed, 0.2 * crack.factor * rayleigh) << time_step << " s";
    EXPECT_LT(crack.speed, 0.6 * crack.factor * rayleigh) << time_step << " s";
  }
}

/// The crack starts at the load that the notch bears, at every time step. A fast ramp goes on rising meanwhile, a slow
/// one hardly.
TEST(RunningCrack, RunsFasterWhereTheLoadRisesFasterAtAnyTimeStep) {
  const double slow = running_crack(notched_plate(0.5e6, 1.0 / 250, 1e6)).speed;
  const double fast = running_crack(notched_plate(4e6, 1.0 / 250, 1e6, 0.02)).speed;
  EXPECT_GT(fast, 1.3 * slow);
  EXPECT_NEAR(running_crack(notched_plate(0.5e6, 1.0 / 30, 1e6)).speed, slow, 0.05 * slow);
  EXPECT_NEAR(running_crack(notched_plate(4e6, 1.0 / 30, 1e6, 0.02)).speed, fast, 0.1 * fast);
}

}  // namespace
}  // namespace griffith
