#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/scene/scene.h"

namespace griffith {

/// A material that a scene body had from then on.
struct MaterialChange {
  int scene_body = 0;
  Material material;
  bool operator==(const MaterialChange&) const = default;
};

/// What was done to a world from outside, before the step after `step`.
struct WorldInput {
  std::int64_t step = 0;
  std::variant<ProjectileBurst, MaterialChange> action;
  bool operator==(const WorldInput&) const = default;
};

/// The inputs as JSON text. Reading it back gives the same, to the last bit of every number. Throws InputError when a
/// text is not UTF-8.
std::string inputs_to_json(const std::vector<WorldInput>& inputs);

/// Reads inputs from text. `where` names it in errors. Throws InputError with the first problem, also where steps do
/// not ascend.
std::vector<WorldInput> inputs_from_json(std::string_view text, const std::string& where);

}  // namespace griffith
