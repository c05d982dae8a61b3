#include "app/editor/preferences_file.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim/core/error.h"
#include "sim/core/read_file.h"
#include "sim/core/replace_file.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

ui::SectionOrder section_order(const Json& json) { return {json.at("left"), json.at("right"), json.at("folded")}; }

Json json_of(const ui::SectionOrder& order) {
  return {{"left", order.left}, {"right", order.right}, {"folded", order.folded}};
}

template <class T>
Json json_of(const T& value) {
  return value;
}

/// Reads members from JSON; absent ones keep their values.
struct PreferenceReader {
  const Json& json;
  const fs::path& file;

  [[noreturn]] void fail(const char* name, const std::string& remedy) const {
    throw InputError(file.string() + "#/" + name, "is " + json.at(name).dump(), remedy + ", or delete the file");
  }
  void operator()(const char* name, double& value, const Numbers& limits) const {
    if (!json.contains(name)) return;
    const bool good = json[name].is_number() && json[name] >= limits.minimum && json[name] <= limits.maximum;
    std::ostringstream range;
    range << "write a number from " << limits.minimum << " to " << limits.maximum;
    if (!good) fail(name, range.str());
    value = json[name];
  }
  void operator()(const char* name, bool& value) const {
    if (!json.contains(name)) return;
    if (!json[name].is_boolean()) fail(name, "write true or false");
    value = json[name];
  }
  void operator()(const char* name, ui::PlotChoice& value) const {
    if (!json.contains(name)) return;
    const bool good = json[name].is_array() && json[name].size() == value.size() &&
                      std::ranges::all_of(json[name], [](const Json& key) { return key.is_string(); });
    if (!good) fail(name, "write " + std::to_string(value.size()) + " names of series; empty for none");
    value = json[name].get<ui::PlotChoice>();
  }
  void operator()(const char* name, ui::SectionOrder& value) const {
    if (!json.contains(name)) return;
    try {
      value = section_order(json[name]);
    } catch (const Json::exception&) {
      fail(name, "write lists \"left\", \"right\" and \"folded\" of sections");
    }
    if (!ui::is_complete(value)) fail(name, "name each section on one side");
  }
};

}  // namespace

ui::Preferences PreferencesFile::read() {
  std::error_code error;
  if (file_.empty() || !fs::exists(file_, error)) return kept_;
  const Json json = Json::parse(read_file(file_), nullptr, false);
  if (!json.is_object()) throw InputError(file_.string(), "holds no preferences", "delete it to use the defaults");
  ui::Preferences preferences;
  ui::each_preference(preferences, PreferenceReader{json, file_});
  return kept_ = preferences;
}

void PreferencesFile::keep(const ui::Preferences& preferences) {
  if (file_.empty() || preferences == kept_) return;
  kept_ = preferences;
  Json json;
  ui::each_preference(preferences,
                      [&](const char* name, const auto& value, auto&&...) { json[name] = json_of(value); });
  std::error_code error;  // if the folder cannot be made, writing reports it
  fs::create_directories(file_.parent_path(), error);
  replace_file(file_, json.dump(2) + "\n");
}

fs::path preferences_path() {
  constexpr char kName[] = "griffith/preferences.json";
  if (const char* folder = std::getenv("XDG_CONFIG_HOME"); folder && *folder) return fs::path(folder) / kName;
  if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".config" / kName;
  return {};
}

}  // namespace griffith::app
