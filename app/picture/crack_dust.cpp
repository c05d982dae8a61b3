#include "app/picture/crack_dust.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "app/picture/body_cells.h"
#include "app/picture/natural_materials.h"

namespace griffith::app {
namespace {

constexpr std::size_t kMaxPuffs = 1200, kMaxCrumbs = 3000;  ///< limits; the newest cracks count
constexpr double kPuffTime = 0.9;                           ///< time until a puff has faded [s]
constexpr double kDrag = 0.12;                              ///< time constant of drag on dust [s]
/// Speed of fragments, relative to the particle velocity behind a wave of the material's strength, and its limits
/// [m/s].
constexpr double kThrow = 4, kMinSpeed = 0.3, kMaxSpeed = 6;

constexpr double kLargestCrumb = 0.025;  ///< radius [m]

/// Fragmentation of a material.
struct Crumbling {
  std::string_view preset;
  double dust;  ///< 0..1
  int crumbs;   ///< number per crack
  double size;  ///< size of a crumb in element sizes, at most kLargestCrumb
};
constexpr Crumbling kCrumblingTable[] = {{"concrete", 1, 3, 0.05},
                                         {"brick", 0.9, 4, 0.05},
                                         {"granite", 0.6, 3, 0.05},
                                         {"marble", 0.6, 3, 0.05},
                                         {"plaster", 1, 4, 0.05},
                                         {"porcelain", 0.25, 3, 0.04},
                                         {"alumina", 0.25, 3, 0.04},
                                         {"soda_lime_glass", 0, 3, 0.025},
                                         {"ice", 0.2, 4, 0.04},
                                         {"acrylic", 0, 2, 0.03},
                                         {"wood_along_grain", 0.1, 2, 0.035},
                                         {"wood_across_grain", 0.1, 2, 0.035}};

/// Returns null for materials that do not crumble: metals, rubber, jelly.
const Crumbling* crumbling_of(const Material& material) {
  const auto* found = std::ranges::find(kCrumblingTable, preset_alike(material), &Crumbling::preset);
  return found == std::end(kCrumblingTable) ? nullptr : found;
}

/// Pseudo-random numbers in 0..1 from a seed (Steele, Lea and Flood 2014, SplitMix).
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : state_(seed) {}
  double operator()() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return static_cast<double>((z ^ z >> 31) >> 11) * 0x1p-53;
  }
  Vec3 in_cube() {
    const double x = (*this)(), y = (*this)(), z = (*this)();
    return Vec3(2 * x - 1, 2 * y - 1, 2 * z - 1);
  }

 private:
  std::uint64_t state_;
};

/// A crack with the properties of its surroundings.
struct Source {
  Vec3 place, normal;
  double age = 0, size = 0, speed = 0;  ///< age of the crack [s], size of elements [m], speed of fragments [m/s]
  double openness = 0;                  ///< 0..1: a closed crack emits nothing
  const Crumbling* crumbling = nullptr;
  render::Rgb color;
};

/// Returns the edge length of the elements at the crack [m].
double element_size(const Frame& frame, const CrackEvent& event) {
  std::vector<TetId> tets;
  for (const CrackElement& element : event.elements) tets.push_back(element.tet);
  return mean_element_size(frame.elements.rest_elements, tets);
}

/// Returns the opening of a crack, 0..1, relative to the one that releases all dust.
double openness_of(const Frame& frame, const CrackEvent& event, double element_size) {
  constexpr double kAllOut = 0.02;  // fraction of the element size
  Eigen::AlignedBox3d corners;
  for (const CrackElement& element : event.elements) {
    const auto apart = [&](NodeId node) { return (frame.nodes.rest_positions[node] - event.rest_position).norm(); };
    corners.extend(frame.nodes.positions[*std::ranges::min_element(frame.elements.tets[element.tet], {}, apart)]);
  }
  return std::min(1.0, corners.diagonal().norm() / (kAllOut * element_size));
}

/// Returns a paler color: small chips of clear material are nearly colorless and scatter light.
render::Rgb paler(const render::Rgb& color) {
  constexpr float kShare = 0.6f;
  const auto mixed = [](float channel) { return channel + kShare * (1 - channel); };
  return {mixed(color.r), mixed(color.g), mixed(color.b)};
}

/// Returns the common properties of all cracks of each scene body.
std::vector<Source> sources_of(const Scene& scene) {
  const std::vector<render::EmbeddedMaterial> looks = natural_materials(scene);
  std::vector<Source> sources;
  for (int body = 0; body < std::ssize(scene.bodies); ++body) {
    const Material& material = scene.bodies[static_cast<std::size_t>(body)].material;
    const double impedance = std::sqrt(material.young_modulus * material.density);
    Source& source = sources.emplace_back();
    source.speed = std::clamp(kThrow * material.tensile_strength / impedance, kMinSpeed, kMaxSpeed);
    source.crumbling = crumbling_of(material);
    const render::EmbeddedMaterial& inside = looks[static_cast<std::size_t>(look_index(body, Look::inside))];
    source.color = inside.clear_depth > 0 ? paler(inside.color) : inside.color;
  }
  return sources;
}

/// Returns the direction of a fragment: near the crack's normal to either side.
/// Most are slow and stay near the crack.
Vec3 throw_of(const Source& source, Chance& chance) {
  const double side = chance() < 0.5 ? -1 : 1, fast = chance(), strength = 0.15 + 1.55 * fast * fast * fast;
  return source.speed * strength * (side * source.normal + 0.7 * chance.in_cube());
}

render::Puff puff_of(const Source& source, Chance& chance) {
  const double reach = kDrag * (1 - std::exp(-source.age / kDrag));
  const Vec3 thrown = throw_of(source, chance);
  const double grown = 0.3 + 0.5 * chance() + 1.9 * (1 - std::exp(-source.age / 0.35));
  const double left = 1 - source.age / kPuffTime, risen = std::min(source.age / 0.03, 1.0);
  const double share = (0.3 + 0.2 * chance()) * std::pow(0.55 / grown, 1.4);  // the same dust, spread wider
  return {(source.place + reach * thrown).cast<float>(), static_cast<float>(0.45 * source.size * grown), source.color,
          static_cast<float>(source.openness * source.crumbling->dust * share * left * left * risen)};
}

/// Returns the time until an object thrown up from that height above the ground with that speed lands [s].
double fall_time(double height, double speed, double gravity) {
  return (speed + std::sqrt(speed * speed + 2 * gravity * std::max(height, 0.0))) / gravity;
}

/// Ballistic flight under gravity.
struct Flight {
  Vec3 start, velocity, gravity;
  Vec3 at(double time) const { return start + time * velocity + 0.5 * time * time * gravity; }
};

/// Returns the time until a flying object meets a body in the current state, at most `duration` [s]; empty if it never
/// leaves the body where it starts.
std::optional<double> flight_time(const Flight& flight, double duration, const BodyCells& bodies) {
  constexpr double kStep = 0.03, kLongest = 2;  // [s]
  std::optional<double> outside;
  for (double time = 0; time < std::min(duration + kStep, kLongest); time += kStep) {
    const double reached = std::min(time, duration);
    if (!bodies.hold(flight.at(reached))) {
      outside = reached;
      continue;
    }
    if (!outside) continue;
    double inside = reached;
    for (int i = 0; i < 4; ++i) {
      const double middle = (*outside + inside) / 2;
      (bodies.hold(flight.at(middle)) ? inside : *outside) = middle;
    }
    return outside;
  }
  return outside ? std::optional(duration) : std::nullopt;
}

/// A crumb in flight.
struct Crumb {
  Flight flight;
  double age = 0, radius = 0;  ///< [s], [m]
  render::Rgb color;
};

/// Returns a size relative to the mean one: many are small and few are large, as in crushed rock (Pareto's law).
double graded_size(Chance& chance) { return std::min(0.45 * std::pow(1 - chance(), -0.45), 2.6); }

Crumb crumb_of(const Source& source, const Scene& scene, Chance& chance) {
  const double come_out = std::min(0.3 + source.age / 0.1, 1.0);
  const double size = std::min(source.crumbling->size * source.size, kLargestCrumb);
  Crumb crumb;
  crumb.age = source.age;
  crumb.radius = source.openness * come_out * size * graded_size(chance);
  crumb.flight = {source.place, throw_of(source, chance), scene.gravity};
  const float shade = static_cast<float>(0.85 + 0.25 * chance());
  const auto lit = [&](float channel) { return std::min(1.0f, shade * channel); };
  crumb.color = {lit(source.color.r), lit(source.color.g), lit(source.color.b)};
  return crumb;
}

/// Returns the time until a flight reaches the ground, at most `duration` [s].
double time_to_ground(const Flight& flight, double radius, double duration, const Scene& scene) {
  const double gravity = -scene.gravity.y();
  if (!scene.ground || gravity <= 0) return duration;
  return std::min(duration, fall_time(flight.start.y() - scene.ground->height - radius, flight.velocity.y(), gravity));
}

/// Returns the present place of a crumb: it flies until it meets a body, drops from there, and stays where it lands.
std::optional<render::Sphere> landed(const Crumb& crumb, const Scene& scene, const BodyCells& bodies) {
  const double until_ground = time_to_ground(crumb.flight, crumb.radius, crumb.age, scene);
  const std::optional<double> flown = flight_time(crumb.flight, until_ground, bodies);
  if (!flown) return std::nullopt;
  Vec3 place = crumb.flight.at(*flown);
  if (*flown < until_ground) {
    const Flight drop = {place, Vec3::Zero(), scene.gravity};
    const double left = time_to_ground(drop, crumb.radius, crumb.age - *flown, scene);
    place = drop.at(flight_time(drop, left, bodies).value_or(0));
  }
  if (scene.ground) place.y() = std::max(place.y(), scene.ground->height + crumb.radius);
  return render::Sphere{place.cast<float>(), static_cast<float>(crumb.radius), crumb.color, render::kNoId};
}

std::vector<render::Sphere> landed(const std::vector<Crumb>& crumbs, const Frame& frame, const Scene& scene,
                                   const HiddenBodies& hidden) {
  std::vector<render::Sphere> spheres;
  Eigen::AlignedBox3d region;
  for (const Crumb& crumb : crumbs)
    region.extend(crumb.flight.start).extend(crumb.flight.at(time_to_ground(crumb.flight, 0, crumb.age, scene)));
  if (region.isEmpty()) return spheres;
  const BodyCells bodies(frame, hidden, region);
  for (const Crumb& crumb : crumbs)
    if (const std::optional<render::Sphere> sphere = landed(crumb, scene, bodies)) spheres.push_back(*sphere);
  return spheres;
}

}  // namespace

CrackDust crack_dust(const Frame& frame, const Scene& scene, const HiddenBodies& hidden) {
  CrackDust dust;
  if (frame.crack_events.empty()) return dust;
  std::vector<Source> sources = sources_of(scene);
  std::vector<Crumb> crumbs;
  for (std::size_t i = frame.crack_events.size(); i-- > 0 && crumbs.size() < kMaxCrumbs;) {
    const CrackEvent& event = frame.crack_events[i];
    const int body = frame.bodies[event.body].scene_body;
    Source& source = sources[static_cast<std::size_t>(body)];
    if (!source.crumbling || hidden.contains(body)) continue;
    source.place = event.position;
    source.normal = event.normal;
    source.age = frame.time - event.time;
    source.size = element_size(frame, event);
    if (source.size == 0) continue;
    source.openness = openness_of(frame, event, source.size);
    if (source.openness == 0) continue;
    Chance chance(i);
    const bool is_dusty = source.crumbling->dust > 0 && source.age < kPuffTime && dust.puffs.size() < kMaxPuffs;
    if (is_dusty) dust.puffs.push_back(puff_of(source, chance));
    Chance of_crumbs(~static_cast<std::uint64_t>(i));
    for (int k = 0; k < source.crumbling->crumbs; ++k) crumbs.push_back(crumb_of(source, scene, of_crumbs));
  }
  dust.crumbs = landed(crumbs, frame, scene, hidden);
  return dust;
}

}  // namespace griffith::app
