#pragma once

// For the .cpp files of this folder only, so that the JSON library stays hidden.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/linear_algebra.h"
#include "sim/elasticity/material.h"
#include "sim/scene/field.h"
#include "sim/scene/json_document.h"

namespace griffith {

/// Shared state of reading a document.
struct Document {
  std::string file;              ///< name of the file in errors
  std::filesystem::path folder;  ///< start of relative mesh paths
  bool look_for_meshes = true;
  std::map<std::string, Material, std::less<>> materials;  ///< materials of the scene, by name
  std::vector<InputError> problems;
  std::vector<InputError> outdated;  ///< old names that were read
};

/// Value of the document and its place.
struct Place {
  Document& document;
  const Json& json;
  std::string pointer;

  Place child(std::string_view key, const Json& value) const { return {document, value, json_pointer(pointer, key)}; }
  void report(std::string problem, std::string remedy) const;
  /// Reports that the value is not the `expected` one.
  void reject(const std::string& expected) const;
};

// Each read() reads the value at a place, or reports the permitted values and leaves `value` in any valid state.
void read(const Place& place, bool& value, Flag);
void read(const Place& place, double& value, const Numbers& numbers);
void read(const Place& place, int& value, const Numbers& numbers);
void read(const Place& place, std::int64_t& value, const Numbers& numbers);
void read(const Place& place, Vec2& value, const Numbers& numbers);
void read(const Place& place, Vec3& value, const Numbers& numbers);
void read(const Place& place, std::vector<int>& values, const Numbers& numbers);
void read(const Place& place, std::vector<Vec3>& values, const Numbers& numbers);
void read(const Place& place, std::string& value, const Text& text);
void read(const Place& place, std::string& value, const OneOf& one_of);
/// Reads a list of names, each of them once or more.
void read(const Place& place, std::vector<std::string>& values, const OneOf& one_of);
void read(const Place& place, std::filesystem::path& value, MeshPath);

/// Returns the index in `names` of the name at the place, or -1 after a report.
int read_name(const Place& place, std::span<const std::string_view> names, std::span<const RenamedValue> renamed = {});

/// Returns the indices in `names` of the array of names at the place; none after a report of an unknown one.
std::optional<std::vector<int>> read_names(const Place& place, std::span<const std::string_view> names);

template <class Enum>
requires std::is_enum_v<Enum>
void read(const Place& place, Enum& value, const OneOf& one_of) {
  if (const int index = read_name(place, one_of.names, one_of.renamed); index >= 0) value = static_cast<Enum>(index);
}

/// Reads a list of names, each of them once or more.
template <class Enum>
requires std::is_enum_v<Enum>
void read(const Place& place, std::vector<Enum>& values, const OneOf& one_of) {
  const std::optional<std::vector<int>> indices = read_names(place, one_of.names);
  if (!indices) return;
  values.clear();
  for (const int index : *indices) values.push_back(static_cast<Enum>(index));
}

}  // namespace griffith
