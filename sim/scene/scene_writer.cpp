#include "sim/scene/scene_writer.h"

#include <functional>
#include <nlohmann/json.hpp>

#include "sim/core/error.h"
#include "sim/core/replace_file.h"
#include "sim/scene/input_fields.h"
#include "sim/scene/json_values.h"
#include "sim/scene/scene_fields.h"
#include "sim/scene/scene_in_full.h"
#include "sim/scene/scene_paths.h"
#include "sim/scene/scene_reader.h"

namespace griffith {
namespace {

/// Materials of the scene: those of its bodies as they are written, then the unused ones.
struct Library {
  std::vector<Material> materials;
  bool in_full = false;  ///< no omitted field, material by name, or vector as one number
};

template <class T>
requires(!kIsOptional<T>) Json write(Library& library, const T& value, Parts);

template <class T, class Values>
Json write(Library& library, const T& value, Values values) {
  if constexpr (std::is_same_v<Values, Numbers>) values.uniform = values.uniform && !library.in_full;
  return value_json(value, values);
}

template <class T, class Values>
Json write(Library& library, const std::optional<T>& value, const Values& values) {
  return value ? write(library, *value, values) : Json();
}

template <class T>
Json write(Library& library, const std::vector<T>& items, Parts parts) {
  Json array = Json::array();
  for (const T& item : items) array.push_back(write(library, item, parts));
  return array;
}

Json write(Library& library, const Material& material, MaterialChoice);

/// Archive that makes an object from a value.
class ObjectWriter {
 public:
  explicit ObjectWriter(Library& library) : library_(library) {}

  template <class T, class Values>
  void field(std::string_view name, const T& member, const Values& values, std::string_view) {
    object[std::string(name)] = write(library_, member, values);
  }

  template <class T, class Variant, class Values, class Projection = std::identity>
  void alternative(std::string_view name, const Variant& variant, const Values& values, std::string_view,
                   Projection projection = {}) {
    const T* held = std::get_if<T>(&variant);
    if (held) object[std::string(name)] = write(library_, std::invoke(projection, *held), values);
    has_alternatives = true;
  }

  void require(bool, std::string_view, const char*, const char*) {}

  Json object = Json::object();
  bool has_alternatives = false;

 private:
  Library& library_;
};

template <class T>
ObjectWriter described(Library& library, T value) {
  ObjectWriter writer(library);
  describe(writer, value);
  return writer;
}

template <class T>
requires(!kIsOptional<T>) Json write(Library& library, const T& value, Parts) {
  ObjectWriter writer = described(library, value);
  if (writer.has_alternatives || library.in_full) return writer.object;
  Library ignored;
  const Json defaults = described(ignored, T{}).object;
  Json object = Json::object();
  for (const auto& [name, member] : writer.object.items()) {
    if (member != defaults.at(name)) object[name] = std::move(member);
  }
  return object;
}

/// Writes a name if that is complete; else the properties, among the scene's materials if the name is free there.
Json write(Library& library, const Material& material, MaterialChoice) {
  if (library.in_full) return described(library, material).object;
  for (const MaterialPreset& preset : material_presets()) {
    if (preset.material == material) return preset.key;
  }
  const auto namesake = std::ranges::find(library.materials, material.name, &Material::name);
  const bool name_is_free =
      namesake == library.materials.end() && !material.name.empty() && !find_material_preset(material.name);
  if (name_is_free) library.materials.push_back(material);
  if (name_is_free || (namesake != library.materials.end() && *namesake == material)) return material.name;
  return described(library, material).object;
}

Json library_json(const Library& library) {
  Json object = Json::object();
  for (Material material : library.materials) {
    Library ignored;
    ObjectWriter writer(ignored);
    describe_properties(writer, material);
    object[material.name] = std::move(writer.object);
  }
  return object;
}

/// Adds materials whose name no body uses for another.
void add_others(Library& library, const std::vector<Material>& materials) {
  for (const Material& material : materials)
    if (std::ranges::find(library.materials, material.name, &Material::name) == library.materials.end())
      library.materials.push_back(material);
}

bool is_address(const std::string& path) { return path.find("://") != std::string::npos; }

}  // namespace

Scene with_paths_from(Scene scene, const std::filesystem::path& folder) {
  if (scene.folder == folder) return scene;
  const auto move = [&](std::filesystem::path& path) {
    if (!path.is_absolute()) path = path_from_scene(scene.folder / path, folder);
  };
  if (!scene.schema.empty() && !is_address(scene.schema)) {
    std::filesystem::path schema = scene.schema;
    move(schema);
    scene.schema = schema.generic_string();
  }
  for (std::filesystem::path* path : paths_in(scene)) move(*path);
  scene.folder = folder;
  return scene;
}

std::string scene_to_json(const Scene& scene) {
  Library library;
  const Json fields = write(library, scene, Parts{});
  add_others(library, scene.materials);
  Json document = Json::object();
  if (!scene.schema.empty()) document["$schema"] = scene.schema;
  document["version"] = kSceneVersion;
  if (!library.materials.empty()) document["materials"] = library_json(library);
  document.update(fields);
  return pretty_text(document);
}

Json scene_in_full(const Scene& scene) {
  Library library = {.materials = scene.materials, .in_full = true};
  Json document = write(library, scene, Parts{});
  document["materials"] = library_json(library);
  return document;
}

std::string inputs_to_json(const std::vector<WorldInput>& inputs) {
  Library library;
  Json list = write(library, inputs, Parts{});
  Json document = Json::object();
  document["version"] = kSceneVersion;
  if (!library.materials.empty()) document["materials"] = library_json(library);
  document["inputs"] = std::move(list);
  return pretty_text(document);
}

void write_scene(const Scene& scene, const std::filesystem::path& path) {
  const auto folder = std::filesystem::absolute(path).lexically_normal().parent_path();
  const std::string text = scene_to_json(with_paths_from(scene, folder));
  const auto problems = check_scene_text(text, path.generic_string());
  if (!problems.empty()) throw problems.front();
  replace_file(path, text);
}

}  // namespace griffith
