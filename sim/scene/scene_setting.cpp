#include "sim/scene/scene_setting.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "sim/core/error.h"
#include "sim/scene/json_document.h"

namespace griffith {

std::string scene_pointer(const std::string& text, const std::string& where) {
  std::string pointer = text.starts_with("#") ? text.substr(1) : text;
  if (!pointer.starts_with("/")) pointer.insert(0, "/");
  if (pointer.size() < 2 || pointer.find("//") != std::string::npos || pointer.ends_with("/"))
    throw InputError(where, "\"" + text + "\" is not a pointer to a field", "write it as bodies/0/material/density");
  return pointer;
}

namespace {

/// Returns the number that a word such as ".5", "5." or "+5" is, which JSON does not know.
std::optional<double> number_of(const std::string& word) {
  const char *begin = word.data() + word.starts_with('+'), *end = word.data() + word.size();
  double number = 0;
  const auto [stop, error] = std::from_chars(begin, end, number);
  return error == std::errc() && stop == end && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

}  // namespace

std::string setting_value(const std::string& word) {
  const Json value = Json::parse(word, nullptr, false);
  if (value.is_discarded()) {
    const std::optional<double> number = number_of(word);
    return (number ? Json(*number) : Json(word)).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  std::string line = word;  // line breaks between JSON's values are mere blanks
  std::ranges::replace_if(
      line, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return line;
}

std::string setting_word(const std::string& value) {
  const Json json = Json::parse(value, nullptr, false);
  if (!json.is_string()) return value;
  const auto& word = json.get_ref<const std::string&>();
  return setting_value(word) == value ? word : value;  // "5" stays a string
}

SceneSetting read_setting(const std::string& text, const std::string& where) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals + 1 == text.size())
    throw InputError(where, "\"" + text + "\" has no value", "write POINTER=VALUE, as projectiles/0/speed=30");
  return {scene_pointer(text.substr(0, equals), where), setting_value(text.substr(equals + 1))};
}

}  // namespace griffith
