#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace griffith::fuzz {

using Json = nlohmann::ordered_json;

/// Values of scenes by the name of their field. Taken from the schema, so that new fields are included automatically.
struct Vocabulary {
  std::map<std::string, std::vector<Json>> values;         ///< names to choose from, both ends of ranges, defaults
  std::map<std::string, std::vector<std::string>> fields;  ///< fields of the object that the field holds
};

Vocabulary scene_vocabulary();

/// Takes the value of a number out of an object or array.
void erase_at(Json& structure, std::size_t index);

}  // namespace griffith::fuzz
