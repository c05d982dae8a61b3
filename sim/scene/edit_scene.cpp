#include "sim/scene/edit_scene.h"

#include <nlohmann/json.hpp>

#include "sim/scene/apply_setting.h"
#include "sim/scene/scene_fields.h"
#include "sim/scene/scene_in_full.h"
#include "sim/scene/scene_reader.h"

namespace griffith {

Scene edited(const Scene& scene, std::span<const SceneSetting> settings, const std::string& where) {
  Json document = scene_in_full(scene);
  document["version"] = kSceneVersion;
  if (!scene.schema.empty()) document["$schema"] = scene.schema;
  const Json in_full = document;
  for (const SceneSetting& setting : settings) apply(setting, document, in_full, where);
  Scene result = scene_from_json_alone(document.dump(), where);
  result.folder = scene.folder;
  return result;
}

std::string value_of(const Scene& scene, const std::string& pointer, const std::string& where) {
  Json document = scene_in_full(scene);
  const Json in_full = document;
  return value_at(document, in_full, pointer, where).dump();
}

}  // namespace griffith
