#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string_view>

#include "app/export/bake_json.h"
#include "app/export/bond_csv.h"
#include "app/export/glb_file.h"
#include "app/export/html_player.h"
#include "app/export/tiny_gltf.h"
#include "app/export/usda_file.h"
#include "baked_run.h"
#include "program.h"
#include "tests/world/scenes.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;

Bake wall_bake(bool deformed = false) {
  return baked_run(testing::shot_wall(Vec3(2, 2, 0.5), 0.5, testing::brick(0.02)), 0, 30, deformed);
}

tinygltf::Model read_glb(const std::string& bytes) {
  tinygltf::Model model;
  std::string error, warning;
  EXPECT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromMemory(&model, &error, &warning,
                                                        reinterpret_cast<const unsigned char*>(bytes.data()),
                                                        static_cast<unsigned>(bytes.size())))
      << error;
  EXPECT_EQ(warning, "");
  return model;
}

TEST(Glb, ReadsBackWithAllObjectsTrianglesAndTimes) {
  const Bake bake = wall_bake();
  const tinygltf::Model model = read_glb(glb_file(bake));
  ASSERT_EQ(model.nodes.size(), bake.objects.size());
  EXPECT_EQ(model.materials.size(), bake.materials.size());
  for (std::size_t i = 0; i < bake.objects.size(); ++i) {
    const BakedObject& object = bake.objects[i];
    EXPECT_EQ(model.nodes[i].name, object.name);
    EXPECT_DOUBLE_EQ(model.nodes[i].extras.Get("mass").GetNumberAsDouble(), object.mass);
    std::size_t triangles = 0;
    for (const tinygltf::Primitive& primitive : model.meshes[model.nodes[i].mesh].primitives)
      triangles += model.accessors[primitive.indices].count / 3;
    EXPECT_EQ(triangles, all_triangles(object.mesh).size());
  }
  ASSERT_EQ(model.animations.size(), 1u);
  double end = 0;
  for (const tinygltf::AnimationSampler& sampler : model.animations[0].samplers) {
    EXPECT_EQ(model.accessors[sampler.input].count, model.accessors[sampler.output].count);
    end = std::max(end, model.accessors[sampler.input].maxValues.at(0));
  }
  EXPECT_NEAR(end, bake.times.back() - bake.times.front(), 1e-6);
}

TEST(Glb, DeformedPointsAreMorphTargets) {
  const Bake bake = wall_bake(true);
  const tinygltf::Model model = read_glb(glb_file(bake));
  EXPECT_EQ(model.meshes[0].weights.size(), bake.times.size());
  for (const tinygltf::Primitive& primitive : model.meshes[0].primitives)
    EXPECT_EQ(primitive.targets.size(), bake.times.size());
}

TEST(Export, EveryFormatReportsWhatBrokeScaled) {
  Bake bake = wall_bake();
  for (BakedObject& object : bake.objects) object.broke_scaled.reset();
  EXPECT_EQ(usda_file(bake).find("scaleFactor"), std::string::npos);
  bake.objects[1].broke_scaled.emplace().factor = 0.25;
  EXPECT_EQ(nlohmann::json::parse(bake_json(bake))["objects"][1]["scale_factor"], 0.25);
  EXPECT_EQ(nlohmann::json::parse(bake_json(bake))["objects"][0]["scale_factor"], 1);
  EXPECT_NE(usda_file(bake).find("griffith:scaleFactor = 0.25"), std::string::npos);
  EXPECT_NE(html_player(bake).find("\"brokeScaled\":\"E/16, σ/4\""), std::string::npos);
  const tinygltf::Model model = read_glb(glb_file(bake));
  const auto node = std::ranges::find(model.nodes, bake.objects[1].name, &tinygltf::Node::name);
  ASSERT_NE(node, model.nodes.end());
  EXPECT_EQ(node->extras.Get("scale_factor").GetNumberAsDouble(), 0.25);
}

TEST(BakeJson, ReportsObjectsAndBonds) {
  const Bake bake = wall_bake();
  const auto json = nlohmann::json::parse(bake_json(bake));
  ASSERT_EQ(json["objects"].size(), bake.objects.size());
  ASSERT_EQ(json["bonds"].size(), bake.bonds.size());
  EXPECT_EQ(json["bonds"][0]["area"], bake.bonds[0].area);
  EXPECT_EQ(json["bonds"][0]["a"], bake.objects[bake.bonds[0].a].name);
  EXPECT_TRUE(json["objects"].back()["break_time"].is_null());
}

TEST(BondCsv, HasARowABond) {
  const Bake bake = wall_bake();
  std::istringstream csv(bond_csv(bake));
  std::size_t rows = 0;
  for (std::string line; std::getline(csv, line); ++rows) EXPECT_EQ(std::ranges::count(line, ','), 10) << line;
  EXPECT_EQ(rows, bake.bonds.size() + 1);
}

TEST(Usda, IsBalancedAndNamesEachObjectOnce) {
  const Bake bake = wall_bake(true);
  const std::string text = usda_file(bake);
  std::string open;
  constexpr std::string_view kOpening = "([{", kClosing = ")]}";
  for (std::size_t at = 0; (at = text.find_first_of("()[]{}", at)) != std::string::npos; ++at) {
    if (kOpening.find(text[at]) != std::string_view::npos) {
      open += text[at];
      continue;
    }
    ASSERT_FALSE(open.empty());
    ASSERT_EQ(open.back(), kOpening[kClosing.find(text[at])]);
    open.pop_back();
  }
  EXPECT_EQ(open, "");
  std::multiset<std::string> names;
  constexpr std::string_view kObject = "def Xform \"";
  const auto is_of_word = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  for (std::size_t at = 0; (at = text.find(kObject, at)) != std::string::npos;) {
    at += kObject.size();
    const std::string& name = *names.insert(text.substr(at, text.find('"', at) - at));
    EXPECT_TRUE(!name.empty() && std::ranges::all_of(name, is_of_word)) << name;
  }
  EXPECT_EQ(names.size(), bake.objects.size() + 1);
  for (const BakedObject& object : bake.objects) EXPECT_EQ(names.count(object.name), 1u);
}

TEST(ExportCommand, WritesTheSameFilesWithAnyNumberOfThreads) {
  const auto scene = small_wall_file();
  const auto bytes_with = [&](const std::string& threads) {
    std::string all;
    const auto folder = test_folder();
    std::string outputs;
    for (const char* name : {"run.glb", "run.usda", "run.json", "run.csv"})
      outputs += " -o " + (folder / name).string();
    const Outcome outcome = run_program("export " + scene.string() + " --frames 0:40 --threads " + threads + outputs);
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("run.glb: "));
    EXPECT_THAT(outcome.output, HasSubstr(" 41 frames, "));
    for (const char* name : {"run.glb", "run.usda", "run.json", "run.csv"}) {
      std::stringstream text;
      text << std::ifstream(folder / name, std::ios::binary).rdbuf();
      EXPECT_GT(text.str().size(), 50u) << name;
      all += text.str();
    }
    return all;
  };
  const std::string one = bytes_with("1");
  EXPECT_EQ(one, bytes_with("2"));
  EXPECT_EQ(one, bytes_with("4"));
}

TEST(ExportCommand, BadOutputsAndFramesAreReportedBeforeTheRun) {
  const std::string scene = small_wall_file().string();
  const auto refused = [&](const std::string& arguments, const char* what) {
    const Outcome outcome = run_program("export " + scene + " " + arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.output, HasSubstr(what));
  };
  refused("--frames 0:1000000 -o run.fbx", ".glb, .usda, .html, .json or .csv");
  refused("--frames 0:1000000 -o /no/such/folder/run.glb", "/no/such/folder");
  refused("--frames 5:2 -o " + (test_folder() / "run.glb").string(), "--frames");
  refused("--frames 0,5 -o " + (test_folder() / "run.glb").string(), "is a list");
}

TEST(ExportCommand, ARecordingGivesWhatItsSceneGives) {
  const std::string scene = small_wall_file().string();
  const auto path = [](const char* name) { return (test_folder() / name).string(); };
  const std::string recording = path("run.tar.zst"), a = path("a.json"), b = path("b.json");
  ASSERT_EQ(run_program("simulate " + scene + " --frames 20 --record " + recording).code, 0);
  ASSERT_EQ(run_program("export " + scene + " --frames 0:20 -o " + a).code, 0);
  const Outcome outcome = run_program("export " + recording + " --frames 0:20 -o " + b);
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_EQ(nlohmann::json::parse(std::ifstream(a)), nlohmann::json::parse(std::ifstream(b)));
  EXPECT_EQ(run_program("export " + recording + " --frames 0:21 -o " + b).code, 2);
}

/// The lower corner of the box round a object as it is in a frame.
Vec3 low_corner(const BakedObject& object, std::size_t frame) {
  const bool deformed = !object.deformed_points.empty();
  Eigen::AlignedBox3d box;
  for (const Vec3& point : deformed ? object.deformed_points[frame] : object.mesh.points)
    box.extend(placed(object.poses[frame], point));
  return box.min();
}

/// Compares first and last places of objects, and their last points, as Blender reads them (z is up).
TEST(ExportCommand, BlenderFindsEveryObjectWhereItIs) {
  if (std::system(
          "blender -b --python-expr 'import numpy' 2>&1 | grep -q 'No module' || ! command -v blender >/dev/null") == 0)
    GTEST_SKIP() << "no Blender with numpy";
  for (const bool deformed : {false, true}) {
    const Bake bake = wall_bake(deformed);
    const auto glb = test_file("wall.glb", glb_file(bake)), places = test_folder() / "places.json";
    const std::string script = GRIFFITH_SOURCE_DIR "/tests/app/blender_places.py";
    const std::string command = "blender -b --python " + script + " -- " + glb.string() + " " + places.string() + " " +
                                std::to_string(bake.times.size() - 1) + " >/dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0);
    const auto found = nlohmann::json::parse(std::ifstream(places));
    ASSERT_EQ(found.size(), bake.objects.size());
    const auto expect_at = [&](const BakedObject& object, const char* what, const Vec3& place) {
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(found[object.name][what][i].get<double>(), place[i], 1e-4) << object.name << ' ' << what;
    };
    for (const BakedObject& object : bake.objects) {
      ASSERT_TRUE(found.contains(object.name));
      expect_at(object, "first", object.poses.front().translation);
      expect_at(object, "last", object.poses.back().translation);
      expect_at(object, "last_low", low_corner(object, object.poses.size() - 1));
    }
  }
}

}  // namespace
}  // namespace griffith::app
