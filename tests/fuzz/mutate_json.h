#pragma once

#include <string>

#include "tests/fuzz/choice.h"
#include "tests/fuzz/vocabulary.h"

namespace griffith::fuzz {

/// The text of `scene` after some changes to its values: numbers nudged or made extreme, names exchanged, fields added,
/// removed, repeated or of another type, parts taken from the scene `donor`, all lengths scaled. Some texts are no
/// JSON.
std::string mutate_scene(Json scene, const Json& donor, const Vocabulary& words, RandomValues& random);

}  // namespace griffith::fuzz
