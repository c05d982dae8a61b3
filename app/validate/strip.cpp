#include <algorithm>
#include <cmath>
#include <optional>

#include "app/validate/experiment.h"
#include "app/validate/specimen.h"
#include "sim/core/number_text.h"

namespace griffith::app {
namespace {

constexpr double kStripHalfHeight = 1, kStripLength = 8, kStripNotch = 2;  // [m]; x across, y along the crack
constexpr double kStripTip = kStripNotch - kStripLength / 2, kStripAdvance = kStripLength - kStripNotch;  // [m]

/// A strip between grips that move apart until it holds `energy` times G_c per area, then stop.
struct PulledStrip {
  Integrator integrator = Integrator::hybrid;
  BoxPattern pattern = BoxPattern::five_tet;
  double energy = 1;
  double size = 0.25;  ///< element size [m]
};

/// Modulus of a strip that can neither contract nor get thinner between its grips.
double strip_modulus(const Material& material) { return lame_lambda(material) + 2 * shear_modulus(material); }

/// Strain at which the strip holds `energy` times G_c per area.
double strip_strain(const Material& material, double energy) {
  return std::sqrt(energy * fracture_energy(material) / (strip_modulus(material) * kStripHalfHeight));
}

/// Returns a time in which the grips move [s]: five periods of the waves between them, which then cancel.
double strip_pull(const Material& material) {
  return 5 * 4 * kStripHalfHeight / std::sqrt(strip_modulus(material) / material.density);
}

/// A material that does not crack and whose vibrations end soon.
Material without_cracks(Material material) {
  material.tensile_strength = material.fracture_toughness = 1e12;
  material.mass_damping = 500;
  return material;
}

Scene strip_scene(const PulledStrip& strip, const Material& material) {
  Scene scene = empty_laboratory();
  scene.simulation.integrator = strip.integrator;
  scene.simulation.time_step = strip.integrator == Integrator::explicit_ ? 1e-4 : 1e-3;
  BodyDescription body;
  body.shape = NotchedBeamShape{Vec3(2 * kStripHalfHeight, kStripLength, strip.size), kStripNotch,
                                Vec3::Constant(strip.size), strip.pattern};
  body.material = without_cracks(material);
  body.supports = plane_strain(strip.size);
  const double pull = strip_pull(material);
  for (const double side : {-1.0, 1.0}) {
    Support grip;
    grip.kind = SupportKind::prescribed;
    grip.region = end_region(side * Vec3::UnitX(), kStripHalfHeight);
    grip.velocity = side * strip_strain(material, strip.energy) * kStripHalfHeight / pull * Vec3::UnitX();
    grip.stop = pull;
    grip.can_tear = false;
    body.supports.push_back(grip);
  }
  scene.bodies = {body};
  scene.view.deformation_scale = 3000;
  return scene;
}

/// Returns when a crack first came as far as `y` [s], if it did.
std::optional<double> time_of_arrival(const Frame& frame, double y) {
  for (const CrackEvent& event : frame.crack_events)
    if (event.rest_position.y() > y) return event.time;
  return std::nullopt;
}

struct StripResult {
  double advance = 0;  ///< fraction of the possible advance, 0..1
  double speed = 0;    ///< over that of Rayleigh waves; NaN if the crack did not cross the middle
  double taken = 0;    ///< energy that the account shows for the crack, over G_c times the area of its advance
};

/// Returns the advance of the crack over the possible one.
double strip_advance(const Frame& frame) {
  double advance = 0;
  for (const CrackEvent& event : frame.crack_events)
    advance = std::max(advance, (event.rest_position.y() - kStripTip) / kStripAdvance);
  return advance;
}

StripResult strip_result(const Frame& frame, const Material& material, double thickness) {
  StripResult result;
  result.advance = strip_advance(frame);
  const auto early = time_of_arrival(frame, kStripTip + 0.25 * kStripAdvance);
  const auto late = time_of_arrival(frame, kStripTip + 0.75 * kStripAdvance);
  result.speed = early && late && *late > *early
                     ? 0.5 * kStripAdvance / (*late - *early) / rayleigh_wave_speed(material)
                     : std::numeric_limits<double>::quiet_NaN();
  const double area = result.advance * kStripAdvance * thickness;
  result.taken = area > 0 ? frame.energy.fracture / (fracture_energy(material) * area) : 0;
  return result;
}

/// Pulls the strip without cracks, then gives it its strength and lets it crack between grips at rest.
World cracked_strip(const PulledStrip& strip, const Material& material) {
  World world(strip_scene(strip, material));
  while (world.frame().time < 1.4 * strip_pull(material)) world.step();
  world.set_material(0, material);
  constexpr double kQuiet = 0.01;  // ten periods of the waves between the grips [s]
  const double start = world.frame().time;
  const auto goes_on = [&] {
    const auto& cracks = world.frame().crack_events;
    return strip_advance(world.frame()) < 0.9 &&
           world.frame().time < kQuiet + (cracks.empty() ? start : cracks.back().time);
  };
  while (goes_on()) world.step();
  return world;
}

/// Appends the readings of a strip that holds `strip.energy`.
void read_strip(const PulledStrip& strip, const std::string& variant, std::vector<Reading>& readings) {
  const Material material = laboratory_material("concrete");
  const World world = cracked_strip(strip, material);
  const StripResult result = strip_result(world.frame(), material, strip.size);
  const std::string held = ", strip holds " + rounded_text(strip.energy, 3) + " G_c";
  const bool runs = strip.energy > 1;
  readings.push_back({"advance of the crack" + held, variant, runs ? AcceptedRange{0.9, 1} : AcceptedRange{0, 0.05},
                      result.advance, 0});
  if (!runs) return;
  readings.push_back({"energy taken / G_c" + held, variant, around(1, 0.05), result.taken});
  if (strip.integrator == Integrator::implicit) return;  // its steps do not follow waves
  readings.push_back({"speed / Rayleigh wave speed" + held, variant, {0.2, 0.7}, result.speed});
}

std::vector<Reading> run_strip(int mesh) {
  const double size = 0.25 / (1 << mesh);
  std::vector<Reading> readings;
  for (const double energy : {0.5, 0.8, 1.25, 2.0}) {
    read_strip({Integrator::hybrid, BoxPattern::five_tet, energy, size}, "hybrid, five_tet", readings);
    read_strip({Integrator::hybrid, BoxPattern::kuhn, energy, size}, "hybrid, kuhn", readings);
    read_strip({Integrator::implicit, BoxPattern::five_tet, energy, size}, "implicit, five_tet", readings);
  }
  for (const double energy : {0.8, 1.25})
    read_strip({Integrator::explicit_, BoxPattern::five_tet, energy, size}, "explicit, five_tet", readings);
  return readings;
}

World pictured_strip() {
  return cracked_strip({Integrator::hybrid, BoxPattern::five_tet, 1.25, 0.125}, laboratory_material("concrete"));
}

}  // namespace

Experiment crack_in_a_strip() {
  return {
      .key = "strip",
      .title = "Crack in a strip between fixed grips",
      .source = "Rice 1967; Freund 1990 (energy balance of a steady crack)",
      .measured =
          "A strip of concrete in plane strain, 2 m high and 8 m long with a notch of 2 m, is pulled without cracks, "
          "slowly, until it holds a multiple of G_c per area. Then its grips stand still and it may crack. Behind a "
          "crack it holds nothing, so by energy alone the crack runs if it holds more than G_c. Measured are the "
          "advance of the crack over that possible, its speed, and the energy that the account shows for it, over G_c "
          "times the area of the advance.",
      .acceptance =
          "No advance (5 %) below G_c, at least 90 % above; energy taken G_c ± 5 %; speed 0.2 to 0.7 of Rayleigh "
          "waves; each on all meshes and with each integrator.",
      .meshes = {"h = H/4", "h = H/8", "h = H/16"},
      .run = run_strip,
      .pictured = pictured_strip};
}

}  // namespace griffith::app
