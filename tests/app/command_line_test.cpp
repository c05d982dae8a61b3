#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"
#include "sim/scene/scene_writer.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(CommandLine, HelpAndVersionSucceed) {
  for (const char* arguments : {"--help", "render --help", "simulate --help", "check --help", "mesh --help"}) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 0) << arguments;
    EXPECT_THAT(outcome.output, HasSubstr("Example")) << arguments;
  }
  const Outcome version = run_program("--version");
  EXPECT_EQ(version.code, 0);
  EXPECT_THAT(version.output, ::testing::MatchesRegex("griffith [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(CommandLine, HelpFitsIntoATerminal) {
  for (const char* command : {"", "bench", "bundle", "check", "export", "find", "mesh", "regress", "render", "replay",
                              "script", "simulate", "sweep", "thumbnail"}) {
    const Outcome outcome = run_program(command + std::string(" --help"));
    EXPECT_THAT(outcome.output, Not(HasSubstr("Excludes:"))) << command;
    std::istringstream lines(outcome.output);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 124u) << command << ": " << line;
  }
}

TEST(CommandLine, BadUsageIsExitCode2WithAMessage) {
  const std::string scene = small_wall_file().string();
  const std::vector<std::string> bad = {"render",
                                        "render " + scene,
                                        "simulate " + scene,
                                        "simulate " + scene + " --frames -1",
                                        "simulate " + scene + " --frames 1 --threads 0",
                                        "render " + scene + " -o a.png --size 10",
                                        "render " + scene + " -o a.png --size 0x50",
                                        "render " + scene + " -o a.png --size 50x50x50",
                                        "render " + scene + " -o a.png --every 0",
                                        "--nonsense",
                                        "check",
                                        "mesh",
                                        "mesh a.obj",
                                        "mesh a.obj -o a.msh --method quick",
                                        "mesh a.obj -o a.msh --element-size 0",
                                        "mesh a.obj -o a.stl"};
  for (const std::string& arguments : bad) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments << "\n" << outcome.output;
    EXPECT_FALSE(outcome.output.empty()) << arguments;
  }
}

TEST(CommandLine, HelpIsACommandToo) {
  for (const std::string command : {"", "render ", "gallery "}) {
    const Outcome outcome = run_program("help " + command);
    EXPECT_EQ(outcome.code, 0) << command;
    EXPECT_EQ(outcome.output, run_program(command + "--help").output) << command;
  }
}

TEST(CommandLine, MissingFileIsExitCode2AndNamed) {
  for (const char* arguments : {"simulate no_such.json --frames 1", "render no_such.json -o a.png",
                                "check no_such.json", "no_such.json", "mesh no_such.json -o a.msh"}) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_THAT(outcome.output, HasSubstr("no_such.json")) << arguments;
  }
}

TEST(CommandLine, ASlipInTheNameOfACommandIsDistinguishedFromAMissingScene) {
  for (const char* arguments : {"frobnicate", "rende scene.json -o a.png"}) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.output, HasSubstr("is neither a command nor a scene file")) << arguments;
    EXPECT_THAT(outcome.output, HasSubstr("the commands are render, simulate, check")) << arguments;
  }
  const Outcome missing = run_program("my/wall.json");
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.output, HasSubstr("my/wall.json: there is no such scene file"));
  EXPECT_THAT(missing.output, HasSubstr("sample scenes are in"));
}

TEST(CommandLine, CheckWarnsOfBodiesThatStartInsideOneAnother) {
  const auto path = test_file("inside.json", R"({"version": 1, "ground": {}, "bodies": [
      {"name": "left", "shape": {"box": {"size": [1, 1, 1], "element_size": 0.5}}, "position": [0, 0.5, 0]},
      {"name": "right", "shape": {"box": {"size": [1, 1, 1], "element_size": 0.5}}, "position": [0.8, 0.5, 0]},
      {"name": "sunk", "shape": {"box": {"size": [1, 1, 1], "element_size": 0.5}}, "position": [5, 0.2, 0]}]})");
  const Outcome outcome = run_program("check " + path.string());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.output, HasSubstr("\"right\" starts 0.2 m inside \"left\""));
  EXPECT_THAT(outcome.output, HasSubstr("inside.json#/bodies/2/position: \"sunk\" starts 0.3 m under the ground"));
}

TEST(CommandLine, BadSceneIsExitCode2WithThePlaceOfEachProblem) {
  const auto path = test_file("bad.json", R"({"version": 1, "gravity": "down", "bodies": [
      {"name": "a", "shape": {"box": {"size": [1, 1, -1]}}}]})");
  const Outcome simulated = run_program("simulate --frames 1 " + path.string());
  EXPECT_EQ(simulated.code, 2);
  EXPECT_THAT(simulated.output, HasSubstr("#/gravity"));
  const Outcome checked = run_program("check " + path.string() + " " + small_wall_file().string());
  EXPECT_EQ(checked.code, 2);
  EXPECT_THAT(checked.output, HasSubstr("#/gravity"));
  EXPECT_THAT(checked.output, HasSubstr("#/bodies/0/shape/box/size"));
  EXPECT_THAT(checked.output, HasSubstr("small_wall.json: valid"));
}

TEST(CommandLine, ABadMeshIsReportedWithSceneBodyFileAndLine) {
  test_file("bad.node", "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 one 0\n3 0 0 1\n");
  test_file("bad.ele", "1 4 0\n0 0 1 2 3\n");
  const auto path = test_file("meshed.json", R"({"version": 1, "bodies": [{"name": "floor"},
      {"name": "rock", "position": [0, 3, 0], "shape": {"mesh": {"path": "bad.node"}}}]})");
  for (const std::string command : {"check ", "simulate --frames 1 "}) {
    const Outcome outcome = run_program(command + path.string());
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.output, HasSubstr("meshed.json#/bodies/1/shape/mesh: of \"rock\": "));
    EXPECT_THAT(outcome.output, HasSubstr("bad.node:4: found one"));
  }
}

/// A house: a hexahedron, a roof of two tets on its diagonal, and a triangle.
constexpr char kHouse[] =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 "
    "1\n8 0 1 1\n9 0.5 0.5 2\n$EndNodes\n$Elements\n4\n1 5 2 1 1 1 2 3 4 5 6 7 8\n2 4 2 1 1 6 7 8 9\n3 4 2 1 1 6 8 5 "
    "9\n4 2 2 1 1 1 2 3\n$EndElements\n";

TEST(CommandLine, WhatIsSplitAndSkippedOfAMeshIsReportedByEveryCommand) {
  test_file("house.msh", kHouse);
  Scene scene;
  scene.folder = test_folder();
  scene.bodies.resize(1);
  scene.bodies[0].name = "house";
  scene.bodies[0].shape = MeshFileShape{.path = "house.msh"};
  scene.bodies[0].position = Vec3(0, 0.01, 0);
  scene.bodies[0].material.density = 2400;
  scene.ground.reset();
  write_scene(scene, test_folder() / "house.json");
  const std::string file = (test_folder() / "house.json").string(), out = (test_folder() / "out").string();
  for (const std::string& command : {"check " + file, "simulate " + file + " --frames 0 --stats " + out + ".json",
                                     "render " + file + " --size 64x48 -o " + out + ".png",
                                     "render " + file + " --ui --size 640x400 -o " + out + ".png",
                                     "export " + file + " --frames 0:1 -o " + out + ".glb"}) {
    const Outcome outcome = run_program(command);
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("1 hexahedron split into 6 tetrahedra; no volume is skipped"), std::string::npos)
        << command << "\n"
        << outcome.output;
    EXPECT_NE(outcome.output.find("1 triangle skipped: no volume"), std::string::npos) << command;
  }
  EXPECT_NEAR(nlohmann::json::parse(std::ifstream(out + ".json"))["mass"].get<double>(), 3200, 1e-9);
}

TEST(CommandLine, UnknownQuantityAndCameraListWhatThereIs) {
  const std::string render = "render " + small_wall_file().string() + " -o " + (test_folder() / "a.png").string();
  const Outcome view = run_program(render + " --view beauty");
  EXPECT_EQ(view.code, 2);
  EXPECT_THAT(view.output, HasSubstr("von_mises"));
  const Outcome camera = run_program(render + " --camera above");
  EXPECT_EQ(camera.code, 2);
  EXPECT_THAT(camera.output, HasSubstr("front, side"));
}

TEST(CommandLine, EditorWithoutDisplaySaysWhatToDoInstead) {
  const Outcome outcome = run_program("", "env -u DISPLAY -u WAYLAND_DISPLAY");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("griffith render"));
}

/// A run of so many steps would take hours.
TEST(CommandLine, AnOutputThatCannotBeWrittenIsReportedBeforeTheWork) {
  const std::string scene = small_wall_file().string();
  const std::string file = test_file("file", "").string();
  std::vector<std::string> bad = {"render --frame 9000000 -o /no/such/a.png " + scene,
                                  "render --frame 9000000 --every 9 -o /no/such/a.png " + scene,
                                  "simulate --frames 9000000 --export-pieces " + file + "/a " + scene,
                                  "mesh no_such.obj -o /no/such/a.msh",
                                  "mesh no_such.obj -o a.msh --report /no/such/a.json"};
  for (const char* option : {"--stats /no/such/a.json", "--probes /no/such/a.csv", "--events /no/such/a.json",
                             "--export /no/such/a.vtu", "--stats /dev"})
    bad.push_back("simulate --frames 9000000 " + std::string(option) + " " + scene);
  for (const std::string& arguments : bad) {
    const Outcome outcome = run_program(arguments, "timeout 20");
    EXPECT_EQ(outcome.code, 2) << arguments << outcome.output;
    EXPECT_THAT(outcome.output, ::testing::AnyOf(HasSubstr("/a"), HasSubstr("/dev: is a folder"))) << arguments;
  }
}

TEST(CommandLine, AnOutputThatFailsKeepsNoOtherFromBeingWritten) {
  const auto stats = test_folder() / "stats.json";
  std::filesystem::remove(stats);
  const Outcome outcome = run_program("simulate --frames 1 --events /dev/full --stats " + stats.string() + " " +
                                      small_wall_file().string());
  EXPECT_EQ(outcome.code, 2) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("/dev/full: cannot be written: No space left on device"));
  EXPECT_TRUE(std::filesystem::exists(stats));
}

TEST(CommandLine, AStdoutThatIsFullIsAnError) {
  const std::string scene = small_wall_file().string();
  for (const std::string& arguments :
       {"simulate --frames 1 " + scene, "check " + scene, std::string("--version"), std::string("render --help")}) {
    EXPECT_EQ(run_program(arguments + " > /dev/full").code, 2) << arguments;
  }
  EXPECT_EQ(run_program("check " + scene + " > /dev/null").code, 0);
}

TEST(CommandLine, PipesAndDevicesAreNoInput) {
  const auto pipe = test_folder() / "pipe.obj";
  std::filesystem::remove(pipe);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const auto scene = test_file("pipe.json", R"({"version": 1, "bodies": [
      {"name": "a", "shape": {"mesh": {"path": "/dev/zero"}}}, {"name": "b", "shape": {"surface": {"path": "pipe.obj"}}}]})");
  for (const std::string& arguments :
       {"check " + pipe.string(), "simulate --frames 1 " + pipe.string(), "check " + scene.string(),
        std::string("check /dev/zero"), "mesh " + pipe.string() + " -o " + (test_folder() / "a.msh").string()}) {
    const Outcome outcome = run_program(arguments, "timeout 20");
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_THAT(outcome.output, HasSubstr("is not a regular file")) << arguments;
  }
}

TEST(CommandLine, AMissingTetgenIsReported) {
  const auto bin = test_folder() / "bin";
  std::filesystem::create_directories(bin);
  if (!std::filesystem::exists(bin / "stdbuf")) std::filesystem::create_symlink("/usr/bin/stdbuf", bin / "stdbuf");
  const std::string cache = (test_folder() / "cache").string();
  const Outcome outcome = run_program("check " GRIFFITH_SOURCE_DIR "/scenes/vase_shot.json",
                                      "PATH=" + bin.string() + " XDG_CACHE_HOME=" + cache);
  EXPECT_THAT(outcome.output, HasSubstr("TetGen is not installed"));
}

TEST(CommandLine, AMissingFolderForTemporaryFilesIsReported) {
  const Outcome outcome = run_program("check " GRIFFITH_SOURCE_DIR "/scenes/vase_shot.json",
                                      "TMPDIR=/no/such/folder XDG_CACHE_HOME=" + (test_folder() / "cache").string());
  EXPECT_EQ(outcome.code, 2) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("TMPDIR: names no folder"));
}

TEST(CommandLine, NoProgressWhereThereIsNoTerminal) {
  const Outcome outcome = run_program("simulate --frames 20 " + small_wall_file().string());
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, Not(HasSubstr("\r")));
  EXPECT_THAT(outcome.output, HasSubstr("20 steps"));
}

}  // namespace
}  // namespace griffith::app
