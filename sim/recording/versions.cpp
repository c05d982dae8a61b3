#include "sim/recording/versions.h"

#include <gnu/libc-version.h>
#include <griffith/version.h>
#include <sys/utsname.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "sim/core/error.h"

namespace griffith {
namespace {

using Json = nlohmann::ordered_json;

#ifdef NDEBUG
constexpr char kAssertions[] = "off";
#else
constexpr char kAssertions[] = "on";
#endif

std::string compiler() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#else
  return "GCC " __VERSION__;
#endif
}

/// Returns the instruction sets that the compiler could use beyond those of every processor of the kind.
std::string instruction_set() {
  std::string names = GRIFFITH_ARCHITECTURE;
  if (names.empty()) names = "the compiler's default";
#ifdef __AVX512F__
  names += ", AVX-512";
#elif defined(__AVX2__)
  names += ", AVX2";
#elif defined(__SSE2__)
  names += ", SSE2";
#endif
  return names;
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (const auto colon = line.find(": "); line.starts_with("model name") && colon != std::string::npos)
      return line.substr(colon + 2);
  return "unknown";
}

std::string operating_system() {
  utsname names{};
  if (uname(&names) != 0) return "unknown";
  return std::string(names.sysname) + " " + names.release + " " + names.machine;
}

}  // namespace

Versions versions_here() {
  return {{"program", "griffith " GRIFFITH_VERSION},
          {"build type", GRIFFITH_BUILD_TYPE},
          {"assertions", kAssertions},
          {"instruction set", instruction_set()},
          {"compiler", compiler()},
          {"libraries", GRIFFITH_LIBRARIES},
          {"C library", std::string("glibc ") + gnu_get_libc_version()},
          {"processor", processor()},
          {"operating system", operating_system()}};
}

std::string version_of(const Versions& versions, std::string_view name) {
  const auto found = std::ranges::find(versions, name, [](const auto& row) { return std::string_view(row.first); });
  return found == versions.end() ? "" : found->second;
}

std::string versions_to_json(const Versions& versions) {
  Json json = Json::object();
  for (const auto& [name, value] : versions) json[name] = value;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Versions versions_from_json(std::string_view text, const std::string& where) {
  const Json json = Json::parse(text, nullptr, false);
  const auto is_text = [](const Json& value) { return value.is_string(); };
  if (!json.is_object() || !std::ranges::all_of(json, is_text))
    throw InputError(where, "is not an object of strings", "use an unchanged recording");
  Versions versions;
  for (const auto& [name, value] : json.items()) {
    std::string& shown = versions.emplace_back(name, value.get<std::string>()).second;
    std::ranges::replace_if(
        shown, [](unsigned char c) { return c < ' ' || c == 0x7f; }, '?');  // text from a stranger, for a terminal
  }
  return versions;
}

std::string version_differences(const Versions& there, const Versions& here) {
  std::string rows;
  for (const auto& [name, value] : here) {
    const std::string other = version_of(there, name);
    if (other == value) continue;
    char row[400];
    std::snprintf(row, sizeof row, "  %-18s%.150s\n  %-18s%.150s\n", name.c_str(), other.c_str(), "", value.c_str());
    rows += row;
  }
  return rows;
}

}  // namespace griffith
