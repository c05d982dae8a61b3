#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace griffith {

/// Versions as names and values for readers, such as {"compiler", "GCC 12.2.0"}.
using Versions = std::vector<std::pair<std::string, std::string>>;

/// Returns the versions of program, build, libraries, processor and operating system.
Versions versions_here();

/// Returns the value of a name; empty if there is none.
std::string version_of(const Versions& versions, std::string_view name);

/// Converts to a JSON object of strings, and back. `where` names the text in errors. Throws InputError for any other
/// JSON.
std::string versions_to_json(const Versions& versions);
Versions versions_from_json(std::string_view text, const std::string& where);

/// Returns the rows of `here` in which the two differ, in two lines each. Empty if they are equal.
std::string version_differences(const Versions& there, const Versions& here);

}  // namespace griffith
