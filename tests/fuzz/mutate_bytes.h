#pragma once

#include <string>
#include <vector>

#include "tests/fuzz/choice.h"

namespace griffith::fuzz {

/// Words that readers of numbers stumble over.
const std::vector<std::string>& extreme_words();

/// Damages a file in one to four places, regardless of its meaning: bits, ranges of bytes, binary numbers.
std::string mutate_bytes(std::string bytes, RandomValues& random);

/// Damages a text in one to four places: its words and lines are replaced, removed, repeated and exchanged.
std::string mutate_text(std::string text, RandomValues& random);

/// Either.
std::string mutate_file(std::string content, RandomValues& random);

}  // namespace griffith::fuzz
