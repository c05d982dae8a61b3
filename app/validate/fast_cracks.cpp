#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/validate/experiment.h"
#include "app/validate/specimen.h"
#include "sim/mesh/box_mesh.h"

namespace griffith::app {
namespace {

/// Gives a scene a time step [s] and no static start, so that loads act suddenly.
Scene dynamic_laboratory(double time_step) {
  Scene scene = empty_laboratory();
  scene.simulation.time_step = time_step;
  scene.simulation.static_start = false;
  return scene;
}

// ---- branching

constexpr double kBranchLength = 0.1, kBranchHeight = 0.04, kBranchNotch = 0.05;  // [m]; the crack runs along x

/// Returns the plate of soda-lime glass with a slit to its middle and its upper and lower edges under sudden tension.
SpecimenScene branching_scene(double size) {
  HexMesh hexes = make_box_hexes(
      Vec3(kBranchLength, kBranchHeight, size),
      {static_cast<int>(std::round(kBranchLength / size)), static_cast<int>(std::round(kBranchHeight / size)), 1});
  open_slit(hexes, Vec3::UnitY(), [&](const Vec3& point) {
    return std::abs(point.y()) < 1e-3 * size && point.x() < kBranchNotch - kBranchLength / 2 - 1e-3 * size;
  });
  Material glass = laboratory_material("soda_lime_glass");
  glass.young_modulus = 32e9;
  glass.poisson_ratio = 0.2;
  glass.density = 2450;
  glass.fracture_toughness = std::sqrt(3 * glass.young_modulus / (1 - 0.2 * 0.2));  // G_c = 3 J/m²
  glass.tensile_strength = 3.08e6;
  SpecimenScene specimen{dynamic_laboratory(1e-5), {}};
  specimen.scene.view.deformation_scale = 200;
  BodyDescription& plate = add_body(specimen, cut_into_tets(hexes, BoxPattern::five_tet), glass);
  plate.supports = plane_strain(size);
  for (const double side : {-1.0, 1.0})
    plate.loads.push_back(traction_on(end_region(side * Vec3::UnitY(), kBranchHeight / 2), side * 1e6 * Vec3::UnitY()));
  return specimen;
}

/// Returns the distance from the left edge at which cracks first run on both sides of the middle [m]; NaN: nowhere.
double branching_point(const Frame& frame) {
  constexpr double kApart = 0.003;
  std::vector<double> above, below;
  for (const CrackEvent& event : frame.crack_events) {
    if (event.rest_position.y() > kApart) above.push_back(event.rest_position.x());
    if (event.rest_position.y() < -kApart) below.push_back(event.rest_position.x());
  }
  if (above.empty() || below.empty()) return std::numeric_limits<double>::quiet_NaN();
  return kBranchLength / 2 + std::max(std::ranges::min(above), std::ranges::min(below)) - kApart;
}

World branched_plate(double size) {
  World world = branching_scene(size).world();
  while (world.frame().time < 80e-6 - 1e-9) world.step();
  return world;
}

std::vector<Reading> run_branching(int mesh) {
  const double size = 2e-3 / (1 << mesh);
  const World world = branched_plate(size);
  const double area = world.frame().energy.crack_area / size;
  return {{"branching point from the left edge [mm]", "hybrid", {61, 79}, 1e3 * branching_point(world.frame())},
          {"length of cracks [mm]", "hybrid", {70, 170}, 1e3 * area}};
}

// ---- Kalthoff and Winkler

constexpr double kImpactWidth = 0.1, kImpactHeight = 0.1, kImpactNotch = 0.05, kImpactTip = 0.025;  // [m]

/// Returns the upper half of a plate of maraging steel with a slit at the edge of its impact face: x from the face, y
/// from the plane of symmetry.
SpecimenScene kalthoff_scene(double size) {
  const int cells = static_cast<int>(std::round(kImpactWidth / size));
  HexMesh hexes = make_box_hexes(Vec3(kImpactWidth, kImpactHeight, size), {cells, cells, 1});
  const double height = kImpactTip - kImpactHeight / 2, tip = kImpactNotch - kImpactWidth / 2;
  open_slit(hexes, Vec3::UnitY(), [&](const Vec3& point) {
    return std::abs(point.y() - height) < 1e-3 * size && point.x() < tip - 1e-3 * size;
  });
  Material steel = laboratory_material("mild_steel");
  steel.yield_strength.reset();
  steel.young_modulus = 190e9;
  steel.poisson_ratio = 0.3;
  steel.density = 8000;
  steel.fracture_toughness = 68e6;
  steel.tensile_strength = 1.7e9;
  SpecimenScene specimen{dynamic_laboratory(1e-5), {}};
  BodyDescription& plate = add_body(specimen, cut_into_tets(hexes, BoxPattern::five_tet), steel);
  plate.supports = plane_strain(size);
  plate.supports.push_back(sliding_support(end_region(-Vec3::UnitY(), kImpactHeight / 2), Vec3::UnitY()));
  Support impact;
  impact.kind = SupportKind::prescribed;
  impact.region = BoxRegion{Vec3(-kImpactWidth / 2, -kImpactHeight / 2, -1) - Vec3::Constant(1e-6),
                            Vec3(-kImpactWidth / 2 + 1e-6, height - size / 2, 1)};
  impact.velocity = Vec3(16.5, 0, 0);
  impact.can_tear = false;
  plate.supports.push_back(impact);
  return specimen;
}

/// Returns the angle of the crack against the slit [degrees]: of the line from the tip to the mean of all cracks that
/// are 10 to 40 mm from it; NaN if there are none.
double kink_angle(const Frame& frame) {
  const Vec3 tip(kImpactNotch - kImpactWidth / 2, kImpactTip - kImpactHeight / 2, 0);
  Vec3 sum = Vec3::Zero();
  for (const CrackEvent& event : frame.crack_events) {
    Vec3 way = event.rest_position - tip;
    way.z() = 0;
    if (way.y() > 0 && way.norm() > 0.01 && way.norm() < 0.04) sum += way;
  }
  return sum.isZero() ? std::numeric_limits<double>::quiet_NaN()
                      : std::atan2(sum.y(), sum.x()) * 180 / std::numbers::pi;
}

World sheared_plate(double size) {
  World world = kalthoff_scene(size).world();
  while (world.frame().time < 100e-6 - 1e-9) world.step();
  return world;
}

std::vector<Reading> run_kalthoff(int mesh) {
  const World world = sheared_plate(5e-3 / (1 << mesh));
  return {{"angle of the crack [degrees]", "hybrid", {65, 75}, kink_angle(world.frame())}};
}

}  // namespace

Experiment branching_plate() {
  return {
      .key = "branching",
      .title = "Branching crack in a plate of glass",
      .source = "Borden, Verhoosel, Scott, Hughes & Landis 2012",
      .measured =
          "A plate of 100 × 40 mm (E = 32 GPa, ν = 0.2, ρ = 2450 kg/m³, G_c = 3 J/m², σ_t = 3.08 MPa) with a slit to "
          "its middle. Tension of 1 MPa acts suddenly on its upper and lower edges. Measured after 80 µs are the "
          "distance from the left edge at which the crack branches and the length of all cracks.",
      .acceptance = "Branches at 65 to 72 mm ± 10 % (61 to 79); length within 1.5 of 110 mm. ± 15 % over meshes.",
      .meshes = {"h = 2 mm", "h = 1 mm", "h = 0.5 mm"},
      .run = run_branching,
      .pictured = [] { return branched_plate(1e-3); }};
}

Experiment kalthoff_winkler() {
  return {
      .key = "kalthoff_winkler",
      .title = "Shear impact on a slit plate",
      .source = "Kalthoff & Winkler 1988",
      .measured =
          "Half a plate of maraging steel, 100 × 100 mm, with a slit of 50 mm, 25 mm above the plane of symmetry. The "
          "edge below the slit moves at 16.5 m/s. Measured after 100 µs is the angle between the crack and the slit.",
      .acceptance = "65° to 75°; ± 15 % over meshes.",
      .meshes = {"h = 5 mm", "h = 2.5 mm", "h = 1.25 mm"},
      .quick = true,
      .run = run_kalthoff,
      .pictured = [] { return sheared_plate(2.5e-3); }};
}

}  // namespace griffith::app
