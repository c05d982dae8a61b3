#include <cmath>
#include <numbers>

#include "app/validate/experiment.h"
#include "app/validate/specimen.h"

namespace griffith::app {
namespace {

constexpr double kDiscRadius = 0.5, kDiscThickness = 0.1;  // [m]
constexpr double kPadAngle = 9 * std::numbers::pi / 180;   // half the angle that a pad covers
constexpr int kSidesPerQuarter = 10;                       // of the coarsest disc, each as wide as half a pad

/// Returns a disc under the load of 2P/(πDt) = σ_t, spread over two pads.
SpecimenScene loaded_disc(BoxPattern pattern, int refinement) {
  SpecimenScene specimen{empty_laboratory(), {}};
  BodyDescription disc;
  const double size = 1.2 * kDiscRadius / (kSidesPerQuarter * refinement);
  disc.shape = DiscShape{kDiscRadius, kDiscThickness, Vec2(size, kDiscThickness / 2), pattern};
  disc.material = laboratory_material("granite");
  const double load = std::numbers::pi * kDiscRadius * kDiscThickness * disc.material.tensile_strength;
  const Vec3 half(std::sin(kPadAngle) * kDiscRadius + 1e-6, (1 - std::cos(kPadAngle)) * kDiscRadius + 1e-6, 1);
  for (const double side : {-1.0, 1.0}) {
    const Vec3 top(0, side * kDiscRadius, 0);
    const BoxRegion pad{top - half, top + half};
    disc.loads.push_back(traction_on(pad, Vec3(0, -side * load / (2 * kPadAngle * kDiscRadius * kDiscThickness), 0)));
  }
  specimen.scene.bodies = {disc};
  return specimen;
}

std::vector<Reading> run_brazilian_disc(int mesh) {
  std::vector<Reading> readings;
  for (const auto& [name, pattern] : kNamedPatterns) {
    const SpecimenScene specimen = loaded_disc(pattern, 1 << mesh);
    readings.push_back({"load / (πDt σ_t/2)", name, around(1, 0.15), lowest_breaking(0.25, 4, 0.01, [&](double load) {
                          return fails_statically(loaded(specimen, load), 0.2 * 2 * kDiscRadius * kDiscThickness);
                        })});
  }
  return readings;
}

}  // namespace

Experiment brazilian_disc() {
  return {
      .key = "brazilian_disc",
      .title = "Brazilian disc of granite",
      .source = "Carneiro & Barcellos 1953; ISRM 1978; Wang et al. 2004 (flat pads)",
      .measured =
          "A disc of granite of 1 m, compressed across its diameter by pads that cover 18° each. Measured is the load "
          "at which a crack runs through a fifth of the diameter, over that at which the tension in the middle, "
          "2P/(πDt), is σ_t.",
      .acceptance =
          "1 ± 15 %, since pads lower the stress in the middle by some percent; ± 15 % over meshes and patterns.",
      .meshes = {"h = 60 mm", "h = 30 mm", "h = 15 mm"},
      .run = run_brazilian_disc};
}

}  // namespace griffith::app
