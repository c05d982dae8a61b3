#include "sim/scene/apply_setting.h"

#include <charconv>
#include <nlohmann/json.hpp>

#include "sim/scene/field.h"

namespace griffith {
namespace {

std::string unescaped(std::string_view token) {
  std::string key;
  for (std::size_t i = 0; i < token.size(); ++i) {
    const bool escape = token[i] == '~' && i + 1 < token.size() && (token[i + 1] == '0' || token[i + 1] == '1');
    key += escape ? (token[++i] == '0' ? '~' : '/') : token[i];
  }
  return key;
}

[[noreturn]] void refuse_key(const Json& parent, const std::string& key, const std::string& place) {
  if (parent.is_array()) {
    const std::string items =
        parent.size() == 1 ? "has one item, 0" : "has items 0 to " + std::to_string(parent.size() - 1);
    throw InputError(place, "is not an item of the list", parent.empty() ? "the list is empty" : "the list " + items);
  }
  if (!parent.is_object()) throw InputError(place, "leads into a single value", "end the pointer before it");
  if (parent.empty())
    throw InputError(place, "lies in a part that the scene does not have", "set the whole part, as JSON");
  std::vector<std::string_view> known;
  for (const auto& [name, value] : parent.items()) known.push_back(name);
  throw InputError(place, "is not a known field", suggestion(key, known));
}

/// Returns the child of `parent`, or null.
template <class AnyJson>
AnyJson* child_of(AnyJson& parent, const std::string& key) {
  if (parent.is_object()) {
    const auto found = parent.find(key);
    return found == parent.end() ? nullptr : &*found;
  }
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), index);
  const bool good = parent.is_array() && error == std::errc() && end == key.data() + key.size();
  return good && index < parent.size() ? &parent[index] : nullptr;
}

/// Returns the keys of an RFC 6901 pointer.
std::vector<std::string> pointer_keys(std::string_view pointer) {
  std::vector<std::string> keys;
  while (!pointer.empty()) {
    const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
    keys.push_back(unescaped(pointer.substr(1, end - 1)));
    pointer.remove_prefix(end);
  }
  return keys;
}

}  // namespace

Json& value_at(Json& document, const Json& in_full, const std::string& pointer, const std::string& file) {
  Json* value = &document;
  const Json* full = &in_full;
  std::string place;
  for (const std::string& key : pointer_keys(pointer)) {
    if (!value->is_structured() && full && full->is_structured()) *value = *full;
    if (value->is_null()) *value = Json::object();  // optional part that the scene does not have yet
    const Json* full_child = full ? child_of(*full, key) : nullptr;
    if (full_child && value->is_object() && !value->contains(key)) (*value)[key] = *full_child;
    place = json_pointer(place, key);
    const bool new_part = full && full->is_null() && value->is_object();
    Json* child = new_part ? &(*value)[key] : child_of(*value, key);
    if (!child) refuse_key(full && full->is_object() ? *full : *value, key, json_place(file, place));
    value = child;
    full = full_child;
  }
  return *value;
}

void apply(const SceneSetting& setting, Json& document, const Json& in_full, const std::string& file) {
  Json value = Json::parse(setting.value, nullptr, false);
  if (value.is_discarded())
    throw InputError(json_place(file, setting.pointer), "is set to " + setting.value, "that is not JSON");
  value_at(document, in_full, setting.pointer, file) = std::move(value);
}

}  // namespace griffith
