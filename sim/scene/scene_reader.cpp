#include "sim/scene/scene_reader.h"

#include <map>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

#include "sim/core/file_content.h"
#include "sim/scene/apply_setting.h"
#include "sim/scene/input_fields.h"
#include "sim/scene/json_document.h"
#include "sim/scene/read_value.h"
#include "sim/scene/scene_fields.h"
#include "sim/scene/scene_in_full.h"

namespace griffith {
namespace {

template <class T>
void read(const Place& place, std::vector<T>& items, Parts parts);
void read(const Place& place, Material& material, MaterialChoice);
template <class T>
requires(!kIsOptional<T>) void read(const Place& place, T& value, Parts);

template <class T, class Values>
void read(const Place& place, std::optional<T>& value, const Values& values) {
  if (place.json.is_null()) {
    value.reset();
    return;
  }
  const std::size_t before = place.document.problems.size();
  T present{};
  read(place, present, values);
  if (place.document.problems.size() == before) value = std::move(present);
}

// --- Objects --------------------------------------------------------------------------------------------------------

/// Archive that fills a value from an object. Fields that the object lacks keep their values.
class ObjectReader {
 public:
  explicit ObjectReader(const Place& place) : place_(place), problems_before_(place.document.problems.size()) {}

  template <class T, class Values>
  void field(std::string_view name, T& member, const Values& values, std::string_view) {
    if (const Json* json = find(name)) {
      read(place_.child(name, *json), member, values);
    } else if (std::is_same_v<Values, MeshPath>) {
      place_.report("lacks \"" + std::string(name) + "\"", "add it: nothing else says which file is meant");
    }
  }

  template <class T, class Variant, class Values, class Projection = std::identity>
  void alternative(std::string_view name, Variant& variant, const Values& values, std::string_view,
                   Projection projection = {}) {
    has_alternatives_ = true;
    if (const Json* json = find(name)) {
      ++alternatives_found_;
      T value{};
      read(place_.child(name, *json), std::invoke(projection, value), values);
      variant = std::move(value);
    }
  }

  /// Checks only fields that were read without a problem, since a rejected value leaves its default.
  void require(bool holds, std::string_view name, const char* problem, const char* remedy) {
    if (holds || place_.document.problems.size() > problems_before_) return;
    const Json* json = find(name);
    (json ? place_.child(name, *json) : place_).report(json ? problem : std::string(name) + " " + problem, remedy);
  }

  /// Returns the field's value, if present, and marks it as known.
  const Json* find(std::string_view name) {
    known_.push_back(name);
    const auto found = place_.json.find(name);
    return found == place_.json.end() ? nullptr : &*found;
  }

  /// Reports unknown fields, and a missing choice. To be called last.
  void finish() {
    for (const auto& [name, value] : place_.json.items()) {
      if (std::ranges::find(known_, name) != known_.end()) continue;
      place_.child(name, value).report("is not a known field", suggestion(name, known_));
    }
    if (has_alternatives_ && alternatives_found_ != 1 && place_.document.problems.size() == problems_before_) {
      place_.report("has " + std::to_string(alternatives_found_) + " of the fields " + quoted_list(known_),
                    "expected exactly one of them");
    }
  }

 private:
  const Place& place_;
  std::size_t problems_before_;
  std::vector<std::string_view> known_;
  bool has_alternatives_ = false;
  int alternatives_found_ = 0;
};

template <class T>
requires(!kIsOptional<T>) void read(const Place& place, T& value, Parts) {
  if (!place.json.is_object()) return place.reject("an object { ... }");
  ObjectReader reader(place);
  describe(reader, value);
  reader.finish();
}

/// Reports the items whose name an earlier item has.
template <class T>
void check_names(const Place& place, const std::vector<T>& items) {
  std::map<std::string_view, std::size_t> first;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto [earlier, is_new] = first.emplace(items[i].name, i);
    if (is_new) continue;
    place.child(std::to_string(i), place.json[i])
        .report("has the name \"" + items[i].name + "\", as item " + std::to_string(earlier->second) + " has",
                "give every item a \"name\" of its own");
  }
}

template <class T>
void read(const Place& place, std::vector<T>& items, Parts parts) {
  // A kilobyte each is checked before any is created; inputs of a long run may be many.
  constexpr std::size_t kMaxItems = std::is_same_v<T, WorldInput> ? 250'000 : 10'000;
  if (!place.json.is_array()) return place.reject("an array [ ... ]");
  constexpr const char* kTooMany = kMaxItems == 10'000 ? "has more than 10,000 items" : "has more than 250,000 items";
  if (place.json.size() > kMaxItems) return place.report(kTooMany, "use fewer");
  items.assign(place.json.size(), T{});
  for (std::size_t i = 0; i < items.size(); ++i) {
    read(place.child(std::to_string(i), place.json[i]), items[i], parts);
  }
  if constexpr (requires(T item) { item.name; }) check_names(place, items);
}

// --- Materials ------------------------------------------------------------------------------------------------------

std::vector<std::string_view> preset_names() {
  std::vector<std::string_view> names;
  for (const MaterialPreset& preset : material_presets()) names.push_back(preset.key);
  return names;
}

/// Starts from the material that the object's "preset" names, if it has one.
void read_preset(const Place& place, ObjectReader& reader, Material& material) {
  const Json* json = reader.find("preset");
  if (!json) return;
  const int index = read_name(place.child("preset", *json), preset_names());
  if (index >= 0) material = material_presets()[index].material;
}

void read(const Place& place, Material& material, MaterialChoice) {
  if (place.json.is_object()) {
    ObjectReader reader(place);
    read_preset(place, reader, material);
    describe(reader, material);
    return reader.finish();
  }
  if (!place.json.is_string()) return place.reject("a material's name, or an object with its properties");
  const auto& name = place.json.get_ref<const std::string&>();
  const auto own = place.document.materials.find(name);
  if (const auto preset = find_material_preset(name)) {
    material = *preset;
  } else if (own != place.document.materials.end()) {
    material = own->second;
  } else {
    std::vector<std::string_view> names = preset_names();
    for (const auto& [known, properties] : place.document.materials) names.push_back(known);
    read_name(place, names);
  }
}

/// Reads the scene's own materials, by name, for its bodies.
void read_materials(const Place& scene, ObjectReader& reader) {
  const Json* json = reader.find("materials");
  if (!json) return;
  const Place place = scene.child("materials", *json);
  if (!json->is_object()) return place.reject("an object { \"name\": { ... } }");
  for (const auto& [name, properties] : json->items()) {
    const Place entry = place.child(name, properties);
    Material& material = scene.document.materials[name];
    if (name.empty() || find_material_preset(name)) {
      entry.report("has a name that is empty or a preset's", "choose another name for this material");
    }
    if (!properties.is_object()) {
      entry.reject("an object { ... } with the material's properties");
      continue;
    }
    ObjectReader entry_reader(entry);
    read_preset(entry, entry_reader, material);
    material.name = name;
    describe_properties(entry_reader, material);
    entry_reader.finish();
  }
}

// --- The document ---------------------------------------------------------------------------------------------------

/// True if the document has this program's format. Otherwise its fields have no known meaning.
bool check_version(const Place& place, ObjectReader& reader) {
  const Json* json = reader.find("version");
  if (!json) {
    place.child("version", Json()).report("is missing", "add \"version\": " + std::to_string(kSceneVersion));
    return true;
  }
  const Place version = place.child("version", *json);
  if (*json == kSceneVersion) return true;
  if (json->is_number() && json->get<double>() > kSceneVersion) {
    version.report("is " + json->dump() + ", newer than this program",
                   "this program reads version " + std::to_string(kSceneVersion) + "; update it");
    return false;
  }
  return version.reject("the number " + std::to_string(kSceneVersion)), true;
}

Scene read_root(Document& document, const Json& json) {
  Scene scene;
  scene.folder = document.folder;
  const Place place{document, json, ""};
  if (!json.is_object()) return place.reject("an object { \"version\": 1, ... }"), scene;

  ObjectReader reader(place);
  reader.field("$schema", scene.schema, Text{}, "");
  if (!check_version(place, reader)) return scene;
  read_materials(place, reader);
  describe(reader, scene);
  reader.finish();
  for (const auto& [name, material] : document.materials) scene.materials.push_back(material);
  return scene;
}

/// Returns the scene of `json` in full. Its problems are reported after the settings are applied.
Json in_full(const Document& document, const Json& json) {
  Document trial;
  trial.file = document.file;
  trial.folder = document.folder;
  trial.look_for_meshes = false;
  return scene_in_full(read_root(trial, json));
}

/// Returns the document in `text` with the settings; null if the text is not JSON. Throws InputError for an unknown
/// field or a value that is not JSON.
Json document_json(Document& document, std::string_view text, std::span<const SceneSetting> settings) {
  Json json = parse_json(text, document.file, document.problems);
  if (json.is_null() && !document.problems.empty()) return json;
  for (const SceneSetting& setting : settings) apply(setting, json, in_full(document, json), document.file);
  return json;
}

Scene read_document(Document& document, std::string_view text, std::span<const SceneSetting> settings = {}) {
  const Json json = document_json(document, text, settings);
  if (!json.is_null() || document.problems.empty()) return read_root(document, json);
  Scene nothing;
  nothing.folder = document.folder;
  return nothing;
}

/// Returns the inputs of a document, which holds its own materials as a scene does.
std::vector<WorldInput> read_inputs(Document& document, std::string_view text) {
  std::vector<WorldInput> inputs;
  const Json json = parse_json(text, document.file, document.problems);
  if (json.is_null() && !document.problems.empty()) return inputs;
  const Place place{document, json, ""};
  if (!json.is_object()) return place.reject("an object { \"version\": 1, ... }"), inputs;
  ObjectReader reader(place);
  if (!check_version(place, reader)) return inputs;
  read_materials(place, reader);
  reader.field("inputs", inputs, Parts{}, "");
  if (!std::ranges::is_sorted(inputs, {}, &WorldInput::step))
    place.child("inputs", json["inputs"]).report("are not in the order of their steps", "sort them by \"step\"");
  reader.finish();
  return inputs;
}

/// Scenes name large meshes, but do not contain them.
constexpr std::int64_t kMaxBytes = 16 << 20;

Document document_of_file(const std::filesystem::path& path) {
  if (path.empty()) throw InputError("the scene", "has no path", "name its file");
  Document document;
  document.file = path.generic_string();
  document.folder = std::filesystem::absolute(path).lexically_normal().parent_path();
  return document;
}

Scene first_problem_thrown(Document document, std::string_view text, std::span<const SceneSetting> settings = {}) {
  Scene scene = read_document(document, text, settings);
  if (!document.problems.empty()) throw document.problems.front();
  return scene;
}

}  // namespace

Scene read_scene(const std::filesystem::path& path, std::span<const SceneSetting> settings) {
  return first_problem_thrown(document_of_file(path), read_expected_file(path, kMaxBytes), settings);
}

std::string scene_value(const std::filesystem::path& scene_file, const std::string& pointer,
                        std::span<const SceneSetting> settings) {
  Document document = document_of_file(scene_file);
  Json json = document_json(document, read_expected_file(scene_file, kMaxBytes), settings);
  if (!document.problems.empty()) throw document.problems.front();
  return value_at(json, in_full(document, json), pointer, document.file).dump();
}

Scene scene_from_json(std::string_view text, const std::string& where, const std::filesystem::path& folder) {
  Document document;
  document.file = where;
  document.folder = folder;
  return first_problem_thrown(std::move(document), text);
}

Scene scene_from_json_alone(std::string_view text, const std::string& where) {
  Document document;
  document.file = where;
  document.look_for_meshes = false;
  return first_problem_thrown(std::move(document), text);
}

std::vector<WorldInput> inputs_from_json(std::string_view text, const std::string& where) {
  Document document;
  document.file = where;
  std::vector<WorldInput> inputs = read_inputs(document, text);
  if (!document.problems.empty()) throw document.problems.front();
  return inputs;
}

std::vector<InputError> check_scene(const std::filesystem::path& path, std::span<const SceneSetting> settings) try {
  Document document = document_of_file(path);
  read_document(document, read_expected_file(path, kMaxBytes), settings);
  return document.problems;
} catch (const InputError& unreadable) {
  return {unreadable};
}

std::vector<InputError> outdated_names(const std::filesystem::path& path) try {
  Document document = document_of_file(path);
  read_document(document, read_expected_file(path, kMaxBytes));
  return document.outdated;
} catch (const InputError&) {
  return {};
}

std::vector<InputError> check_scene_text(std::string_view text, const std::string& where) {
  Document document;
  document.file = where;
  document.look_for_meshes = false;
  read_document(document, text);
  return document.problems;
}

}  // namespace griffith
