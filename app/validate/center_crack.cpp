#include <cmath>
#include <numbers>

#include "app/validate/experiment.h"
#include "app/validate/specimen.h"
#include "sim/mesh/box_mesh.h"

namespace griffith::app {
namespace {

constexpr double kCrackedWidth = 0.04, kCrackedLength = 0.08, kHalfCrack = 0.005;  // [m]; x across the load, y along

/// Returns the remote stress [Pa] at which K is K_Ic, by Feddersen's secant (Tada, Paris & Irwin 2000), within 0.3 %.
double center_crack_stress(double toughness) {
  const double angle = std::numbers::pi * kHalfCrack / kCrackedWidth;
  return toughness / std::sqrt(std::numbers::pi * kHalfCrack / std::cos(angle));
}

/// Returns a plate with a slit of 2a in its middle under the stress of the handbook.
SpecimenScene center_cracked_scene(BoxPattern pattern, int cells) {
  const double size = kCrackedWidth / cells;
  HexMesh hexes = make_box_hexes(Vec3(kCrackedWidth, kCrackedLength, size), {cells, 2 * cells, 1});
  open_slit(hexes, Vec3::UnitY(), [&](const Vec3& point) {
    return std::abs(point.y()) < 1e-3 * size && std::abs(point.x()) < kHalfCrack - 1e-3 * size;
  });
  SpecimenScene specimen{empty_laboratory(), {}};
  BodyDescription& plate = add_body(specimen, cut_into_tets(hexes, pattern), laboratory_material("acrylic"));
  plate.supports = plane_strain(size);
  const double stress = center_crack_stress(plate.material.fracture_toughness);
  for (const double side : {-1.0, 1.0})
    plate.loads.push_back(
        traction_on(end_region(side * Vec3::UnitY(), kCrackedLength / 2), side * stress * Vec3::UnitY()));
  return specimen;
}

std::vector<Reading> run_center_crack(int mesh) {
  const int cells = 16 << mesh;
  const double ligament = (kCrackedWidth - 2 * kHalfCrack) * kCrackedWidth / cells;
  std::vector<Reading> readings;
  for (const auto& [name, pattern] : kNamedPatterns) {
    const SpecimenScene specimen = center_cracked_scene(pattern, cells);
    const double strength = lowest_breaking(
        0.25, 4, 0.01, [&](double load) { return fails_statically(loaded(specimen, load), 0.2 * ligament); });
    readings.push_back({"breaking stress / closed form", name, around(1, 0.1), strength});
  }
  return readings;
}

}  // namespace

Experiment center_cracked_plate() {
  return {.key = "center_crack",
          .title = "Center-cracked plate in tension",
          .source = "Feddersen 1966; Tada, Paris & Irwin 2000",
          .measured =
              "A plate of acrylic, W = 40 mm wide and 80 mm long, with a slit of 10 mm in its middle, pulled along "
              "its length in plane strain. Measured is the remote stress at which cracks run through a fifth of the "
              "ligament in equilibrium, over K_Ic/√(πa sec(πa/W)) = 10.7 MPa.",
          .acceptance = "The closed form ± 10 %; ± 15 % over meshes and patterns.",
          .meshes = {"h = W/16", "h = W/32", "h = W/64"},
          .run = run_center_crack};
}

}  // namespace griffith::app
