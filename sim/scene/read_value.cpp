#include "sim/scene/read_value.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "sim/core/file_path.h"

namespace griffith {
namespace {

bool in_range(const Json& json, const Numbers& numbers) {
  return json.is_number() && json.get<double>() >= numbers.minimum && json.get<double>() <= numbers.maximum;
}

/// Reports components that are not numbers of the range, each at its own place.
bool check_components(const Place& place, const Numbers& numbers) {
  const std::size_t before = place.document.problems.size();
  for (std::size_t i = 0; i < place.json.size(); ++i) {
    double ignored = 0;
    read(place.child(std::to_string(i), place.json[i]), ignored, numbers);
  }
  return place.document.problems.size() == before;
}

template <int N, int Options>
void read_vector(const Place& place, Eigen::Matrix<double, N, 1, Options>& value, const Numbers& numbers) {
  const std::string one_number = numbers.uniform ? " (or one number)" : "";
  if (numbers.uniform && place.json.is_number()) {
    double component = 0;
    read(place, component, numbers);
    value.setConstant(component);
    return;
  }
  if (!place.json.is_array() || place.json.size() != N) {
    return place.reject("an array of " + std::to_string(N) + " numbers" + one_number + ", each " + range_text(numbers));
  }
  if (!check_components(place, numbers)) return;
  Eigen::Matrix<double, N, 1, Options> vector;
  for (int i = 0; i < N; ++i) vector[i] = place.json[i].template get<double>();
  // Squares of components below 1e-100 vanish.
  if (numbers.nonzero && vector.template lpNorm<Eigen::Infinity>() < 1e-100) {
    return place.reject("a direction: at least one component other than 0");
  }
  if (numbers.ascending && !(vector[0] < vector[N - 1])) return place.reject("[low, high] with low less than high");
  value = vector;
}

/// Returns the files that the mesh at `path` needs: itself, both files of a folder, or both of TetGen's pair.
std::vector<std::filesystem::path> files_of_mesh(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return {path / "verts.csv", path / "tets.csv"};
  const std::filesystem::path ending = path.extension();
  if (ending != ".node" && ending != ".ele") return {path};
  return {std::filesystem::path(path).replace_extension(".node"),
          std::filesystem::path(path).replace_extension(".ele")};
}

/// Returns false after a report if there is no regular file, or if a link leads to one outside its folder. A path
/// shows its target, but a link in a scene from a stranger does not.
bool is_usable(const Place& place, MeshPath kind, const std::filesystem::path& file) {
  std::error_code ignored;
  const std::string shown = "\"" + file.generic_string() + "\"";
  const std::string names = "names the " + std::string(kind.what) + " " + place.json.dump() + ", but ";
  if (!std::filesystem::exists(file, ignored)) {
    place.report(names + "there is no " + shown,
                 "put it there or correct the path, which starts at the scene file's folder");
  } else if (!std::filesystem::is_regular_file(file, ignored)) {
    place.report(names + shown + " is not a regular file",
                 "put it there or correct the path, which starts at the scene file's folder");
  } else if (!is_within(file.parent_path(), file)) {
    place.report(names + shown + " is a link that leads out of its folder",
                 "name the file that it leads to, or put a copy in place of the link");
  } else {
    return true;
  }
  return false;
}

}  // namespace

void Place::report(std::string problem, std::string remedy) const {
  constexpr std::size_t kMaxProblems = 1000;
  if (document.problems.size() > kMaxProblems) return;
  if (document.problems.size() == kMaxProblems) {
    document.problems.emplace_back(document.file, "has more problems than these", "correct these first");
  } else {
    document.problems.emplace_back(json_place(document.file, pointer), std::move(problem), std::move(remedy));
  }
}

void Place::reject(const std::string& expected) const {
  constexpr std::size_t kLongestExcerpt = 40;
  std::string excerpt = json.is_object() ? "an object" : json.dump();
  if (excerpt.size() > kLongestExcerpt) excerpt = json.is_array() ? "an array" : "a long text";
  report("is " + excerpt, "expected " + expected);
}

void read(const Place& place, bool& value, Flag) {
  if (!place.json.is_boolean()) return place.reject("true or false");
  value = place.json.get<bool>();
}

void read(const Place& place, double& value, const Numbers& numbers) {
  if (!in_range(place.json, numbers)) return place.reject("a number " + range_text(numbers));
  value = place.json.get<double>();
}

void read(const Place& place, std::int64_t& value, const Numbers& numbers) {
  const bool whole = place.json.is_number() && std::trunc(place.json.get<double>()) == place.json.get<double>();
  if (!whole || !in_range(place.json, numbers)) return place.reject("a whole number " + range_text(numbers));
  value = static_cast<std::int64_t>(place.json.get<double>());
}

void read(const Place& place, int& value, const Numbers& numbers) {
  std::int64_t whole = value;
  read(place, whole, numbers);
  value = static_cast<int>(whole);
}

void read(const Place& place, Vec2& value, const Numbers& numbers) { read_vector(place, value, numbers); }
void read(const Place& place, Vec3& value, const Numbers& numbers) { read_vector(place, value, numbers); }

void read(const Place& place, std::vector<int>& values, const Numbers& numbers) {
  if (!place.json.is_array()) return place.reject("an array of whole numbers, each " + range_text(numbers));
  values.assign(place.json.size(), 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    read(place.child(std::to_string(i), place.json[i]), values[i], numbers);
  }
}

void read(const Place& place, std::vector<Vec3>& values, const Numbers& numbers) {
  if (!place.json.is_array())
    return place.reject("an array of points [x, y, z], each component " + range_text(numbers));
  values.assign(place.json.size(), Vec3::Zero());
  for (std::size_t i = 0; i < values.size(); ++i)
    read(place.child(std::to_string(i), place.json[i]), values[i], numbers);
}

void read(const Place& place, std::string& value, const Text& text) {
  const bool fits =
      place.json.is_string() && std::ssize(place.json.get_ref<const std::string&>()) >= text.minimum_length;
  if (!fits) return place.reject(text.minimum_length > 0 ? "a text that is not empty" : "a text");
  value = place.json.get<std::string>();
}

int read_name(const Place& place, std::span<const std::string_view> names, std::span<const RenamedValue> renamed) {
  if (!place.json.is_string()) return place.reject("one of " + quoted_list(names)), -1;
  std::string_view name = place.json.get_ref<const std::string&>();
  const auto old = std::ranges::find(renamed, name, &RenamedValue::old_name);
  if (old != renamed.end()) {
    name = old->name;
    place.document.outdated.emplace_back(json_place(place.document.file, place.pointer),
                                         "is called \"" + std::string(name) + "\" today, not " + place.json.dump(),
                                         "write \"" + std::string(name) + "\"; saving the scene does");
  }
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  place.report("is the unknown name " + place.json.dump(), suggestion(place.json.get_ref<const std::string&>(), names));
  return -1;
}

std::optional<std::vector<int>> read_names(const Place& place, std::span<const std::string_view> names) {
  if (!place.json.is_array()) return place.reject("an array [ ... ] of " + quoted_list(names)), std::nullopt;
  std::vector<int> indices;
  for (std::size_t i = 0; i < place.json.size(); ++i) {
    indices.push_back(read_name(place.child(std::to_string(i), place.json[i]), names));
  }
  if (std::ranges::find(indices, -1) != indices.end()) return std::nullopt;
  return indices;
}

void read(const Place& place, std::string& value, const OneOf& one_of) {
  if (const int index = read_name(place, one_of.names, one_of.renamed); index >= 0) value = one_of.names[index];
}

void read(const Place& place, std::vector<std::string>& values, const OneOf& one_of) {
  const std::optional<std::vector<int>> indices = read_names(place, one_of.names);
  if (!indices) return;
  values.clear();
  for (const int index : *indices) values.emplace_back(one_of.names[static_cast<std::size_t>(index)]);
}

void read(const Place& place, std::filesystem::path& value, MeshPath kind) {
  std::string text;
  const std::size_t before = place.document.problems.size();
  read(place, text, Text{1});
  if (place.document.problems.size() > before) return;
  value = text;
  if (!place.document.look_for_meshes) return;
  for (const auto& tried : files_of_mesh(file_path(place.document.folder, value)))
    if (!is_usable(place, kind, tried)) return;
}

}  // namespace griffith
