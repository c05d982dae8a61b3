#include "sim/scene/scene_difference.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/scene/apply_setting.h"
#include "sim/scene/scene_in_full.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"

namespace griffith {
namespace {

/// Whether both have the same members, or as many items of which some are no numbers.
bool differs_within(const Json& before, const Json& after) {
  if (before.type() != after.type() || before.size() != after.size()) return false;
  if (after.is_array()) return std::ranges::any_of(after, [](const Json& item) { return item.is_structured(); });
  if (!after.is_object()) return false;
  for (const auto& [name, member] : after.items())
    if (!before.contains(name)) return false;
  return true;
}

void add_differences(const Json& before, const Json& after, const std::string& pointer,
                     std::vector<SceneSetting>& settings) {
  if (before == after) return;
  if (!differs_within(before, after)) {
    settings.push_back({pointer, after.dump()});
  } else if (after.is_array()) {
    for (std::size_t i = 0; i < after.size(); ++i)
      add_differences(before[i], after[i], json_pointer(pointer, std::to_string(i)), settings);
  } else {
    for (const auto& [name, member] : after.items())
      add_differences(before.at(name), member, json_pointer(pointer, name), settings);
  }
}

}  // namespace

std::vector<SceneSetting> settings_between(const Scene& before, const Scene& after) {
  std::vector<SceneSetting> settings;
  add_differences(scene_in_full(before), scene_in_full(after), "", settings);
  return settings;
}

Scene with_settings(const Scene& scene, std::span<const SceneSetting> settings, const std::string& where) {
  Json document = Json::parse(scene_to_json(scene));
  const Json in_full = scene_in_full(scene);
  for (const SceneSetting& setting : settings) apply(setting, document, in_full, where);
  Scene result = scene_from_json(document.dump(), where, scene.folder);
  result.folder = scene.folder;
  const auto is_of_library = [](const SceneSetting& setting) { return setting.pointer.starts_with("/materials"); };
  if (std::ranges::none_of(settings, is_of_library)) result.materials = scene.materials;  // without those of bodies
  return result;
}

}  // namespace griffith
