#include "sim/world/setup/check_elements.h"

#include <optional>
#include <string>

#include "sim/core/error.h"
#include "sim/core/number_text.h"
#include "sim/mesh/mesh_layers.h"

namespace griffith {
namespace {

/// Feature that quadratic elements do not support.
struct Obstacle {
  const char* name;
  const char* remedy;
};

std::optional<Obstacle> obstacle_to_quadratic(const BodyDescription& body, const Material& material) {
  if (body.remeshing) return Obstacle{"remeshing", "use \"linear\", or turn remeshing off"};
  if (material.yield_strength) return Obstacle{"a yield strength", "use \"linear\", or a brittle material"};
  return std::nullopt;
}

}  // namespace

std::string text_of(const ElementChoice& choice) {
  const std::string name = choice.order == ElementOrder::quadratic ? "quadratic" : "linear";
  return choice.automatic ? name + ", since " + choice.reason : name;
}

void check_elements(const Scene& scene, int scene_body, ElementOrder order, const Material& material) {
  if (scene.bodies[scene_body].residual_stress && material.yield_strength)
    throw InputError("#/bodies/" + std::to_string(scene_body) + "/residual_stress", "is set for a material that yields",
                     "remove it or the material's yield_strength");
  if (order != ElementOrder::quadratic) return;
  if (const auto obstacle = obstacle_to_quadratic(scene.bodies[scene_body], material))
    throw InputError("#/bodies/" + std::to_string(scene_body) + "/elements",
                     std::string("are quadratic, which cannot be combined with ") + obstacle->name, obstacle->remedy);
}

ElementChoice choose_elements(const Scene& scene, int scene_body, const TetMesh& mesh) {
  constexpr int kEnough = 4;      // layers of linear elements that bend
  constexpr double kSlender = 8;  // from here on, bending decides what a body does
  constexpr double kSoft = 300;   // bar-wave speed below which impacts at 10 m/s strain a body by several percent [m/s]
  const BodyDescription& body = scene.bodies[scene_body];
  if (body.elements != ElementOrder::automatic) return {body.elements, false, 0, {}};
  ElementChoice choice{ElementOrder::linear, true, layers_across(mesh), {}};
  choice.reason = std::to_string(choice.layers) + (choice.layers == 1 ? " lies" : " lie") + " across its thinnest part";
  if (choice.layers >= kEnough) return choice;
  if (const double length = slenderness(mesh); length < kSlender) {
    choice.reason = "its length is only " + rounded_text(length, 2) + " times its mean thickness";
  } else if (const double speed = bar_wave_speed(body.material); speed < kSoft) {
    choice.reason = "waves cross its soft material at only " + rounded_text(speed, 2) + " m/s";
  } else if (const auto obstacle = obstacle_to_quadratic(body, body.material)) {
    choice.reason += std::string(", but quadratic ones cannot be combined with ") + obstacle->name;
  } else {
    choice.order = ElementOrder::quadratic;
  }
  return choice;
}

}  // namespace griffith
