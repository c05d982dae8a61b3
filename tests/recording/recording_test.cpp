#include "sim/recording/recording.h"

#include <gtest/gtest.h>

#include "recorded_scenes.h"
#include "sim/core/error.h"
#include "sim/scene/scene_reader.h"
#include "tests/files/test_folder.h"
#include "tests/meshing/surfaces.h"

namespace griffith {
namespace {

using namespace griffith::testing;

TEST(Recording, ComesBackFromItsFileAsItWas) {
  const auto folder = empty_folder();
  Recording recording = record(played(recorded_scenes(folder)[5].scene, 12));
  recording.extras["log.txt"] = "fired\n";
  const Recording read = through_file(recording, folder);
  EXPECT_EQ(read.scene.bodies.size(), recording.scene.bodies.size());
  EXPECT_TRUE(read.inputs == recording.inputs);
  EXPECT_EQ(read.hashes, recording.hashes);
  EXPECT_EQ(read.versions, recording.versions);
  EXPECT_EQ(read.assets, recording.assets);
  EXPECT_EQ(read.extras, recording.extras);
  EXPECT_EQ(version_of(read.versions, "program").substr(0, 9), "griffith ");
}

TEST(Recording, TheSameRunGivesTheSameBytes) {
  const auto folder = empty_folder();
  write_recording(record(played(struck_wall(), 12)), folder / "a");
  write_recording(record(played(struck_wall(), 12)), folder / "b");
  EXPECT_EQ(text_of(folder / "a"), text_of(folder / "b"));
}

TEST(Recording, UnpackedItIsASceneLikeAnyOther) {
  const auto folder = empty_folder();
  for (const auto& [name, scene, steps] : recorded_scenes(folder)) {
    write_files(files_of(begin_recording(World(scene))), folder / name);
    const World world(read_scene(folder / name / "scene.json"));
    EXPECT_EQ(world.frame().elements.tets.size(), World(scene).frame().elements.tets.size()) << name;
  }
}

TEST(Recording, HoldsWhatFilesNameBesideThem) {
  const auto folder = empty_folder();
  written(folder / "block.mtl", "newmtl stone\n");
  written(folder.parent_path() / "secret.mtl", "newmtl secret\n");
  std::string text = "mtllib block.mtl\nmtllib ../secret.mtl\n";
  const TriangleSurface box = box_surface(Vec3(-1, -1, -0.25), Vec3(1, 1, 0.25));
  for (const Vec3& p : box.points)
    text += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + "\n";
  for (const auto& [a, b, c] : box.triangles)
    text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " + std::to_string(c + 1) + "\n";
  SurfaceShape shape;
  shape.path = written(folder / "block.obj", text);
  shape.meshing.element_size = 0.5;
  Scene scene = struck_wall();
  scene.bodies[0].shape = shape;
  const Recording recording = begin_recording(World(scene));
  EXPECT_TRUE(recording.assets.contains("assets/1/block.obj"));
  EXPECT_TRUE(recording.assets.contains("assets/1/block.mtl"));
  EXPECT_TRUE(recording.assets.contains("assets/1/filled.msh"));
  EXPECT_EQ(recording.assets.size(), 3u) << "nothing from elsewhere";
}

/// The error of a recording of the scene; empty where it is made.
std::string refusal(const Scene& scene, OutsideFiles outside = OutsideFiles::refuse) {
  const World world(scene);
  try {
    begin_recording(world, outside);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Recording, FilesFromOutsideTheScenesFolderArePackedOnlyWhenAskedFor) {
  const auto root = empty_folder(), folder = root / "scene";
  std::filesystem::create_directories(folder);
  Scene scene = recorded_scenes(root)[3].scene;
  EXPECT_EQ(refusal(scene), "");
  scene.folder = folder;
  for (const std::string& path : {std::string("../wall.node"), (root / "wall.node").string()}) {
    std::get<MeshFileShape>(scene.bodies[0].shape).path = path;
    EXPECT_NE(refusal(scene).find("--pack-outside"), std::string::npos) << path;
    EXPECT_EQ(refusal(scene, OutsideFiles::pack), "") << path;
  }
  for (const char* name : {"wall.node", "wall.ele"}) std::filesystem::create_symlink(root / name, folder / name);
  std::get<MeshFileShape>(scene.bodies[0].shape).path = "wall.node";
  EXPECT_NE(refusal(scene).find("--pack-outside"), std::string::npos) << "a link";
  scene.folder.clear();
  std::get<MeshFileShape>(scene.bodies[0].shape).path = root / "wall.node";
  EXPECT_EQ(refusal(scene), "") << "who made a scene without a file chose its meshes";
}

TEST(Recording, WhatLinksBesideASurfaceLeadToIsNotPacked) {
  const auto root = empty_folder(), folder = root / "scene";
  std::filesystem::create_directories(folder);
  std::filesystem::create_directories(root / "outside");
  written(root / "outside/secret", "newmtl secret\n");
  std::filesystem::create_symlink("../outside/secret", folder / "materials.mtl");
  std::filesystem::create_directory_symlink("../outside", folder / "sub");
  std::string text = "mtllib materials.mtl\nmtllib sub/secret\n";
  const TriangleSurface box = box_surface(Vec3(-1, -1, -0.25), Vec3(1, 1, 0.25));
  for (const Vec3& p : box.points)
    text += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + "\n";
  for (const auto& [a, b, c] : box.triangles)
    text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " + std::to_string(c + 1) + "\n";
  written(folder / "block.obj", text);
  SurfaceShape shape;
  shape.path = "block.obj";
  shape.meshing.element_size = 0.5;
  Scene scene = struck_wall();
  scene.folder = folder;
  scene.bodies[0].shape = shape;
  const Recording recording = begin_recording(World(scene));
  for (const auto& [name, content] : recording.assets)
    EXPECT_EQ(content.find("newmtl secret"), std::string::npos) << name;
  EXPECT_EQ(recording.assets.size(), 2u) << "the surface and what filled it";
}

TEST(Recording, AFileThatIsGoneIsNamed) {
  const auto folder = empty_folder();
  const World world(recorded_scenes(folder)[3].scene);
  std::filesystem::remove(folder / "wall.node");
  try {
    begin_recording(world);
    FAIL() << "it was read";
  } catch (const InputError& error) {
    EXPECT_NE(error.where().find("wall.node"), std::string::npos);
  }
}

TEST(Recording, EqualVersionsDifferInNothing) {
  const Versions here = versions_here();
  EXPECT_EQ(version_differences(here, here), "");
  Versions there = here;
  there[1].second = "Debug";
  const std::string rows = version_differences(there, here);
  EXPECT_NE(rows.find("Debug"), std::string::npos);
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 2);
}

}  // namespace
}  // namespace griffith
