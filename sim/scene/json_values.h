#pragma once

// For the .cpp files of this folder only, so that the JSON library stays hidden.

#include <cstdint>
#include <filesystem>
#include <type_traits>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "sim/scene/field.h"
#include "sim/scene/json_document.h"

namespace griffith {

// JSON of plain values, for the writer and the schema's defaults.
Json value_json(bool value, Flag);
Json value_json(int value, const Numbers& numbers);
Json value_json(std::int64_t value, const Numbers& numbers);
Json value_json(double value, const Numbers& numbers);
Json value_json(const Vec2& vector, const Numbers& numbers);
Json value_json(const Vec3& vector, const Numbers& numbers);
Json value_json(const std::vector<int>& values, const Numbers& numbers);
Json value_json(const std::vector<Vec3>& values, const Numbers& numbers);
Json value_json(const std::string& value, const Text& text);
Json value_json(const std::string& value, const OneOf& one_of);
Json value_json(const std::vector<std::string>& values, const OneOf& one_of);
Json value_json(const std::filesystem::path& path, MeshPath);
/// The result's type is a parameter because it is complete only where the JSON library is included.
template <class Enum, class Result = Json>
requires std::is_enum_v<Enum> Result value_json(Enum value, const OneOf& one_of) {
  return Result(one_of.names.at(static_cast<std::size_t>(value)));
}
template <class Enum, class Result = Json>
requires std::is_enum_v<Enum> Result value_json(const std::vector<Enum>& values, const OneOf& one_of) {
  Result array = Result::array();
  for (const Enum value : values) array.push_back(value_json(value, one_of));
  return array;
}

/// Returns a whole number without a decimal point if that is exact, else the shortest text that reads back as this
/// double.
Json number_json(double value);

}  // namespace griffith
