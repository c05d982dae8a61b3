#include "sim/world/setup/choose_elements.h"

#include <string>

#include "sim/core/number_text.h"
#include "sim/mesh/mesh_layers.h"

namespace griffith {

std::string text_of(const ElementChoice& choice) {
  const std::string name = choice.order == ElementOrder::quadratic ? "quadratic" : "linear";
  return choice.automatic ? name + ", since " + choice.reason : name;
}

ElementChoice choose_elements(const Scene& scene, int scene_body, const TetMesh& mesh) {
  constexpr int kEnough = 4;      // layers of linear elements that bend
  constexpr double kSlender = 8;  // from here on, bending decides what a body does
  constexpr double kSoft = 300;   // bar-wave speed below which impacts at 10 m/s strain a body by several percent [m/s]
  const BodyDescription& body = scene.bodies[scene_body];
  if (body.elements != ElementOrder::automatic) return {body.elements, false, 0, {}};
  ElementChoice choice{ElementOrder::linear, true, layers_across(mesh), {}};
  choice.reason = std::to_string(choice.layers) + (choice.layers == 1 ? " element lies" : " elements lie") +
                  " across its thinnest part";
  if (choice.layers >= kEnough) return choice;
  if (const double length = slenderness(mesh); length < kSlender) {
    choice.reason = "its length is only " + rounded_text(length, 2) + " times its mean thickness";
  } else if (const double speed = bar_wave_speed(body.material); speed < kSoft) {
    choice.reason = "waves cross its soft material at only " + rounded_text(speed, 2) + " m/s";
  } else {
    choice.order = ElementOrder::quadratic;
  }
  return choice;
}

}  // namespace griffith
