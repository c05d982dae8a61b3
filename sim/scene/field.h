#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace griffith {

// Permitted values of a scene's fields. scene_fields.h assigns one to every field. Reader, writer, schema and tests
// follow from it.

/// Number, or the components of a vector, in SI units.
struct Numbers {
  double minimum = 0, maximum = 0;  ///< both included
  std::string_view unit;            ///< "m/s"; "-" for a ratio, "" for a count
  bool nonzero = false;             ///< vector: not all components are 0
  bool ascending = false;           ///< pair: the first is less than the second
  bool uniform = false;             ///< vector: one number may stand for all components
};

constexpr Numbers between(double minimum, double maximum, std::string_view unit = "") {
  return {.minimum = minimum, .maximum = maximum, .unit = unit};
}

inline constexpr Numbers kPlace = between(-1e6, 1e6, "m");
inline constexpr Numbers kDirection = {.minimum = -1e6, .maximum = 1e6, .unit = "-", .nonzero = true};

/// Text of at least `minimum_length` bytes.
struct Text {
  int minimum_length = 0;
};

/// Old name of a value in older files, and its present name.
struct RenamedValue {
  std::string_view old_name, name;
};

/// One of several names. For an enumeration `names[i]` is the name of value i. Older names are read too, and noted.
struct OneOf {
  std::vector<std::string_view> names;
  std::vector<RenamedValue> renamed = {};
};

/// True or false.
struct Flag {};

/// File or folder of a mesh (or of `what`), which must exist.
struct MeshPath {
  std::string_view what = "mesh";
};

/// Material: the name of a preset or of one of the scene's materials, or its properties.
struct MaterialChoice {};

/// Object (or list of objects) whose fields a describe() function lists.
struct Parts {};

/// Returns "from 0 to 1" or "from 1 to 1e+13 Pa".
std::string range_text(const Numbers& numbers);

/// Returns "\"a\", \"b\"": names as listed in error messages.
std::string quoted_list(std::span<const std::string_view> names);

/// Returns a replacement for the unknown `name`: the most similar known name, or all of them.
std::string suggestion(std::string_view name, std::span<const std::string_view> known);

}  // namespace griffith
