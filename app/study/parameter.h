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
  int count = 0;             ///< >= 2, evenly spaced; 0: not said
  bool logarithmic = false;  ///< evenly spaced are the logarithms

  /// The number at `fraction` (0..1) of the way, to twelve digits.
  double at(double fraction) const;
};

/// Something about a scene that differs from run to run.
struct Parameter {
  std::string name;                   ///< "projectiles/0/speed", "seed"
  std::vector<std::string> pointers;  ///< of the fields that take its value
  std::vector<std::string> values;    ///< JSON texts; empty where there is a range without a count
  std::optional<ValueRange> range;    ///< that the values are from, where there is one
};

/// Parts a text at the separators outside of brackets, braces and quotes.
std::vector<std::string> split_outside_brackets(const std::string& text, char separator);

/// The JSON text of a number: the shortest that reads back as the same double.
std::string number_text(double value);

/// The finite number that all of `text` is; nothing for another text.
std::optional<double> number_in(std::string_view text);

/// The range in "LOW:HIGH", "LOW:HIGH:COUNT" or "LOW:HIGH:COUNTlog"; nothing for a text that does not begin as one.
/// Throws InputError, which names `where`, for one that goes on otherwise.
std::optional<ValueRange> read_range(const std::string& text, const std::string& where);

/// The parameter in "POINTER=RANGE" or "POINTER=VALUE,VALUE,...", where a value is JSON or a bare word. Throws
/// InputError, which names `where`.
Parameter read_parameter(const std::string& text, const std::string& where);

/// Settings that give each parameter its value. `values`: as many as there are parameters.
std::vector<SceneSetting> settings_of(const std::vector<Parameter>& parameters, const std::vector<std::string>& values);

}  // namespace griffith::app
