#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace griffith {

// What values a field of a scene takes. scene_fields.h gives one of these to every field; the reader, the writer, the
// schema and the tests all follow it.

/// A number, or the components of a vector, in SI units.
struct Numbers {
  double minimum = 0, maximum = 0;  ///< both allowed
  std::string_view unit;            ///< "m/s"; "-" for a ratio, "" for a count
  bool nonzero = false;             ///< of a vector: not all components are 0
  bool ascending = false;           ///< of a pair: the first is less than the second
  bool uniform = false;             ///< of a vector: one number may stand for all components
};

constexpr Numbers between(double minimum, double maximum, std::string_view unit = "") {
  return {.minimum = minimum, .maximum = maximum, .unit = unit};
}

/// Any text of at least `minimum_length` bytes.
struct Text {
  int minimum_length = 0;
};

/// A name that older files have, and what is written today.
struct RenamedValue {
  std::string_view old_name, name;
};

/// One of some names; for an enumeration `names[i]` belongs to the value i. Older names are read too, and noticed.
struct OneOf {
  std::vector<std::string_view> names;
  std::vector<RenamedValue> renamed = {};
};

/// true or false.
struct Flag {};

/// The file or folder of a mesh (or what else it names), which has to exist.
struct MeshPath {
  std::string_view what = "mesh";
};

/// A material: the name of a preset or of one of the scene's materials, or its properties.
struct MaterialChoice {};

/// An object (or a list of objects) whose fields a describe() function lists.
struct Parts {};

/// "from 0 to 1", "from 1 to 1e+13 Pa".
std::string range_text(const Numbers& numbers);

/// "\"a\", \"b\"": names as an error message lists them.
std::string quoted_list(std::span<const std::string_view> names);

/// What to write instead of the unknown `name`: the known name that is spelled most alike, or all of them.
std::string suggestion(std::string_view name, std::span<const std::string_view> known);

}  // namespace griffith
