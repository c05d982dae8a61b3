#pragma once

// For the .cpp files of this folder only, so that the JSON library stays hidden.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/error.h"

namespace griffith {

/// JSON with the order of an object's fields kept.
using Json = nlohmann::ordered_json;

/// Returns the document in `text`. Malformed text, numbers too large for a double, and excessive nesting are reported
/// at file:line:column and end the reading (the result is then null). Duplicate keys are reported at file#/pointer.
Json parse_json(std::string_view text, const std::string& file, std::vector<InputError>& problems);

/// Returns `pointer` with `key` appended, escaped according to RFC 6901.
std::string json_pointer(std::string_view pointer, std::string_view key);
/// Returns `file#/pointer`, or `file` for the document as a whole.
std::string json_place(const std::string& file, const std::string& pointer);

/// Returns indented text, with short values on one line. Throws InputError if a string is not UTF-8.
std::string pretty_text(const Json& json);

}  // namespace griffith
