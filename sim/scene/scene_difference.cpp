#include "sim/scene/scene_difference.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/core/error.h"
#include "sim/core/sort_unique.h"
#include "sim/scene/apply_setting.h"
#include "sim/scene/scene_in_full.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"

namespace griffith {
namespace {

/// True if both have the same members, or as many items of which some are not numbers.
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

/// True for items that all have different names.
bool has_named_items(const Json& list) {
  std::vector<std::string> names;
  for (const Json& item : list) {
    if (!item.is_object() || !item.contains("name") || !item["name"].is_string()) return false;
    names.push_back(item["name"].get<std::string>());
  }
  const std::size_t items = names.size();
  sort_unique(names);
  return names.size() == items;
}

/// Comparison of two scenes at a place; null where one has no value.
class FieldComparison {
 public:
  void compare(const Json* before, const Json* after, const std::string& pointer) {
    if (before != nullptr && after != nullptr && *before == *after) return;
    const bool both = before != nullptr && after != nullptr;
    if (both && before->is_object() && after->is_object()) return compare_members(*before, *after, pointer);
    if (both && is_list(*before) && is_list(*after)) return compare_items(*before, *after, pointer);
    const auto text = [](const Json* json) { return json ? std::optional(json->dump()) : std::nullopt; };
    changes.push_back({pointer, text(before), text(after)});
  }

  std::vector<FieldChange> changes;

 private:
  /// False for vectors, which change as a whole.
  static bool is_list(const Json& json) {
    return json.is_array() && std::ranges::all_of(json, [](const Json& item) { return item.is_structured(); });
  }
  static const Json* member(const Json& object, const std::string& name) {
    const auto found = object.find(name);
    return found == object.end() ? nullptr : &*found;
  }

  void compare_members(const Json& before, const Json& after, const std::string& pointer) {
    for (const auto& [name, value] : after.items()) compare(member(before, name), &value, json_pointer(pointer, name));
    for (const auto& [name, value] : before.items())
      if (!after.contains(name)) compare(&value, nullptr, json_pointer(pointer, name));
  }

  void compare_items(const Json& before, const Json& after, const std::string& pointer) {
    const bool by_name = has_named_items(before) && has_named_items(after);
    const auto partner = [&](const Json& list, const Json& item, std::size_t i) -> const Json* {
      if (!by_name) return i < list.size() ? &list[i] : nullptr;
      const auto found = std::ranges::find_if(list, [&](const Json& other) { return other["name"] == item["name"]; });
      return found == list.end() ? nullptr : &*found;
    };
    for (std::size_t i = 0; i < after.size(); ++i)
      compare(partner(before, after[i], i), &after[i], json_pointer(pointer, std::to_string(i)));
    for (std::size_t i = 0; i < before.size(); ++i)
      if (partner(after, before[i], i) == nullptr)
        compare(&before[i], nullptr, json_pointer(pointer, std::to_string(i)));
  }
};

Json parsed(const std::string& text) {
  std::vector<InputError> problems;
  Json json = parse_json(text, "the kept scene", problems);
  if (!problems.empty()) throw problems.front();
  return json;
}

}  // namespace

std::string full_scene_text(const Scene& scene) { return pretty_text(scene_in_full(scene)); }

std::vector<FieldChange> field_changes(const std::string& before, const std::string& after) {
  FieldComparison comparison;
  const Json first = parsed(before), second = parsed(after);
  comparison.compare(&first, &second, "");
  return std::move(comparison.changes);
}

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
  if (std::ranges::none_of(settings, is_of_library)) result.materials = scene.materials;  // without settings of bodies
  return result;
}

}  // namespace griffith
