#include "app/picture/natural_materials.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "sim/scene/body_pose.h"

namespace griffith::app {
namespace {

/// Mirroring of the outside, as EmbeddedMaterial; metals have it on fracture surfaces too, dull.
struct Finish {
  float gloss = 0, blur = 1, metal = 0;
};

/// Colors of the outside and of fracture surfaces, and their variation. A body of one piece has pieces of equal
/// brightness, so that the picture does not reveal where it will break. Clear materials have one color: the attenuation
/// between two faces must not depend on the faces.
struct NaturalLook {
  std::string_view preset;
  render::Rgb outside, inside;
  float variation, mottle, roughness;  ///< as EmbeddedMaterial
  float clear_depth = 0;               ///< as EmbeddedMaterial
  render::Grain grain = render::Grain::none;
  float grain_size = 0.02f;  ///< as EmbeddedMaterial
  Finish finish = {};
};

constexpr render::Rgb kMortar = {0.72f, 0.70f, 0.66f};
using enum render::Grain;

/// Returns the look of wood, whatever the direction of its load.
constexpr NaturalLook wood(std::string_view preset) {
  return {preset, {0.62f, 0.44f, 0.27f}, {0.80f, 0.63f, 0.42f}, 0.06f, 0.30f, 0.30f, 0, rings, 0.012f, {0.6f, 0.4f, 0}};
}

constexpr NaturalLook kLookTable[] = {
    {"soda_lime_glass", {0.62f, 0.81f, 0.82f}, {0.62f, 0.81f, 0.82f}, 0, 0.02f, 0.06f, 0.06f},
    {"concrete", {0.66f, 0.65f, 0.63f}, {0.57f, 0.56f, 0.54f}, 0, 0.20f, 0.35f, 0, stones, 0.04f},
    {"brick", {0.55f, 0.35f, 0.28f}, {0.62f, 0.41f, 0.33f}, 0.12f, 0.15f, 0.40f, 0, clay, 0.02f},
    {"porcelain", {0.93f, 0.93f, 0.91f}, {0.86f, 0.82f, 0.75f}, 0, 0.02f, 0.15f, 0, sand, 0.006f, {1, 0.05f, 0}},
    {"alumina", {0.92f, 0.90f, 0.85f}, {0.86f, 0.84f, 0.80f}, 0, 0.03f, 0.15f, 0, facets, 0.004f, {0.5f, 0.2f, 0}},
    {"ice", {0.80f, 0.90f, 0.96f}, {0.80f, 0.90f, 0.96f}, 0, 0.05f, 0.25f, 0.25f},
    {"granite", {0.53f, 0.52f, 0.53f}, {0.47f, 0.46f, 0.47f}, 0, 0.25f, 0.40f, 0, crystals, 0.012f, {0.5f, 0.3f, 0}},
    {"marble", {0.87f, 0.86f, 0.84f}, {0.85f, 0.84f, 0.83f}, 0, 0.05f, 0.30f, 0, veins, 0.035f, {0.8f, 0.12f, 0}},
    {"plaster", {0.90f, 0.88f, 0.84f}, {0.93f, 0.91f, 0.87f}, 0, 0.03f, 0.40f, 0, sand, 0.005f},
    wood("wood_along_grain"),
    wood("wood_across_grain"),
    {"abs", {0.25f, 0.26f, 0.28f}, {0.42f, 0.43f, 0.45f}, 0, 0.02f, 0.10f, 0, none, 0.02f, {0.8f, 0.25f, 0}},
    {"acrylic", {0.78f, 0.86f, 0.90f}, {0.78f, 0.86f, 0.90f}, 0, 0.02f, 0.10f, 0.3f},
    {"grey_cast_iron",
     {0.36f, 0.37f, 0.39f},
     {0.48f, 0.48f, 0.48f},
     0,
     0.10f,
     0.35f,
     0,
     facets,
     0.006f,
     {1, 0.5f, 0.8f}},
    {"mild_steel", {0.66f, 0.67f, 0.69f}, {0.70f, 0.71f, 0.72f}, 0, 0.05f, 0.20f, 0, facets, 0.004f, {1, 0.35f, 1}},
    {"rubber", {0.17f, 0.17f, 0.18f}, {0.23f, 0.22f, 0.22f}, 0, 0.05f, 0.15f, 0, none, 0.02f, {0.6f, 0.5f, 0}},
    {"jelly", {0.76f, 0.25f, 0.32f}, {0.83f, 0.36f, 0.42f}, 0, 0.03f, 0.05f, 0, none, 0.02f, {1, 0.05f, 0}},
};

/// Words in names of materials with the preset of that appearance.
constexpr std::pair<std::string_view, std::string_view> kWords[] = {{"glass", "soda_lime_glass"},
                                                                    {"concrete", "concrete"},
                                                                    {"cement", "concrete"},
                                                                    {"brick", "brick"},
                                                                    {"terracotta", "brick"},
                                                                    {"earthenware", "brick"},
                                                                    {"porcelain", "porcelain"},
                                                                    {"alumina", "alumina"},
                                                                    {"ice", "ice"},
                                                                    {"granite", "granite"},
                                                                    {"marble", "marble"},
                                                                    {"plaster", "plaster"},
                                                                    {"gypsum", "plaster"},
                                                                    {"acrylic", "acrylic"},
                                                                    {"wood", "wood_along_grain"},
                                                                    {"iron", "grey_cast_iron"},
                                                                    {"steel", "mild_steel"},
                                                                    {"rubber", "rubber"},
                                                                    {"jelly", "jelly"}};

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// True if a word of a name begins with `beginning`: "brickwork" begins with "brick". Both in lower case.
bool has_word(std::string_view name, std::string_view beginning) {
  for (std::size_t at = name.find(beginning); at != std::string_view::npos; at = name.find(beginning, at + 1))
    if (at == 0 || name[at - 1] < 'a' || name[at - 1] > 'z') return true;
  return false;
}

/// Returns the look named by a material, as "soft porcelain"; null if there is none.
const NaturalLook* named_look(const std::string& name) {
  for (const auto& [word, preset] : kWords)
    if (has_word(lower_case(name), word)) return std::ranges::find(kLookTable, preset, &NaturalLook::preset);
  return nullptr;
}

/// Returns the look by name, else that of the nearest density and Poisson's ratio, which users rarely change; stiffness
/// decides between equal ones.
const NaturalLook& look_of(const Material& material) {
  if (const NaturalLook* named = named_look(material.name)) return *named;
  const NaturalLook* best = &kLookTable[0];
  double minimum = std::numeric_limits<double>::infinity();
  for (const NaturalLook& look : kLookTable) {
    const std::optional<Material> preset = find_material_preset(look.preset);
    if (!preset) continue;
    const double distance = 8 * std::abs(std::log(preset->density / material.density)) +
                            20 * std::abs(preset->poisson_ratio - material.poisson_ratio) +
                            0.1 * std::abs(std::log(preset->young_modulus / material.young_modulus));
    if (distance < minimum) minimum = distance, best = &look;
  }
  return *best;
}

/// Returns the fiber direction of wood without splinters, with about the length of its shards.
Eigen::Vector3f fiber_of(const BodyDescription& body) {
  constexpr double kStretch = 13;
  if (!body.weakness || body.weakness->kind != WeaknessKind::grain) return Eigen::Vector3f::Zero();
  const Vec3 along = pose_of(body).rotation * body.weakness->direction.normalized();
  return (std::sqrt(1 - 1 / kStretch) * along).cast<float>();
}

/// Scales the noise with the splinters and aligns it with their grain.
void fit_to_splinters(render::EmbeddedMaterial& material, const SplinterPattern& pattern) {
  if (const auto* shards = std::get_if<VoronoiSplinters>(&pattern)) {
    const double stretch = 4 * shards->elongation - 3;
    material.noise_size = static_cast<float>(0.2 * shards->size);
    material.fiber = (std::sqrt(1 - 1 / stretch) * shards->grain.normalized()).cast<float>();
  } else if (const auto* bricks = std::get_if<BrickSplinters>(&pattern)) {
    material.noise_size = static_cast<float>(0.15 * bricks->size.minCoeff());
  } else if (const auto* rings = std::get_if<RadialSplinters>(&pattern)) {
    material.noise_size = static_cast<float>(0.2 * rings->first_ring);
  }
}

/// True if a body without a pattern of its own is drawn with bricks and mortar.
bool is_masonry(const BodyDescription& body) {
  return !body.splinters && has_word(lower_case(body.material.name), "brickwork");
}

/// Returns the grain: those of stone and masonry are visible on dressed faces too, those of other materials on fracture
/// surfaces alone.
render::Grain grain_of(const BodyDescription& body, const NaturalLook& natural, Look look) {
  if (look == Look::mortar) return sand;
  if (is_masonry(body)) return bricks;
  if (look == Look::inside || natural.grain == crystals || natural.grain == veins) return natural.grain;
  return natural.grain == stones ? cast : none;
}

/// Gives each of several bodies a tone of its own, so that their joints are seen.
render::Rgb toned(const render::Rgb& color, std::size_t body, std::size_t bodies) {
  constexpr float kTones[] = {1, 0.90f, 1.06f, 0.94f, 1.03f, 0.87f, 0.97f};
  const float tone = bodies > 1 ? kTones[body % std::size(kTones)] : 1;
  return {tone * color.r, tone * color.g, tone * color.b};
}

/// Sets what a face mirrors: broken faces are dull, and only metals gleam there.
void polish(render::EmbeddedMaterial& material, const Finish& finish, Look look) {
  if (look == Look::mortar) return;
  const bool outside = look == Look::outside;
  material.gloss = outside || finish.metal > 0 ? finish.gloss : 0;
  material.blur = outside ? finish.blur : 0.6f;
  material.metal = finish.metal;
}

/// Returns the factor on the roughness of a look: panes are nearly flat, so that edges of lamps in them are even.
float smoothing(const NaturalLook& natural, Look look) {
  if (look != Look::outside) return 1;
  return natural.clear_depth > 0 ? 0.02f : 0.25f;
}

render::EmbeddedMaterial material_of(const BodyDescription& body, const NaturalLook& natural, Look look) {
  constexpr float kBrickLength = 0.25f;  // with a joint [m]
  render::EmbeddedMaterial material;
  material.color = look == Look::mortar ? kMortar : look == Look::inside ? natural.inside : natural.outside;
  material.variation = look == Look::mortar || !body.splinters ? 0 : natural.variation;
  material.clear_depth = natural.clear_depth;
  material.grain = grain_of(body, natural, look);
  material.dressed = look == Look::outside && material.grain != none;
  material.grain_size = material.grain == bricks ? kBrickLength : natural.grain_size;
  material.mottle = natural.mottle;
  material.roughness = natural.roughness * smoothing(natural, look);
  material.fiber = fiber_of(body);
  polish(material, natural.finish, look);
  if (body.splinters) fit_to_splinters(material, *body.splinters);
  return material;
}

}  // namespace

Look look_of(const SplinterFace& face) {
  if (face.matter == SplinterMatter::mortar) return Look::mortar;
  return face.beyond >= 0 ? Look::inside : Look::outside;
}

std::string_view preset_alike(const Material& material) { return look_of(material).preset; }

std::vector<render::EmbeddedMaterial> natural_materials(const Scene& scene) {
  std::vector<render::EmbeddedMaterial> materials;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const NaturalLook& natural = look_of(scene.bodies[i].material);
    for (const Look look : {Look::outside, Look::inside, Look::mortar}) {
      materials.push_back(material_of(scene.bodies[i], natural, look));
      if (natural.clear_depth == 0) materials.back().color = toned(materials.back().color, i, scene.bodies.size());
    }
  }
  return materials;
}

}  // namespace griffith::app
