#include <cmath>

#include "app/validate/experiment.h"
#include "app/validate/specimen.h"
#include "sim/core/number_text.h"

namespace griffith::app {
namespace {

constexpr double kBeamDepth = 0.1, kBeamSpan = 4 * kBeamDepth;  // [m]

/// A beam of glass with a notch in its middle, a load opposite of it and two bearings.
struct BentBeam {
  double notch = 0.5;  ///< a/W
  BoxPattern pattern = BoxPattern::five_tet;
  int cells = 16;  ///< through the depth
};

/// Returns the load per thickness [N/m] at which K is K_Ic (Tada, Paris & Irwin 2000; ASTM E399), within 0.5 %.
double handbook_load(double notch, double toughness) {
  const double x = notch;
  const double shape = 3 * std::sqrt(x) * (1.99 - x * (1 - x) * (2.15 - 3.93 * x + 2.7 * x * x)) /
                       (2 * (1 + 2 * x) * std::pow(1 - x, 1.5));
  return toughness * std::pow(kBeamDepth, 1.5) / (kBeamSpan * shape);
}

/// Returns the nodes on a line along z.
BoxRegion line_along_z(double x, double y) {
  const Vec3 reach(1e-6, 1e-6, 1);
  return {Vec3(x, y, 0) - reach, Vec3(x, y, 0) + reach};
}

/// Returns the beam under the load of the handbook.
SpecimenScene beam_scene(const BentBeam& beam) {
  const double size = kBeamDepth / beam.cells;
  SpecimenScene specimen{empty_laboratory(), {}};
  BodyDescription body;
  body.shape = NotchedBeamShape{Vec3(1.125 * kBeamSpan, kBeamDepth, size), beam.notch * kBeamDepth,
                                Vec3::Constant(size), beam.pattern};
  body.material = laboratory_material("soda_lime_glass");
  body.supports = plane_strain(size);
  for (const double side : {-1.0, 1.0})
    body.supports.push_back(sliding_support(line_along_z(side * kBeamSpan / 2, -kBeamDepth / 2), Vec3::UnitY()));
  body.supports.push_back(sliding_support(line_along_z(0, kBeamDepth / 2), Vec3::UnitX()));
  Load load;
  load.region = line_along_z(0, kBeamDepth / 2);
  load.force = Vec3(0, -handbook_load(beam.notch, body.material.fracture_toughness) * size, 0);
  body.loads = {load};
  specimen.scene.bodies = {body};
  return specimen;
}

/// Returns the load at which a fifth of the ligament cracks, over that of the handbook.
double beam_strength(const BentBeam& beam) {
  const SpecimenScene specimen = beam_scene(beam);
  const double ligament = (1 - beam.notch) * kBeamDepth * kBeamDepth / beam.cells;
  return lowest_breaking(0.25, 4, 0.01,
                         [&](double load) { return fails_statically(loaded(specimen, load), 0.2 * ligament); });
}

std::vector<Reading> run_notched_beam(int mesh) {
  std::vector<Reading> readings;
  for (const double notch : {0.25, 0.5, 0.75})
    for (const auto& [name, pattern] : kNamedPatterns)
      readings.push_back({"load / handbook, a/W = " + rounded_text(notch, 2), name, around(1, 0.1),
                          beam_strength({notch, pattern, 8 << mesh})});
  return readings;
}

}  // namespace

Experiment notched_beam() {
  return {.key = "notched_beam",
          .title = "Three-point bending of a notched beam",
          .source = "Tada, Paris & Irwin 2000; ASTM E399",
          .measured =
              "A beam of soda-lime glass of depth W = 100 mm and span 4 W with a notch of depth a in plane strain. "
              "Measured is the load at which a crack runs through a fifth of the ligament in equilibrium, over the "
              "load of the handbook. W is 350 characteristic lengths (K_Ic/σ_t)², so toughness alone decides.",
          .acceptance = "The load of the handbook ± 10 %; ± 15 % over meshes and patterns.",
          .meshes = {"h = W/8", "h = W/16", "h = W/32"},
          .run = run_notched_beam};
}

}  // namespace griffith::app
