#include "tests/scene/scene_schema.h"

#include <nlohmann/json.hpp>

#include "sim/scene/json_values.h"
#include "sim/scene/scene_fields.h"

namespace griffith {
namespace {

template <class T>
requires(!kIsOptional<T>) Json schema_of(const T& value, Parts);
template <class T>
Json schema_of(const std::vector<T>& items, Parts);
template <class T, class Values>
Json schema_of(const std::optional<T>& value, const Values& values);
Json schema_of(const Material& material, MaterialChoice);

// --- Plain values ---------------------------------------------------------------------------------------------------

Json schema_of(bool, Flag) { return {{"type", "boolean"}}; }

Json number_schema(const char* type, const Numbers& numbers) {
  return {{"type", type}, {"minimum", number_json(numbers.minimum)}, {"maximum", number_json(numbers.maximum)}};
}
Json schema_of(double, const Numbers& numbers) { return number_schema("number", numbers); }
Json schema_of(int, const Numbers& numbers) { return number_schema("integer", numbers); }
Json schema_of(const std::vector<int>&, const Numbers& numbers) {
  return {{"type", "array"}, {"items", number_schema("integer", numbers)}};
}
template <int N, int Options>
Json schema_of(const Eigen::Matrix<double, N, 1, Options>&, const Numbers& numbers) {
  Json schema = {{"type", "array"}, {"items", number_schema("number", numbers)}, {"minItems", N}, {"maxItems", N}};
  if (numbers.nonzero) schema["not"] = {{"const", std::vector<int>(N, 0)}};
  if (numbers.uniform) return {{"anyOf", {number_schema("number", numbers), std::move(schema)}}};
  return schema;
}

Json schema_of(const std::vector<Vec3>&, const Numbers& numbers) {
  return {{"type", "array"}, {"items", schema_of(Vec3(Vec3::Zero()), numbers)}};
}

Json text_schema(int minimum_length) {
  Json schema = {{"type", "string"}};
  if (minimum_length > 0) schema["minLength"] = minimum_length;
  return schema;
}
Json schema_of(const std::string&, const Text& text) { return text_schema(text.minimum_length); }
Json schema_of(const std::filesystem::path&, MeshPath) { return text_schema(1); }

template <class T>
Json schema_of(const T&, const OneOf& one_of) {
  return {{"enum", one_of.names}};
}

template <class T>
Json schema_of(const std::vector<T>&, const OneOf& one_of) {
  return {{"type", "array"}, {"items", {{"enum", one_of.names}}}};
}

template <class T, class Values>
Json schema_of(const std::optional<T>&, const Values& values) {
  return {{"anyOf", {schema_of(T{}, values), Json{{"type", "null"}}}}};
}

// --- Objects --------------------------------------------------------------------------------------------------------

std::string unit_of(const Numbers& numbers) { return numbers.unit == "-" ? "" : std::string(numbers.unit); }
template <class Values>
std::string unit_of(const Values&) {
  return "";
}

template <class T, class Values>
Json default_of(const T& value, const Values& values) {
  return value_json(value, values);
}
template <class T>
Json default_of(const std::optional<T>& value, const Numbers& numbers) {
  return value ? value_json(*value, numbers) : Json();
}
/// Returns no default, since an object's defaults are at its fields.
template <class T>
Json default_of(const T&, Parts) {
  return Json::object();
}
template <class T>
Json default_of(const std::optional<T>& value, Parts) {
  return value ? Json::object() : Json();
}
template <class T>
Json default_of(const std::vector<T>&, Parts) {
  return Json::array();
}
Json default_of(const Shape&, Parts) { return {{"box", Json::object()}}; }
Json default_of(const Region&, Parts) { return {{"box", Json::object()}}; }
Json default_of(const ProbePlace&, Parts) { return {{"point", {0, 0, 0}}}; }
Json default_of(const Material&, MaterialChoice) { return "brick"; }

/// Archive that makes an object's schema from a value with its defaults.
class ObjectSchema {
 public:
  template <class T, class Values>
  void field(std::string_view name, const T& member, const Values& values, std::string_view description) {
    Json& property = add(name, member, values, description);
    if constexpr (std::is_same_v<Values, MeshPath>) {
      schema["required"] = {name};
    } else {
      property["default"] = default_of(member, values);
    }
  }

  template <class T, class Variant, class Values, class Projection = std::identity>
  void alternative(std::string_view name, const Variant&, const Values& values, std::string_view description,
                   Projection projection = {}) {
    const T value{};
    add(name, std::invoke(projection, value), values, description);
    schema["minProperties"] = schema["maxProperties"] = 1;
  }

  void require(bool, std::string_view, const char*, const char*) {}

  Json schema = {{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};

  template <class T, class Values>
  Json& add(std::string_view name, const T& member, const Values& values, std::string_view description) {
    const std::string unit = unit_of(values);
    Json& property = schema["properties"][std::string(name)];
    property["description"] = std::string(description) + (unit.empty() ? "" : " [" + unit + "]");
    property.update(schema_of(member, values));
    return property;
  }
};

template <class T>
requires(!kIsOptional<T>) Json schema_of(const T&, Parts) {
  ObjectSchema archive;
  T defaults{};
  describe(archive, defaults);
  return archive.schema;
}

template <class T>
Json schema_of(const std::vector<T>&, Parts parts) {
  return {{"type", "array"}, {"items", schema_of(T{}, parts)}};
}

// --- Materials and the document -------------------------------------------------------------------------------------

Json preset_keys() {
  Json keys = Json::array();
  for (const MaterialPreset& preset : material_presets()) keys.push_back(preset.key);
  return keys;
}

Json preset_schema() {
  return {{"description", "The material whose properties hold where this object has none of its own"},
          {"enum", preset_keys()}};
}

Json schema_of(const Material&, MaterialChoice) {
  ObjectSchema archive;
  archive.schema["properties"]["preset"] = preset_schema();
  Material defaults;
  describe(archive, defaults);
  Json name_schema = text_schema(1);
  name_schema["examples"] = preset_keys();
  return {{"anyOf", {std::move(name_schema), archive.schema}}};
}

Json materials_schema() {
  ObjectSchema archive;
  archive.schema["properties"]["preset"] = preset_schema();
  Material defaults;
  describe_properties(archive, defaults);
  return {{"description", "The scene's own materials by name, for its bodies to use"},
          {"type", "object"},
          {"propertyNames", {{"minLength", 1}, {"not", {{"enum", preset_keys()}}}}},
          {"additionalProperties", archive.schema},
          {"default", Json::object()}};
}

}  // namespace

std::string scene_schema() {
  ObjectSchema archive;
  archive.schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                    {"title", "Griffith scene"},
                    {"description", "SI units; y is up. What a file leaves out has the default that stands here."},
                    {"type", "object"},
                    {"required", {"version"}},
                    {"properties", Json::object()},
                    {"additionalProperties", false}};
  Json& properties = archive.schema["properties"];
  properties["$schema"] = {{"description", "Path of this schema, for editors"}, {"type", "string"}};
  properties["version"] = {{"description", "Version of the format"}, {"const", kSceneVersion}};
  properties["materials"] = materials_schema();
  Scene defaults;
  describe(archive, defaults);
  return pretty_text(archive.schema);
}

}  // namespace griffith
