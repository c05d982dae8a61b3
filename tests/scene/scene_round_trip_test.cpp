#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <limits>

#include "random_scene.h"
#include "sim/core/error.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"
#include "text_of.h"

namespace griffith {
namespace {

namespace fs = std::filesystem;

/// Empty folder with two "meshes", removed at the end.
class SceneRoundTrip : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "meshes/folder");
    for (const char* file : {"file.msh", "folder/verts.csv", "folder/tets.csv"}) {
      std::ofstream(folder_ / "meshes" / file) << "a mesh";
    }
  }
  void TearDown() override { fs::remove_all(folder_); }

  Scene random_scene(unsigned seed) const {
    Scene scene = Randomizer(seed, {"meshes/folder", "meshes/file.msh"}).scene();
    scene.folder = folder_;
    return scene;
  }

  const fs::path folder_ = fs::absolute(testing::TempDir()).lexically_normal() /
                           (std::string("griffith_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

/// True if `back` was written as `scene`: it has exactly the materials of its bodies among its own.
bool is_what_was_written(const Scene& back, Scene scene) {
  for (const Material& material : back.materials) {
    const bool is_of_a_body =
        std::ranges::find(scene.bodies, material, &BodyDescription::material) != scene.bodies.end();
    if (!is_of_a_body && std::ranges::find(scene.materials, material) == scene.materials.end()) return false;
  }
  scene.materials = back.materials;
  return back == scene;
}

TEST_F(SceneRoundTrip, EveryRandomSceneComesBackExactly) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Scene scene = random_scene(seed);
    const std::string text = scene_to_json(scene);
    const Scene back = scene_from_json(text, "scene", folder_);
    ASSERT_TRUE(is_what_was_written(back, scene)) << "seed " << seed << "\n" << text;
    EXPECT_EQ(scene_to_json(back), text);
    EXPECT_TRUE(scene_from_json(text, "scene", folder_) == back);
  }
}

TEST_F(SceneRoundTrip, DoublesKeepEveryBit) {
  std::mt19937_64 random(5);
  Scene scene;
  scene.bodies.resize(1);
  scene.bodies[0].position.y() = 1;  // differs from the default, which would be omitted
  const auto bits = [](double value) {
    std::uint64_t pattern;
    std::memcpy(&pattern, &value, sizeof pattern);
    return pattern;
  };
  for (int i = 0; i < 2000; ++i) {
    const double exponent = std::uniform_real_distribution(-320.0, 5.9)(random);
    const double value = i == 0 ? -0.0 : (i % 2 ? 1 : -1) * std::pow(10, exponent);
    scene.bodies[0].position.x() = value;
    EXPECT_EQ(bits(scene_from_json(scene_to_json(scene)).bodies[0].position.x()), bits(value)) << value;
  }
}

TEST_F(SceneRoundTrip, ADefaultSceneIsItsVersionAlone) {
  EXPECT_EQ(scene_to_json(Scene{}), "{\n  \"version\": 1\n}\n");
  EXPECT_TRUE(scene_from_json(R"({"version": 1})") == Scene{});
}

TEST_F(SceneRoundTrip, AFileComesBackWithItsFolder) {
  const Scene scene = random_scene(11);
  write_scene(scene, folder_ / "scene.json");
  EXPECT_TRUE(is_what_was_written(read_scene(folder_ / "scene.json"), scene));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);  // and the meshes
}

TEST_F(SceneRoundTrip, MeshesAreFoundFromWhereTheSceneIsSaved) {
  Scene scene;
  scene.folder = folder_;
  scene.bodies.resize(1);
  scene.bodies[0].shape = MeshFileShape{"meshes/file.msh", 2};
  fs::create_directories(folder_ / "elsewhere/deeper");
  write_scene(scene, folder_ / "elsewhere/deeper/scene.json");
  const Scene moved = read_scene(folder_ / "elsewhere/deeper/scene.json");
  const auto& mesh = std::get<MeshFileShape>(moved.bodies.at(0).shape);
  EXPECT_TRUE(mesh.path.is_relative());
  EXPECT_TRUE(fs::equivalent(moved.folder / mesh.path, folder_ / "meshes/file.msh"));
  scene.bodies[0].shape = SurfaceShape{"meshes/file.msh", 2, {}};
  write_scene(scene, folder_ / "elsewhere/deeper/scene.json");
  const Scene again = read_scene(folder_ / "elsewhere/deeper/scene.json");
  EXPECT_TRUE(fs::equivalent(again.folder / std::get<SurfaceShape>(again.bodies.at(0).shape).path,
                             folder_ / "meshes/file.msh"));
}

TEST_F(SceneRoundTrip, AFolderIsAMeshOnlyWithBothItsFiles) {
  Scene scene;
  scene.bodies.resize(1);
  scene.bodies[0].shape = MeshFileShape{"meshes/folder", 1};
  const std::string text = scene_to_json(scene);
  EXPECT_NO_THROW(scene_from_json(text, "scene", folder_));
  fs::remove(folder_ / "meshes/folder/tets.csv");
  try {
    scene_from_json(text, "scene", folder_);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.problem(), testing::HasSubstr("meshes/folder/tets.csv"));
  }
}

TEST_F(SceneRoundTrip, AnUnusableSceneIsRefusedAndTheOldFileStays) {
  write_scene(Scene{}, folder_ / "scene.json");
  const std::string before = text_of(folder_ / "scene.json");
  std::vector<Scene> unusable(4);
  unusable[0].gravity.y() = std::numeric_limits<double>::quiet_NaN();
  unusable[1].simulation.time_step = std::numeric_limits<double>::infinity();
  unusable[2].bodies.resize(2);  // of the same name
  unusable[3].name = "\xff\xfe";
  for (const Scene& scene : unusable) {
    EXPECT_THROW(write_scene(scene, folder_ / "scene.json"), InputError);
    EXPECT_EQ(text_of(folder_ / "scene.json"), before);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);  // and the meshes
  }
}

TEST_F(SceneRoundTrip, AFolderThatIsNotThereIsNamed) {
  try {
    write_scene(Scene{}, folder_ / "nowhere/scene.json");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.where(), testing::HasSubstr("nowhere/scene.json"));
  }
}

TEST_F(SceneRoundTrip, MaterialsThatShareANameStayApart) {
  Scene scene;
  scene.bodies.resize(4);
  for (int i = 0; i < 4; ++i) scene.bodies[i].name = std::to_string(i);
  scene.bodies[0].material.name = scene.bodies[1].material.name = scene.bodies[3].material.name = "mine";
  scene.bodies[1].material.density = 1;
  scene.bodies[2].material.friction = 0.123;  // still has the name of the preset that it no longer equals
  EXPECT_TRUE(is_what_was_written(scene_from_json(scene_to_json(scene)), scene));
}

TEST_F(SceneRoundTrip, WhatNoBodyUsesStaysInTheFile) {
  const Scene scene = scene_from_json(R"({"$schema": "meshes/scene.schema.json", "version": 1,
      "materials": {"spare": {"density": 7}, "worn": {"density": 8}}, "bodies": [{"shape": {"box": {}}, "material": "worn"}]})",
                                      "scene", folder_);
  const auto materials_of = [](const std::string& text) { return scene_from_json(text).materials; };
  const auto has = [&](const std::vector<Material>& materials, const char* name, double density) {
    const auto found = std::ranges::find(materials, name, &Material::name);
    return found != materials.end() && found->density == density;
  };
  const std::string text = scene_to_json(scene);
  EXPECT_THAT(text, testing::StartsWith("{\n  \"$schema\": \"meshes/scene.schema.json\",\n  \"version\": 1,"));
  EXPECT_TRUE(has(materials_of(text), "spare", 7) && has(materials_of(text), "worn", 8)) << text;

  Scene edited = scene;  // a body's own material keeps its name, and its former one stays too
  edited.bodies[0].material.density = 9;
  EXPECT_TRUE(has(materials_of(scene_to_json(edited)), "worn", 9));
  edited.bodies[0].material = material_presets()[0].material;
  EXPECT_TRUE(has(materials_of(scene_to_json(edited)), "worn", 8));
  edited.bodies.clear();
  EXPECT_EQ(materials_of(scene_to_json(edited)).size(), 2u);
}

TEST_F(SceneRoundTrip, TheSchemaIsFoundFromWhereTheSceneIsSaved) {
  fs::create_directories(folder_ / "elsewhere");
  Scene scene;
  scene.folder = folder_;
  scene.schema = "scene.schema.json";
  write_scene(scene, folder_ / "elsewhere/scene.json");
  EXPECT_EQ(read_scene(folder_ / "elsewhere/scene.json").schema, "../scene.schema.json");
  scene.schema = "https://example.org/scene.schema.json";
  write_scene(scene, folder_ / "elsewhere/scene.json");
  EXPECT_EQ(read_scene(folder_ / "elsewhere/scene.json").schema, scene.schema);
}

TEST_F(SceneRoundTrip, SurfacesOfProjectilesAreFoundFromWhereTheSceneIsSaved) {
  Scene scene;
  scene.folder = folder_;
  scene.projectiles.resize(1);
  scene.projectiles[0].shape = SurfaceProjectile{"meshes/file.msh", 1};
  fs::create_directories(folder_ / "elsewhere");
  write_scene(scene, folder_ / "elsewhere/scene.json");
  EXPECT_NO_THROW(read_scene(folder_ / "elsewhere/scene.json"));
}

}  // namespace
}  // namespace griffith
