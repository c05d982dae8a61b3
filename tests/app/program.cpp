#include "tests/app/program.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>

#include "sim/scene/scene_writer.h"

namespace griffith::app {

Outcome run_program(const std::string& arguments, const std::string& before) {
  const std::string command = before + " " GRIFFITH_PROGRAM " " + arguments + " 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  Outcome outcome;
  std::array<char, 4096> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    outcome.output.append(buffer.data(), count);
  }
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return outcome;
}

std::filesystem::path test_folder() {
  const ::testing::TestInfo* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) /
                                       ("griffith_" + std::string(test->test_suite_name()) + "_" + test->name());
  std::filesystem::create_directories(folder);
  return folder;
}

std::filesystem::path test_file(const std::string& name, const std::string& text) {
  const std::filesystem::path path = test_folder() / name;
  std::ofstream(path) << text;
  return path;
}

void fill_surface(Scene& scene, const std::string& file) {
  scene.folder = test_folder();
  SurfaceShape shape;
  shape.path = file;
  shape.meshing.method = MeshingMethod::volumetric;
  shape.meshing.element_size = 0.5;
  scene.bodies[0].shape = shape;
}

Scene small_wall() {
  BodyDescription wall;
  wall.name = "wall";
  wall.shape = BoxShape{Vec3(2, 2, 0.5), Vec3::Constant(0.5), BoxPattern::five_tet};
  wall.position = Vec3(0, 1, 0);
  wall.supports = {{BoxRegion{Vec3(-1, -1, -0.25), Vec3(1, -1, 0.25)}}};
  ProjectileBurst shot;
  shot.position = Vec3(0, 1.2, 1);
  Scene scene;
  scene.name = "small wall";
  scene.bodies = {wall};
  scene.projectiles = {shot};
  scene.cameras = {{"front", Vec3(2, 2, 5), Vec3(0, 1, 0), 40}, {"side", Vec3(6, 1, 0.5), Vec3(0, 1, 0), 40}};
  return scene;
}

std::filesystem::path small_wall_file() {
  const std::filesystem::path path = test_folder() / "small_wall.json";
  write_scene(small_wall(), path);
  return path;
}

}  // namespace griffith::app
