#pragma once

// For the .cpp files of this folder alone: nothing else sees the JSON library.

#include <nlohmann/json.hpp>
#include <optional>

#include "sim/scene/field.h"
#include "sim/scene/json_document.h"
#include "sim/scene/scene.h"

namespace griffith {

// The JSON of a plain value, as the writer and the schema's defaults show it.

inline Json value_json(bool value, Flag) { return value; }
inline Json value_json(int value, const Numbers&) { return value; }
inline Json value_json(double value, const Numbers&) { return number_json(value); }
inline Json value_json(const Vec2& vector, const Numbers&) { return vector_json(vector); }
inline Json value_json(const Vec3& vector, const Numbers& numbers) {
  const bool one_number = numbers.uniform && vector == Vec3::Constant(vector.x());
  return one_number ? number_json(vector.x()) : vector_json(vector);
}
inline Json value_json(const std::vector<int>& values, const Numbers&) { return values; }
inline Json value_json(const std::string& value, const Text&) { return value; }
inline Json value_json(const std::string& value, const OneOf&) { return value; }
inline Json value_json(const std::filesystem::path& path, MeshPath) { return path.generic_string(); }
template <class Enum>
requires std::is_enum_v<Enum> Json value_json(Enum value, const OneOf& one_of) {
  return one_of.names.at(static_cast<std::size_t>(value));
}

}  // namespace griffith
