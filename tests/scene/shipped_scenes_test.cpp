#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"
#include "tests/scene/scene_schema.h"
#include "text_of.h"

namespace griffith {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const fs::path kScenes = fs::path(GRIFFITH_SOURCE_DIR) / "scenes";

std::vector<fs::path> shipped_scenes() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(kScenes)) {
    const std::string name = entry.path().filename().string();
    const bool is_copy = entry.path().parent_path().filename().string().starts_with('.');  // of an editor's edits
    if (name.ends_with(".json") && !name.ends_with(".schema.json") && !is_copy) paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  return paths;
}

std::vector<std::string> shipped_names() {
  std::vector<std::string> names;
  for (const fs::path& path : shipped_scenes())
    names.push_back(path.lexically_relative(kScenes).replace_extension().generic_string());
  return names;
}

class ShippedScene : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedScene, ::testing::ValuesIn(shipped_names()), [](const auto& parameter) {
  std::string name = parameter.param;
  std::ranges::replace(name, '/', '_');
  return name;
});

TEST_P(ShippedScene, IsWithoutAProblemAndSaysWhatItShows) {
  const fs::path path = kScenes / (GetParam() + ".json");
  EXPECT_THAT(check_scene_text(text_of(path), "scene"), ::testing::IsEmpty());
  for (const InputError& problem : check_scene(path)) ADD_FAILURE() << problem.what();
  const Scene scene = read_scene(path);
  EXPECT_FALSE(scene.name.empty() || scene.description.empty() || scene.bodies.empty() || scene.cameras.empty());
  EXPECT_TRUE(scene_from_json(scene_to_json(scene), "scene", scene.folder) == scene);
}

TEST(ShippedScenes, WallsStandOnTheGroundAndAreHeldAtTheFoot) {
  int walls = 0;
  for (const fs::path& path : shipped_scenes()) {
    const bool has_walls = path.stem().string().starts_with("wall") || path.stem() == "materials";
    if (!has_walls) continue;
    const Scene scene = read_scene(path);
    for (const BodyDescription& body : scene.bodies) {
      const auto* box = std::get_if<BoxShape>(&body.shape);
      if (!box || body.supports.empty()) continue;
      const double foot = -0.5 * box->size.y();
      EXPECT_EQ(body.position.y() + foot, scene.ground->height) << path << body.name;
      EXPECT_TRUE(contains(body.supports[0].region, Vec3(0.3, foot, 0.1), 0, 1e-9));
      EXPECT_FALSE(contains(body.supports[0].region, Vec3(0.3, foot + 0.1, 0.1), 0, 1e-9));
      ++walls;
    }
  }
  EXPECT_GE(walls, 58);
}

TEST(SceneSchema, TheFileIsWhatTheFieldTableSays) {
  const std::string made = scene_schema();
  const fs::path copy = fs::path(::testing::TempDir()) / "scene.schema.json";
  if (text_of(kScenes / "scene.schema.json") != made) std::ofstream(copy, std::ios::binary) << made;
  EXPECT_TRUE(text_of(kScenes / "scene.schema.json") == made)
      << "scenes/scene.schema.json is out of date; copy " << copy << " over it";
}

/// A scene of every default that the schema states is the default scene.
Json defaults_of(const Json& schema) {
  Json object = Json::object();
  for (const auto& [name, property] : schema["properties"].items()) {
    if (!property.contains("default")) continue;
    object[name] = property.contains("properties") && !property.contains("maxProperties") ? defaults_of(property)
                                                                                          : property["default"];
  }
  return object;
}

TEST(SceneSchema, ItsDefaultsAreTheStructsDefaults) {
  const Json schema = Json::parse(scene_schema());
  Json document = defaults_of(schema);
  document["version"] = 1;
  EXPECT_TRUE(scene_from_json(document.dump()) == Scene{});

  const Json& body = schema["properties"]["bodies"]["items"]["properties"];
  document["bodies"] = {defaults_of(schema["properties"]["bodies"]["items"])};
  document["projectiles"] = {defaults_of(schema["properties"]["projectiles"]["items"])};
  document["probes"] = {defaults_of(schema["properties"]["probes"]["items"])};
  document["bodies"][0]["supports"] = {defaults_of(body["supports"]["items"])};
  document["bodies"][0]["loads"] = {defaults_of(body["loads"]["items"])};
  document["cameras"] = {defaults_of(schema["properties"]["cameras"]["items"])};
  document["ground"] = defaults_of(schema["properties"]["ground"]["anyOf"][0]);
  const Json& material = body["material"]["anyOf"][1];
  document["bodies"][0]["material"] = defaults_of(material);
  Scene scene;
  scene.bodies.resize(1);
  scene.bodies[0].supports.resize(1);
  scene.bodies[0].loads.resize(1);
  scene.projectiles.resize(1);
  scene.probes.resize(1);
  scene.cameras.resize(1);
  EXPECT_TRUE(scene_from_json(document.dump()) == scene);
  EXPECT_GE(document["bodies"][0]["material"].size(), 12u);
}

TEST(SceneReadme, NamesEveryFieldWithItsDefault) {
  const std::string readme = text_of(kScenes / "README.md");
  const std::function<void(const Json&)> look = [&](const Json& schema) {
    const Json properties = schema.value("properties", Json::object());
    for (const auto& [name, property] : properties.items()) {
      const std::string row =
          "| `" + name + "` |" + (property.contains("default") ? " `" + property["default"].dump() + "` |" : "");
      EXPECT_NE(readme.find(row), std::string::npos) << "no row starts with " << row;
      look(property);
      look(property.value("items", Json::object()));
      for (const Json& option : property.value("anyOf", Json::array())) look(option);
    }
  };
  look(Json::parse(scene_schema()));
}

}  // namespace
}  // namespace griffith
