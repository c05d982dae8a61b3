#pragma once

// For the .cpp files of this folder alone: nothing else sees the JSON library.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/error.h"

namespace griffith {

/// Keeps the order of an object's fields.
using Json = nlohmann::ordered_json;

/// The document in `text`. Malformed text, numbers too large for a double, and nesting beyond any scene are reported at
/// file:line:column and end the reading (the result is then null); duplicate keys are reported at file#/pointer.
Json parse_json(std::string_view text, const std::string& file, std::vector<InputError>& problems);

/// `pointer` with `key` appended, escaped as RFC 6901 demands.
std::string json_pointer(std::string_view pointer, std::string_view key);
/// `file#/pointer`, or `file` for the document as a whole.
std::string json_place(const std::string& file, const std::string& pointer);

/// Indented text with what fits on a line on one line. Throws InputError when a string is not UTF-8.
std::string pretty_text(const Json& json);

}  // namespace griffith
