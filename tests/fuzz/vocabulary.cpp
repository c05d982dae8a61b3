#include "tests/fuzz/vocabulary.h"

#include "sim/core/read_file.h"

namespace griffith::fuzz {
namespace {

void visit(const Json& schema, const std::string& field, Vocabulary& words) {
  for (const char* key : {"minimum", "maximum", "default", "const"})
    if (schema.contains(key)) words.values[field].push_back(schema[key]);
  for (const Json& value : schema.value("enum", Json::array())) words.values[field].push_back(value);
  const Json properties = schema.value("properties", Json::object());
  for (const auto& [name, property] : properties.items()) {
    words.fields[field].push_back(name);
    visit(property, name, words);
  }
  for (const char* key : {"anyOf", "oneOf", "allOf"})
    for (const Json& option : schema.value(key, Json::array())) visit(option, field, words);
  for (const char* key : {"items", "additionalProperties"})
    if (schema.contains(key) && schema[key].is_object()) visit(schema[key], field, words);
}

}  // namespace

Vocabulary scene_vocabulary() {
  Vocabulary words;
  visit(Json::parse(read_file(GRIFFITH_SOURCE_DIR "/scenes/scene.schema.json")), "", words);
  return words;
}

void erase_at(Json& structure, std::size_t index) {
  if (structure.is_array()) return structure.erase(index);
  auto& fields = structure.get_ref<Json::object_t&>();
  fields.erase(fields.begin() + static_cast<std::ptrdiff_t>(index));
}

}  // namespace griffith::fuzz
