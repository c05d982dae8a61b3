#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/scene/grab.h"
#include "sim/scene/push.h"
#include "sim/scene/scene.h"

namespace griffith {

/// New material of a scene body.
struct MaterialChange {
  int scene_body = 0;
  Material material;
  bool operator==(const MaterialChange&) const = default;
};

/// Input to a world from outside, before the step after `step`.
struct WorldInput {
  std::int64_t step = 0;
  std::variant<ProjectileBurst, MaterialChange, Grab, GrabMove, GrabRelease, Push> action;
  bool operator==(const WorldInput&) const = default;
};

/// Returns the inputs as JSON text. Reading it back gives the same, to the last bit of every number. Throws InputError
/// if a text is not UTF-8.
std::string inputs_to_json(const std::vector<WorldInput>& inputs);

/// Reads inputs from text. `where` names it in errors. Throws InputError with the first problem, also if steps are not
/// ascending.
std::vector<WorldInput> inputs_from_json(std::string_view text, const std::string& where);

}  // namespace griffith
