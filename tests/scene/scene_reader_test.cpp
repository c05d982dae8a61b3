#include "sim/scene/scene_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "problems.h"

namespace griffith {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

struct Malformed {
  const char* text;
  const char* where;
  const char* what;  ///< part of the problem or the remedy
};

void expect_reported(std::initializer_list<Malformed> documents) {
  for (const Malformed& malformed : documents) {
    SCOPED_TRACE(malformed.text);
    const auto problems = problems_of(malformed.text);
    ASSERT_EQ(problems.size(), 1u) << testing::PrintToString(places(problems));
    EXPECT_EQ(problems[0].where(), malformed.where);
    EXPECT_THAT(problems[0].what(), HasSubstr(malformed.what));
    EXPECT_THROW(scene_from_json(malformed.text), InputError);
  }
}

TEST(SceneReader, ReportsWhatIsNoJsonByLineAndColumn) {
  expect_reported({{"", "doc:1:1", "unexpected end of input"},
                   {"{\"version\": 1,\n \"name\": }", "doc:2:10", "unexpected '}'"},
                   {"{\"version\": 1,\n\n\"gravity\": [0, 1e400, 0]}", "doc:3:20", "number overflow"},
                   {"{\"version\": 1, \"gravity\": [0, NaN, 0]}", "doc:1:31", "invalid literal"},
                   {"{\"version\": 1} x", "doc:1:16", "invalid literal"},
                   {"{\"version\": 1, \"name\": \"\xff\"}", "doc:1:25", "UTF-8"},
                   {"[1, 2]", "doc", "expected an object"},
                   {"7", "doc", "is 7"},
                   {"null", "doc", "expected an object"}});
}

TEST(SceneReader, ReadsNamesOfOlderFilesAndReportsThoseOfToday) {
  const auto path = std::filesystem::path(::testing::TempDir()) / "older.json";
  std::ofstream(path) << R"({"version": 1, "name": "older", "view": {"quantity": "margin"}})";
  EXPECT_EQ(read_scene(path).view.quantity, "utilization");
  EXPECT_TRUE(check_scene(path).empty());
  const std::vector<InputError> outdated = outdated_names(path);
  ASSERT_EQ(outdated.size(), 1u);
  EXPECT_THAT(outdated[0].where(), HasSubstr("older.json#/view/quantity"));
  EXPECT_THAT(outdated[0].what(), HasSubstr("\"utilization\""));
}

TEST(SceneReader, ReportsAVersionThatItCannotRead) {
  expect_reported({{"{}", "doc#/version", "is missing"},
                   {R"({"version": 2, "bodies": 7})", "doc#/version", "newer than this program"},
                   {R"({"version": "1"})", "doc#/version", "the number 1"},
                   {R"({"version": 0})", "doc#/version", "the number 1"}});
}

TEST(SceneReader, ReportsNamesThatAreUnknownOrTaken) {
  expect_reported(
      {{R"({"version": 1, "bodies": [{}, {"name": "a"}, {}]})", "doc#/bodies/2", "\"body\", as item 0 has"},
       {R"({"version": 1, "cameras": [{"name": "a"}, {"name": "a"}]})", "doc#/cameras/1", "of its own"},
       {R"({"version": 1, "name": "a", "bodies": [], "name": "b"})", "doc#/name", "appears twice"},
       {R"({"version": 1, "view": {"edges": true, "edges": true}})", "doc#/view/edges", "appears twice"},
       {R"({"version": 1, "bodies": [{}, {"name": "a/b", "name": "~"}]})", "doc#/bodies/1/name", "twice"},
       {R"({"version": 1, "a/b~c": 1})", "doc#/a~1b~0c", "is not a known field"},
       {R"({"version": 1, "bodies": [{"material": "brik"}]})", "doc#/bodies/0/material", "mean \"brick\"?"},
       {R"({"version": 1, "bodies": [{"material": {"preset": "x"}}]})", "doc#/bodies/0/material/preset",
        "\"soda_lime_glass\""},
       {R"({"version": 1, "materials": {"mine": {}}, "bodies": [{"material": "unobtainium"}]})",
        "doc#/bodies/0/material", "\"mine\""},
       {R"({"version": 1, "materials": {"brick": {}}})", "doc#/materials/brick", "another name"},
       {R"({"version": 1, "materials": {"mine": {"name": "a"}}})", "doc#/materials/mine/name", "not a known"}});
}

TEST(SceneReader, ReportsValuesThatCannotBe) {
  expect_reported(
      {{R"({"version": 1, "bodies": [{"shape": {}}]})", "doc#/bodies/0/shape", "exactly one"},
       {R"({"version": 1, "bodies": [{"shape": {"box": {}, "mesh": {"path": "a"}}}]})", "doc#/bodies/0/shape",
        "has 2 of"},
       {R"({"version": 1, "bodies": [{"shape": {"mesh": {}}}]})", "doc#/bodies/0/shape/mesh", "\"path\""},
       {R"({"version": 1, "bodies": [{"shape": {"box": {"size": 3}}}]})", "doc#/bodies/0/shape/box/size",
        "an array of 3 numbers, each from 0.0001 to 100000 m"},
       {R"({"version": 1, "bodies": [{"shape": {"box": {"size": [1, 1, 1e5], "element_size": 0.001}}}]})",
        "doc#/bodies/0/shape/box/element_size", "2 million"},
       {R"({"version": 1, "bodies": [{"supports": [{"region": {"box": {"minimum": [0, 1, 0]}}}]}]})",
        "doc#/bodies/0/supports/0/region/box", "maximum is below the minimum"},
       {R"({"version": 1, "bodies": [{"supports": [{"velocity": [0, 1, 0]}]}]})", "doc#/bodies/0/supports/0/velocity",
        "\"kind\": \"prescribed\""},
       {R"({"version": 1, "bodies": [{"loads": [{"kind": "traction", "pressure": 7}]}]})",
        "doc#/bodies/0/loads/0/pressure", "\"kind\": \"pressure\""},
       {R"({"version": 1, "bodies": [{"shape": {"plate_with_hole": {"hole_radius": 1}}}]})",
        "doc#/bodies/0/shape/plate_with_hole/hole_radius", "less than half"},
       {R"({"version": 1, "bodies": [{"material": {"tensile_strength": 2e6, "compressive_strength": 1e6}}]})",
        "doc#/bodies/0/material/compressive_strength", "below the tensile strength"},
       {R"({"version": 1, "bodies": [{"shape": {"notched_beam": {"notch_depth": 1}}}]})",
        "doc#/bodies/0/shape/notched_beam/notch_depth", "height"},
       {R"({"version": 1, "probes": [{"quantities": ["stress", "strain"]}]})", "doc#/probes/0/quantities/1",
        "\"principal_stress\""},
       {R"({"version": 1, "probes": [{"at": {"node": 1, "point": [0, 0, 0]}}]})", "doc#/probes/0/at", "has 2 of"},
       {R"({"version": 1, "projectiles": [{"direction": [0, 0, 0]}]})", "doc#/projectiles/0/direction", "other than 0"},
       {R"({"version": 1, "projectiles": [{"direction": [1e-200, 0, 0]}]})", "doc#/projectiles/0/direction",
        "other than 0"},
       {R"({"version": 1, "projectiles": [{"mass": 0}]})", "doc#/projectiles/0/mass",
        "is 0 (expected a number from 1e-06 to 1e+09 kg)"},
       {R"({"version": 1, "projectiles": [{"count": 1.5}]})", "doc#/projectiles/0/count", "whole number"},
       {R"({"version": 1, "view": {"range": [1, 1]}})", "doc#/view/range", "low less than high"},
       {R"({"version": 1, "view": {"range": [0, 1, 2]}})", "doc#/view/range", "2 numbers"},
       {R"({"version": 1, "view": {"quantity": "vonmises"}})", "doc#/view/quantity", "mean \"von_mises\"?"},
       {R"({"version": 1, "cameras": [{"position": [1, 2, 3], "target": [1, 2, 3]}]})", "doc#/cameras/0/target",
        "own position"}});
}

TEST(SceneReader, RefusesWhatTheSchemaRefuses) {
  std::ifstream stream(GRIFFITH_SOURCE_DIR "/tests/scene/malformed.json");
  for (const Json& malformed : Json::parse(stream)) {
    const auto where = places(problems_of(malformed["scene"].dump()));
    EXPECT_EQ(where, std::vector{"doc#" + malformed["where"].get<std::string>()}) << malformed;
  }
}

TEST(SceneReader, ReportsEveryProblemAndNoConsequences) {
  const auto problems = problems_of(R"({"version": 1, "gravity": [0, "x", true], "groud": null,
    "bodies": [{"shape": {"box": {"size": [1, -1, 1], "patern": 1}}, "material": {"density": 0, "preset": "glas"}}],
    "projectiles": {}, "simulation": {"time_step": 1}})");
  EXPECT_THAT(places(problems), testing::UnorderedElementsAre(
                                    "doc#/gravity/1", "doc#/gravity/2", "doc#/groud", "doc#/bodies/0/shape/box/size/1",
                                    "doc#/bodies/0/shape/box/patern", "doc#/bodies/0/material/density",
                                    "doc#/bodies/0/material/preset", "doc#/projectiles", "doc#/simulation/time_step"));
}

TEST(SceneReader, AMissingMeshIsNamedWithThePathThatWasTried) {
  const char* text = R"({"version": 1, "bodies": [{"shape": {"mesh": {"path": "meshes/../no_such"}}}]})";
  try {
    scene_from_json(text, "doc", "/some/folder");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), "doc#/bodies/0/shape/mesh/path");
    EXPECT_THAT(error.problem(), HasSubstr("\"/some/folder/no_such\""));
  }
}

TEST(SceneReader, ALinkToAMeshDoesNotLeadOutOfItsFolder) {
  namespace fs = std::filesystem;
  const fs::path root = fs::path(::testing::TempDir()) / "griffith_scene_links", folder = root / "scene";
  fs::remove_all(root);
  fs::create_directories(folder / "pair");
  for (const char* name : {"secret", "scene/near.msh", "near.node"}) std::ofstream(root / name) << "secret";
  fs::create_symlink("../secret", folder / "far.msh");
  fs::create_symlink("near.msh", folder / "link.msh");
  for (const char* name : {"pair/verts.csv", "half.ele"}) fs::create_symlink(root / "secret", folder / name);
  for (const char* name : {"pair/tets.csv", "half.node"}) std::ofstream(folder / name) << "0";
  const auto problem = [&](const std::string& path) {
    const std::string mesh = R"({"version": 1, "bodies": [{"shape": {"mesh": {"path": ")" + path + "\"}}}]}";
    try {
      return scene_from_json(mesh, "doc", folder), std::string();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  for (const char* path : {"far.msh", "pair", "half.node"})
    EXPECT_THAT(problem(path), HasSubstr("a link that leads out of its folder")) << path;
  for (const char* path : {"near.msh", "link.msh", "../scene/near.msh"}) EXPECT_EQ(problem(path), "") << path;
  EXPECT_EQ(problem((folder / "near.msh").string()), "") << "a path says where it leads";
}

TEST(SceneReader, WhatIsNoReadableFileIsNamed) {
  EXPECT_THROW(read_scene(""), InputError);
  EXPECT_EQ(check_scene("").size(), 1u);
  for (const std::string path : {"no/such.json", GRIFFITH_SOURCE_DIR "/scenes", "/dev/null"}) {
    const auto problems = check_scene(path);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].where(), path);
    EXPECT_THROW(read_scene(path), InputError);
  }
}

TEST(SceneReader, ReadsMaterialsInEveryForm) {
  const Scene scene = scene_from_json(R"({"version": 1,
    "materials": {"weak glass": {"preset": "soda_lime_glass", "tensile_strength": 1e6}},
    "bodies": [{"name": "a", "material": "ice"}, {"name": "b", "material": "weak glass"},
               {"name": "c", "material": {"density": 1000, "criterion": "separation_force"}},
               {"name": "d", "material": {"preset": "ice", "name": "snow", "density": 300}}, {"name": "e"}]})");
  EXPECT_EQ(scene.bodies[0].material, find_material_preset("ice"));
  Material weak_glass = *find_material_preset("soda_lime_glass");
  weak_glass.name = "weak glass";
  weak_glass.tensile_strength = 1e6;
  EXPECT_EQ(scene.bodies[1].material, weak_glass);
  EXPECT_EQ(scene.bodies[2].material.criterion, FractureCriterion::separation_force);
  EXPECT_EQ(scene.bodies[2].material.density, 1000);
  EXPECT_EQ(scene.bodies[3].material.name, "snow");
  EXPECT_EQ(scene.bodies[3].material.young_modulus, find_material_preset("ice")->young_modulus);
  EXPECT_EQ(scene.bodies[4].material, Material{});
}

TEST(SceneReader, ReadsShapesRegionsAndNothings) {
  const Scene scene = scene_from_json(R"({"version": 1, "ground": null, "view": {"range": [-1, 2.5]}, "bodies": [
    {"shape": {"box": {"element_size": 0.25, "pattern": "bcc"}}, "supports": [{"region": {"nodes": [3, 1.0]}},
     {"region": {"sphere": {"center": [1, 2, 3], "radius": 4}}},
     {"region": {"half_space": {"normal": [1, 0, 0]}}}]}]})");
  EXPECT_FALSE(scene.ground);
  EXPECT_EQ(scene.view.range, Vec2(-1, 2.5));
  const BodyDescription& body = scene.bodies.at(0);
  EXPECT_EQ(std::get<BoxShape>(body.shape), (BoxShape{Vec3::Ones(), Vec3::Constant(0.25), BoxPattern::bcc}));
  EXPECT_EQ(std::get<NodeListRegion>(body.supports.at(0).region).nodes, (std::vector{3, 1}));
  EXPECT_EQ(std::get<SphereRegion>(body.supports.at(1).region), (SphereRegion{Vec3(1, 2, 3), 4}));
  EXPECT_EQ(std::get<HalfSpaceRegion>(body.supports.at(2).region).normal, Vec3::UnitX());
}

TEST(SceneReader, ReadsSupportsLoadsAndProbes) {
  const Scene scene = scene_from_json(R"({"version": 1, "analysis": "static", "simulation": {"integrator": "explicit"},
    "bodies": [{"supports": [{"kind": "prescribed", "velocity": [0, -1, 0], "stop": 2}],
                "loads": [{"kind": "pressure", "pressure": 5, "region": {"nodes": [1]}, "ramp": 3}]}],
    "probes": [{"at": {"region": {"sphere": {"radius": 2}}}, "quantities": ["stress", "reaction"]}]})");
  EXPECT_EQ(scene.analysis, Analysis::static_);
  EXPECT_EQ(scene.simulation.integrator, Integrator::explicit_);
  Support support;
  support.kind = SupportKind::prescribed;
  support.velocity = -Vec3::UnitY();
  support.stop = 2;
  EXPECT_EQ(scene.bodies[0].supports.at(0), support);
  Load load;
  load.region = NodeListRegion{{1}};
  load.kind = LoadKind::pressure;
  load.pressure = 5;
  load.ramp = 3;
  EXPECT_EQ(scene.bodies[0].loads.at(0), load);
  EXPECT_EQ(std::get<Region>(scene.probes.at(0).at), Region(SphereRegion{Vec3::Zero(), 2}));
  EXPECT_EQ(scene.probes[0].quantities, (std::vector<std::string>{"stress", "reaction"}));
}

TEST(SceneReader, SurvivesRandomDamage) {
  std::ifstream stream(GRIFFITH_SOURCE_DIR "/scenes/materials.json");
  const std::string whole{std::istreambuf_iterator<char>(stream), {}};
  ASSERT_GT(whole.size(), 1000u);
  std::mt19937 random(7);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string text = whole;
    for (int hits = 1 + i % 4; hits > 0; --hits) {
      const std::size_t at = random() % text.size();
      if (random() % 3 == 0)
        text.erase(at, random() % 50);
      else
        text[at] = static_cast<char>(random());
    }
    for (const InputError& problem : problems_of(text)) {
      EXPECT_TRUE(problem.where().starts_with("doc"));
      EXPECT_FALSE(problem.problem().empty() || problem.remedy().empty());
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
}

/// A list of `count` items, each `item` with its number in place of #.
std::string list_of(int count, const std::string& item) {
  std::string text = "[";
  for (int i = 0; i < count; ++i) {
    const std::size_t sign = item.find('#');
    text += (i > 0 ? "," : "") + item.substr(0, sign);
    if (sign != std::string::npos) text += std::to_string(i) + item.substr(sign + 1);
  }
  return text + "]";
}

TEST(SceneReader, LimitsHoldForTheWholeScene) {
  const auto with = [](const std::string& field, const std::string& list) {
    return problems_of("{\"version\": 1, \"" + field + "\": " + list + "}");
  };
  const std::string box = R"({"name": "#", "shape": {"box": {"size": [5, 5, 5], "element_size": 0.1}}})";  // 625,000
  EXPECT_THAT(with("bodies", list_of(6, box)), testing::IsEmpty());
  EXPECT_THAT(with("bodies", list_of(7, box)).at(0).problem(), HasSubstr("4 million tetrahedra in total"));
  EXPECT_THAT(with("projectiles", list_of(2, R"({"count": 5000})")), testing::IsEmpty());
  EXPECT_THAT(with("projectiles", list_of(3, R"({"count": 5000})")).at(0).problem(), HasSubstr("10,000 in total"));
  for (const char* field : {"bodies", "projectiles", "probes", "cameras"}) {
    const auto problems = with(field, list_of(10'001, "{}"));
    EXPECT_EQ(places(problems), std::vector{std::string("doc#/") + field});
    EXPECT_THAT(problems.at(0).problem(), HasSubstr("more than 10,000 items"));
  }
}

TEST(SceneReader, OfCountlessProblemsTheFirstAreReported) {
  const auto problems = problems_of("{\"version\": 1, \"bodies\": " + list_of(9000, "0") + "}");
  EXPECT_EQ(problems.size(), 1001u);
  EXPECT_THAT(problems.back().problem(), HasSubstr("more problems"));
}

TEST(SceneReader, MoreValuesThanAnySceneHasAreRefused) {
  std::string text = "{\"version\": 1, \"bodies\": [[]";
  for (int i = 0; i < 3'000'000; ++i) text += ",[]";
  EXPECT_THAT(problems_of(text + "]}").at(0).problem(), HasSubstr("more values than"));
}

TEST(SceneReader, RefusesAbsurdNestingAndAcceptsManyFields) {
  EXPECT_THAT(problems_of(std::string(1000000, '['))[0].problem(), HasSubstr("64 levels"));
  std::string text = R"({"version": 1, "materials": {)";
  for (int i = 0; i < 20000; ++i) text += (i ? ",\"m" : "\"m") + std::to_string(i) + "\": {}";
  EXPECT_THAT(problems_of(text + "}}"), testing::IsEmpty());
}

}  // namespace
}  // namespace griffith
