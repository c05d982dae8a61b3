#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace griffith {

/// What made something, in words for people: names and values, such as {"compiler", "GCC 12.2.0"}.
using Versions = std::vector<std::pair<std::string, std::string>>;

/// This program, how it was built, its libraries, the processor and the operating system.
Versions versions_here();

/// The value of that name; empty where there is none.
std::string version_of(const Versions& versions, std::string_view name);

/// One JSON object of texts, and back. `where` names the text in errors. Throws InputError where it is none.
std::string versions_to_json(const Versions& versions);
Versions versions_from_json(std::string_view text, const std::string& where);

/// The rows of `here` in which the two differ, two lines each; empty where they are equal.
std::string version_differences(const Versions& there, const Versions& here);

}  // namespace griffith
