#include <algorithm>
#include <cmath>

#include "app/validate/experiment.h"
#include "app/validate/specimen.h"

namespace griffith::app {
namespace {

/// A free plate normal to z that a ball strikes from above.
struct StruckPlate {
  const char* material = "concrete";
  Vec3 size = Vec3(1, 1, 0.1);
  Vec3 element_size = Vec3(0.1, 0.1, 0.05);
  double ball_mass = 5, ball_radius = 0.08, speed = 1;
  Vec2 place = Vec2::Zero();  ///< place of the impact [m]
};

Scene struck_plate_scene(const StruckPlate& struck) {
  Scene scene = empty_laboratory();
  BodyDescription plate;
  plate.shape = BoxShape{struck.size, struck.element_size, BoxPattern::five_tet};
  plate.material = laboratory_material(struck.material);
  plate.elements = ElementOrder::automatic;
  scene.bodies = {plate};
  ProjectileBurst ball;
  ball.position << struck.place, struck.size.z() / 2 + 1.001 * struck.ball_radius;
  ball.direction = -Vec3::UnitZ();
  ball.speed = struck.speed;
  ball.mass = struck.ball_mass;
  ball.radius = struck.ball_radius;
  ball.restitution = 0;
  scene.projectiles = {ball};
  return scene;
}

/// Returns the world 10 ms after the impact, or after the first crack if `until_crack`.
World struck_world(const Scene& scene, bool until_crack) {
  World world(scene);
  const double end = 0.001 * scene.projectiles[0].radius / scene.projectiles[0].speed + 0.01;
  while (world.frame().time < end && !(until_crack && !world.frame().crack_events.empty())) world.step();
  return world;
}

double lowest_breaking_speed(StruckPlate struck, double low, double high) {
  return lowest_breaking(low, high, 0.03, [&](double speed) {
    struck.speed = speed;
    return !struck_world(struck_plate_scene(struck), true).frame().crack_events.empty();
  });
}

/// Returns the number of pieces heavier than 1 % of the plate, the mean of some shots near one another.
double large_pieces(StruckPlate struck) {
  constexpr int kShots = 3;
  double pieces = 0;
  for (int shot = 0; shot < kShots; ++shot) {
    struck.place = Vec2(0.03 + 0.01 * shot, 0.05 - 0.015 * shot);
    const World world = struck_world(struck_plate_scene(struck), false);
    const double limit = 0.01 * world.frame().totals.mass;
    pieces += static_cast<double>(std::ranges::count_if(world.frame().bodies,
                                                        [&](const BodyView& piece) { return piece.mass > limit; })) /
              kShots;
  }
  return pieces;
}

std::vector<Reading> run_ball_on_plate(int mesh) {
  const double fraction = 1.0 / (1 << mesh);
  StruckPlate concrete;
  concrete.element_size *= fraction;
  concrete.place = Vec2(0.03, 0.05);
  StruckPlate glass{"soda_lime_glass", Vec3(0.4, 0.4, 0.01), Vec3(0.04, 0.04, 0.01) * fraction, 0.2, 0.018};
  glass.place = Vec2(0.012, 0.02);
  std::vector<Reading> readings;
  readings.push_back(
      {"lowest breaking speed, concrete [m/s]", "hybrid", {0, 50}, lowest_breaking_speed(concrete, 0.1, 50), 0.25});
  readings.push_back(
      {"lowest breaking speed, glass [m/s]", "hybrid", {0, 50}, lowest_breaking_speed(glass, 0.05, 50), 0.25});
  concrete.speed = 12;
  readings.push_back(
      {"pieces above 1 % of the mass, concrete at 12 m/s", "hybrid", {2, 100}, large_pieces(concrete), 0.3});
  return readings;
}

// ---- Zener's plate

constexpr double kZenerTime = 400e-6, kZenerThickness = 0.01;  // [s], [m]

/// Returns the distance that a ball has moved with an infinite plate at a time after a sticking impact (Zener 1941).
double zener_deflection(const Material& material, const StruckPlate& struck, double time) {
  const double thickness = struck.size.z();
  const double bending =
      material.young_modulus * std::pow(thickness, 3) / (12 * (1 - std::pow(material.poisson_ratio, 2)));
  const double impedance = 8 * std::sqrt(bending * material.density * thickness);
  return struck.ball_mass * struck.speed / impedance * (1 - std::exp(-impedance * time / struck.ball_mass));
}

/// Returns the distance that the ball moves into the plate in kZenerTime, over that of Zener.
double zener_fraction(const StruckPlate& struck) {
  Scene scene = struck_plate_scene(struck);
  scene.simulation.fracture = false;
  scene.simulation.time_step = 1e-4;
  ProjectileBurst& ball = scene.projectiles[0];
  ball.position.z() = struck.size.z() / 2 + struck.ball_radius + 1e-9;
  World world(scene);
  while (world.frame().time < kZenerTime - 1e-9) world.step();
  const double moved = ball.position.z() - world.frame().projectiles[0].position.z();
  return moved / zener_deflection(scene.bodies[0].material, struck, world.frame().time);
}

std::vector<Reading> run_zener(int mesh) {
  const double size = 0.04 / (1 << mesh);
  const StruckPlate struck{
      "soda_lime_glass", Vec3(0.6, 0.6, kZenerThickness), Vec3(size, size, kZenerThickness), 1, 0.031, 1};
  return {{"deflection after 400 µs / closed form", "hybrid", around(1, 0.1), zener_fraction(struck)}};
}

}  // namespace

Experiment ball_on_plate() {
  return {.key = "ball_on_plate",
          .title = "Ball on a plate: breaking speed and pieces",
          .source = "no published value: the same answer on every mesh",
          .measured =
              "A ball of 5 kg and 16 cm hits a free plate of concrete of 1 × 1 × 0.1 m, and a ball of steel of 200 g a "
              "pane of soda-lime glass of 0.4 × 0.4 × 0.01 m. Measured are the lowest speeds that cause a crack, and "
              "the pieces heavier than 1 % of the plate 10 ms after an impact of 12 m/s (mean of three shots).",
          .acceptance = "The same speed ± 25 % and the same number of pieces ± 30 % on all meshes.",
          .meshes = {"h", "h/2", "h/4"},
          .run = run_ball_on_plate};
}

Experiment zener_plate() {
  return {
      .key = "zener",
      .title = "Ball that sticks to a large plate",
      .source = "Zener 1941",
      .measured =
          "A ball of 1 kg hits a pane of soda-lime glass of 0.6 × 0.6 × 0.01 m at 1 m/s without cracks and stays in "
          "contact. Until waves return from the edges its speed is v exp(−Zt/m), Z = 8√(Dρh). Measured is its way "
          "after 400 µs over m v/Z (1 − exp(−Zt/m)) = 0.228 mm.",
      .acceptance = "The closed form ± 10 %; ± 15 % over meshes.",
      .meshes = {"h = 40 mm", "h = 20 mm", "h = 10 mm"},
      .run = run_zener};
}

}  // namespace griffith::app
