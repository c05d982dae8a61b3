#include <cmath>
#include <numbers>

#include "app/validate/experiment.h"
#include "app/validate/specimen.h"

namespace griffith::app {
namespace {

/// A plate with a round hole, pulled along x; `cells` around a quadrant of the hole.
struct PiercedPlate {
  const char* material = "concrete";
  double hole_radius = 0.5e-3, width = 0.02;  // [m]
  BoxPattern pattern = BoxPattern::five_tet;
  int cells = 8;
};

/// Returns the plate under its tensile strength.
SpecimenScene pierced_plate(const PiercedPlate& pierced) {
  const double thickness = std::numbers::pi / 2 * pierced.hole_radius / pierced.cells;
  SpecimenScene specimen{empty_laboratory(), {}};
  BodyDescription plate;
  plate.shape = PlateWithHoleShape{Vec3(pierced.width, pierced.width, thickness), pierced.hole_radius,
                                   Vec2(pierced.width / pierced.cells, thickness), pierced.pattern};
  plate.material = laboratory_material(pierced.material);
  for (const double side : {-1.0, 1.0})
    plate.loads.push_back(traction_on(end_region(side * Vec3::UnitX(), pierced.width / 2),
                                      side * plate.material.tensile_strength * Vec3::UnitX()));
  specimen.scene.bodies = {plate};
  return specimen;
}

/// Returns the remote stress at which most of the section cracks, over the tensile strength.
double pierced_strength(const PiercedPlate& pierced) {
  const SpecimenScene specimen = pierced_plate(pierced);
  const double thickness = std::numbers::pi / 2 * pierced.hole_radius / pierced.cells;
  const double area = 0.8 * (pierced.width - 2 * pierced.hole_radius) * thickness;
  return lowest_breaking(0.1, 2, 0.01, [&](double load) { return fails_statically(loaded(specimen, load), area); });
}

std::vector<Reading> run_hole(int mesh) {
  const int cells = 6 << mesh;
  std::vector<Reading> readings;
  for (const auto& [name, pattern] : {kNamedPatterns[0], kNamedPatterns[1]}) {
    readings.push_back({"stress / strength, 1 mm in concrete",
                        name,
                        {0.85, 1.05},
                        pierced_strength({"concrete", 0.5e-3, 0.02, pattern, cells})});
    readings.push_back({"stress / strength, 100 mm in glass", name, around(1 / 3.03, 0.1),
                        pierced_strength({"soda_lime_glass", 0.05, 1, pattern, cells})});
  }
  return readings;
}

}  // namespace

Experiment plate_with_hole() {
  return {.key = "hole",
          .title = "Plate with a round hole, small and large",
          .source = "Whitney & Nuismer 1974; Taylor 2007 (theory of critical distances)",
          .measured =
              "Plates, pulled until they break: of concrete with a hole of 1 mm, which is small against its "
              "characteristic length (K_Ic/σ_t)² of 160 mm, and of soda-lime glass with a hole of 100 mm, which is "
              "large against 0.3 mm. Measured is the remote stress at which most of the section cracks, over σ_t.",
          .acceptance =
              "1 mm: the hole has no effect but the section that it takes (0.85 to 1.05 σ_t). 100 mm: σ_t over the "
              "stress concentration of 3.03, ± 10 %. ± 15 % over meshes and patterns.",
          .meshes = {"6 elements a quadrant", "12 a quadrant", "24 a quadrant"},
          .run = run_hole};
}

}  // namespace griffith::app
