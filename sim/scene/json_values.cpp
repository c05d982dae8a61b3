#include "sim/scene/json_values.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace griffith {

Json number_json(double value) {
  constexpr double kLargest = 1e15;
  const bool whole = std::abs(value) < kLargest && value == std::trunc(value) && !(value == 0 && std::signbit(value));
  return whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

Json value_json(bool value, Flag) { return value; }

Json value_json(int value, const Numbers&) { return value; }

Json value_json(std::int64_t value, const Numbers&) { return value; }

Json value_json(double value, const Numbers&) { return number_json(value); }

Json value_json(const Vec2& vector, const Numbers& numbers) {
  if (numbers.uniform && vector == Vec2::Constant(vector.x())) return number_json(vector.x());
  return {number_json(vector.x()), number_json(vector.y())};
}

Json value_json(const Vec3& vector, const Numbers& numbers) {
  if (numbers.uniform && vector == Vec3::Constant(vector.x())) return number_json(vector.x());
  return {number_json(vector.x()), number_json(vector.y()), number_json(vector.z())};
}

Json value_json(const std::vector<int>& values, const Numbers&) { return values; }

Json value_json(const std::vector<Vec3>& values, const Numbers& numbers) {
  Json array = Json::array();
  for (const Vec3& value : values) array.push_back(value_json(value, numbers));
  return array;
}

Json value_json(const std::string& value, const Text&) { return value; }

Json value_json(const std::string& value, const OneOf&) { return value; }

Json value_json(const std::vector<std::string>& values, const OneOf&) { return values; }

Json value_json(const std::filesystem::path& path, MeshPath) { return path.generic_string(); }

}  // namespace griffith
