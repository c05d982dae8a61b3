#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scene/scene_setting.h"

namespace griffith::app {

/// Numbers from `low` to `high`, both included.
struct ValueRange {
  double low = 0, high = 0;  ///< low < high; both > 0 where logarithmic
  int count = 0;             ///< >= 2, evenly spaced; 0: not given
  bool logarithmic = false;  ///< spaced evenly in the logarithm

  /// Returns the number at `fraction` (0..1), to twelve digits.
  double at(double fraction) const;
};

/// A field of a scene that varies between runs.
struct Parameter {
  std::string name;                   ///< "projectiles/0/speed", "seed"
  std::vector<std::string> pointers;  ///< fields that get its value
  std::vector<std::string> values;    ///< JSON texts; empty for a range without a count
  std::optional<ValueRange> range;    ///< range of the values, if given
};

/// Splits a text at separators outside of brackets, braces and quotes.
std::vector<std::string> split_outside_brackets(const std::string& text, char separator);

/// Parses "LOW:HIGH", "LOW:HIGH:COUNT" or "LOW:HIGH:COUNTlog"; empty for a text that does not begin as one. Throws
/// InputError, which names `where`, for one that continues otherwise.
std::optional<ValueRange> read_range(const std::string& text, const std::string& where);

/// Parses "POINTER=RANGE" or "POINTER=VALUE,VALUE,...", where a value is JSON or a bare word. Throws InputError, which
/// names `where`.
Parameter read_parameter(const std::string& text, const std::string& where);

/// Returns settings that give each parameter its value. `values`: as many as there are parameters.
std::vector<SceneSetting> settings_of(const std::vector<Parameter>& parameters, const std::vector<std::string>& values);

}  // namespace griffith::app
