#include "app/study/parameter.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

#include "sim/core/error.h"
#include "sim/core/number_text.h"

namespace griffith::app {
namespace {

constexpr int kMaxCount = 100'000;

[[noreturn]] void refuse(const std::string& where, const std::string& text, const std::string& problem) {
  throw InputError(where, "\"" + text + "\" " + problem,
                   "write POINTER=1:10:5, POINTER=1e9:1e11:5log or POINTER=a,b,c");
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// Parses "5", "log" and "5log" into `range`; false for another text.
bool read_spacing(std::string text, ValueRange& range) {
  if (text.ends_with("log")) {
    range.logarithmic = true;
    text.resize(text.size() - 3);
    if (text.empty()) return true;
  }
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), range.count);
  return error == std::errc() && end == text.data() + text.size() && range.count >= 2 && range.count <= kMaxCount;
}

}  // namespace

std::vector<std::string> split_outside_brackets(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' && (i == 0 || text[i - 1] != '\\')) quoted = !quoted;
    if (!quoted) depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    if (c == separator && depth == 0 && !quoted) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

double ValueRange::at(double fraction) const {
  const double value = logarithmic ? low * std::pow(high / low, fraction) : std::lerp(low, high, fraction);
  return fraction <= 0 ? low : fraction >= 1 ? high : std::strtod(rounded_text(value, 12).c_str(), nullptr);
}

std::optional<ValueRange> read_range(const std::string& text, const std::string& where) {
  const std::vector<std::string> parts = split(text, ':');
  const std::optional<double> low = number_in(parts[0]);
  if (parts.size() < 2 || !low) return std::nullopt;
  const std::optional<double> high = number_in(parts[1]);
  ValueRange range{.low = *low, .high = high.value_or(0)};
  if (!high || parts.size() > 3) refuse(where, text, "is not a range");
  if (parts.size() == 3 && !read_spacing(parts[2], range))
    refuse(where, text, "does not end in a count of at least 2, \"log\" or both");
  if (!(range.low < range.high)) refuse(where, text, "is not ascending");
  if (range.logarithmic && range.low <= 0) refuse(where, text, "is logarithmic, but does not start above 0");
  return range;
}

Parameter read_parameter(const std::string& text, const std::string& where) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals + 1 == text.size()) refuse(where, text, "has no values");
  Parameter parameter;
  parameter.pointers = {scene_pointer(text.substr(0, equals), where)};
  parameter.name = parameter.pointers[0].substr(1);
  const std::string values = text.substr(equals + 1);
  parameter.range = read_range(values, where);
  if (!parameter.range) {
    for (const std::string& item : split_outside_brackets(values, ',')) {
      if (item.empty()) refuse(where, text, "has an empty value");
      parameter.values.push_back(setting_value(item));
    }
  } else {
    for (int i = 0; i < parameter.range->count; ++i)
      parameter.values.push_back(number_text(parameter.range->at(i / (parameter.range->count - 1.0))));
  }
  return parameter;
}

std::vector<SceneSetting> settings_of(const std::vector<Parameter>& parameters,
                                      const std::vector<std::string>& values) {
  std::vector<SceneSetting> settings;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (const std::string& pointer : parameters[i].pointers) settings.push_back({pointer, values[i]});
  return settings;
}

}  // namespace griffith::app
