#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/validate/experiment.h"
#include "app/validate/specimen.h"
#include "sim/core/sort_unique.h"
#include "sim/mesh/hex_mesh.h"

namespace griffith::app {
namespace {

// ---- spall

constexpr double kSpallBar = 1;  // length [m], along x; the flyer is half as long

Material spall_material(double tensile_strength) {
  Material material = laboratory_material("concrete");
  material.poisson_ratio = 0;  // the bar is one-dimensional
  material.tensile_strength = tensile_strength;
  return material;
}

/// Returns a bar with its free end at 0 and a flyer that hits the other end.
Scene spall_scene(int elements, double speed) {
  const double size = kSpallBar / elements;
  const auto bar_of = [&](double length, double center, double strength) {
    BodyDescription bar;
    bar.shape = BoxShape{Vec3(length, 2 * size, 2 * size), Vec3::Constant(size), BoxPattern::five_tet};
    bar.elements = ElementOrder::linear;  // for waves along bars (docs/fracture.md)
    bar.material = spall_material(strength);
    bar.position = Vec3(center, 0, 0);
    return bar;
  };
  Scene scene = empty_laboratory();
  scene.simulation.time_step = 1e-3;
  scene.bodies = {bar_of(kSpallBar, kSpallBar / 2, 3e6),
                  bar_of(kSpallBar / 2, (1.25 + 1e-4 / elements) * kSpallBar, 5e8)};
  scene.bodies[1].velocity = Vec3(-speed, 0, 0);
  return scene;
}

/// Returns where the first crack opens [m]; NaN if none does.
double spall_place(const Scene& scene) {
  World world(scene);
  while (world.frame().crack_events.empty() &&
         world.frame().time < 4 * kSpallBar / bar_wave_speed(scene.bodies[0].material))
    world.step();
  return world.frame().crack_events.empty() ? std::numeric_limits<double>::quiet_NaN()
                                            : world.frame().crack_events[0].rest_position.x();
}

std::vector<Reading> run_spall(int mesh) {
  const int elements = 40 << mesh;
  const Material material = spall_material(3e6);
  const double closed_form = 2 * material.tensile_strength / (material.density * bar_wave_speed(material));
  const double speed = lowest_breaking(0.3 * closed_form, 3 * closed_form, 0.01, [&](double value) {
    return !std::isnan(spall_place(spall_scene(elements, value)));
  });
  return {{"lowest speed / 2σ_t/(ρc)", "hybrid", around(1, 0.1), speed / closed_form},
          {"distance of the crack from the free end / flyer", "hybrid", around(1, 0.15),
           spall_place(spall_scene(elements, 1.1 * speed)) / (kSpallBar / 2)}};
}

// ---- expanding ring

constexpr double kRingRadius = 0.5, kRingWidth = 0.02;  // mean radius, height and width [m]

constexpr int kRingSectors = 158;  ///< parts about as long as they are wide

/// A ring about z of `across` × `across` cells.
struct RingMesh {
  TetSoup soup;
  std::vector<std::vector<int>> sectors;  ///< nodes of each of kRingSectors equal parts
};

RingMesh ring_mesh(int across) {
  const double size = kRingWidth / across;
  const int turns = kRingSectors * across;
  HexMeshBuilder builder;
  const auto node = [&](int turn, int out, int up) {
    const double angle = 2 * std::numbers::pi * turn / turns, radius = kRingRadius - kRingWidth / 2 + out * size;
    return builder.node({turn % turns, out, up, 0},
                        Vec3(radius * std::cos(angle), radius * std::sin(angle), up * size - kRingWidth / 2));
  };
  RingMesh ring;
  ring.sectors.resize(kRingSectors);
  for (int cell = 0; cell < turns * across * across; ++cell) {
    const int turn = cell / (across * across), out = cell % across, up = cell / across % across;
    std::array<int, 8> corners;
    for (int c = 0; c < 8; ++c) corners[c] = node(turn + (c & 1), out + (c >> 1 & 1), up + (c >> 2));
    builder.add_cell(corners);
    std::vector<int>& sector = ring.sectors[turn / across];
    sector.insert(sector.end(), corners.begin(), corners.end());
  }
  for (std::vector<int>& sector : ring.sectors) sort_unique(sector);
  ring.soup = cut_into_tets(builder.take(), BoxPattern::five_tet);
  return ring;
}

/// Cohesive units of a material: length E′G_c/σ_t² [m] and rate of strain σ_t c/(E l) [1/s].
struct CohesiveUnits {
  double length = 0, rate = 0;
};

CohesiveUnits cohesive_units(const Material& material) {
  const double length =
      material.young_modulus * fracture_energy(material) / (material.tensile_strength * material.tensile_strength);
  return {length, material.tensile_strength / material.young_modulus * bar_wave_speed(material) / length};
}

/// Returns a ring to which a short push of all its mass outward gives a rate of strain [1/s].
SpecimenScene expanding_ring(int across, double rate) {
  constexpr double kPush = 2e-7;  // short against the time to the first crack [s]
  SpecimenScene specimen{empty_laboratory(), {}};
  specimen.scene.simulation.time_step = 1e-4;
  specimen.scene.simulation.static_start = false;
  const RingMesh mesh = ring_mesh(across);
  BodyDescription& ring = add_body(specimen, mesh.soup, laboratory_material("concrete"));
  ring.strength_scatter = StrengthScatter{100, kRingWidth * kRingWidth * kRingRadius, 1};
  for (std::size_t sector = 0; sector < mesh.sectors.size(); ++sector) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(sector) + 0.5) / kRingSectors;
    Load push;
    push.kind = LoadKind::body_force;
    push.region = NodeListRegion{mesh.sectors[sector]};
    push.acceleration = rate * kRingRadius / kPush * Vec3(std::cos(angle), std::sin(angle), 0);
    push.duration = kPush;
    ring.loads.push_back(push);
  }
  return specimen;
}

/// Returns the world of a ring, broken at a rate in cohesive units.
World broken_ring(int across, double rate) {
  World world = expanding_ring(across, rate * cohesive_units(laboratory_material("concrete")).rate).world();
  while (world.frame().time < 5e-4) world.step();
  return world;
}

/// Returns the mean length of the pieces of a ring over that of Levy & Molinari.
double ring_fragments(int across, double rate) {
  const CohesiveUnits units = cohesive_units(laboratory_material("concrete"));
  const World world = broken_ring(across, rate);
  const double limit = 0.01 * units.length / (2 * std::numbers::pi * kRingRadius) * world.frame().totals.mass;
  const auto pieces =
      std::ranges::count_if(world.frame().bodies, [&](const BodyView& piece) { return piece.mass > limit; });
  const double expected = 4.5 / (1 + 4.5 * std::pow(rate, 2.0 / 3)) * units.length;
  return 2 * std::numbers::pi * kRingRadius / static_cast<double>(pieces) / expected;
}

std::vector<Reading> run_ring(int mesh) {
  std::vector<Reading> readings;
  for (const double rate : {1.0, 10.0})
    readings.push_back({rate == 1 ? "length of pieces / published, rate 1" : "length of pieces / published, rate 10",
                        "hybrid",
                        {0.67, 1.5},
                        ring_fragments(1 << mesh, rate)});
  return readings;
}

}  // namespace

Experiment spalling_bar() {
  return {
      .key = "spall",
      .title = "Spall of a bar",
      .source = "Kolsky 1953 (waves in a bar)",
      .measured =
          "A bar of 1 m, hit by a flyer of half its length (concrete without lateral contraction). Measured are the "
          "lowest speed that breaks it over 2σ_t/(ρc), and the distance of the crack from the free end at a tenth "
          "more over the length of the flyer.",
      .acceptance = "Speed ± 10 %, distance ± 15 %; ± 15 % over meshes.",
      .meshes = {"h = L/40", "h = L/80", "h = L/160"},
      .quick = true,
      .run = run_spall};
}

Experiment ring_fragmentation() {
  return {.key = "ring",
          .title = "Pieces of an expanding ring",
          .source = "Levy & Molinari 2010",
          .measured =
              "A ring of concrete, 20 mm thick and of radius 0.5 m, expands at 1 and 10 times the rate σ_t c/(E l), l "
              "= E G_c/σ_t² = 154 mm. "
              "Measured is the mean length of its pieces after 0.5 ms, over 4.5 l/(1 + 4.5 ε̇^⅔).",
          .acceptance = "The published length within its scatter, × 0.67 to 1.5; ± 15 % over meshes.",
          .cause = "Cracks open at nodes, so that elements limit how close they come.",
          .meshes = {"h = 20 mm", "h = 10 mm", "h = 5 mm"},
          .run = run_ring,
          .pictured = [] { return broken_ring(2, 1); }};
}

}  // namespace griffith::app
