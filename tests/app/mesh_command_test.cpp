#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "program.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/read_mesh.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kTetrahedron[] = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

/// Meshes a tetrahedron of a sixth of a litre into `output`, with a cache of the test's own.
Outcome mesh_tetrahedron(const std::string& output, const std::string& options = "") {
  const auto surface = test_file("tetrahedron.off", kTetrahedron);
  return run_program("mesh " + surface.string() + " --scale 0.1 --element-size 0.005 --method volumetric -o " +
                         (test_folder() / output).string() + " " + options,
                     "XDG_CACHE_HOME=" + (test_folder() / "cache").string());
}

double volume_of(const std::string& file) {
  TetSoup soup = read_mesh(test_folder() / file);
  return prepare(soup).volume;
}

TEST(MeshCommand, WritesTheSameMeshInEveryFormat) {
  for (const char* output : {"a.msh", "a.vtu", "a.node"}) {
    const Outcome outcome = mesh_tetrahedron(output);
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("dihedral angles"));
    EXPECT_NEAR(volume_of(output), 1e-3 / 6, 0.1e-3 / 6);
    EXPECT_EQ(volume_of(output), volume_of("a.msh"));
  }
}

TEST(MeshCommand, ReportIsJsonAndTheCacheIsUsedUnlessForbidden) {
  const auto report = test_folder() / "report.json";
  const auto read = [&](const std::string& options) {
    const Outcome outcome = mesh_tetrahedron("a.msh", "--report " + report.string() + " " + options);
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    return nlohmann::json::parse(std::ifstream(report));
  };
  std::filesystem::remove_all(test_folder() / "cache");
  const auto first = read(""), second = read(""), third = read("--no-cache");
  EXPECT_EQ(first["method"], "volumetric");
  EXPECT_GT(first["mesh"]["tets"], 50);
  EXPECT_GT(first["mesh"]["min_dihedral_angle"], 10.7);
  EXPECT_EQ(first["surface"]["triangles"], 4);
  EXPECT_EQ(first["from_cache"], false);
  EXPECT_EQ(second["from_cache"], true);
  EXPECT_EQ(third["from_cache"], false);
  EXPECT_EQ(first["mesh"], second["mesh"]);
}

constexpr char kTets[] =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n$EndNodes\n"
    "$Elements\n2\n1 7 2 1 1 1 2 3 4 5\n2 2 2 1 1 1 2 3\n$EndElements\n";

TEST(MeshCommand, TetsNeedNoFillingAndTheirQualityIsReported) {
  const auto mesh = test_file("pyramid.msh", kTets);
  const Outcome told = run_program("mesh " + mesh.string());
  EXPECT_EQ(told.code, 0) << told.output;
  EXPECT_THAT(told.output, HasSubstr("scenes can use the file as the shape {\"mesh\": {\"path\": \"pyramid.msh\"}}"));
  EXPECT_THAT(told.output, HasSubstr("dihedral angles"));
  EXPECT_THAT(told.output, HasSubstr("pyramid.msh: 1 pyramid split into 2 tetrahedra; no volume is skipped"));
  EXPECT_THAT(told.output, HasSubstr("1 triangle skipped: no volume"));
  const Outcome converted =
      run_program("mesh " + mesh.string() + " --scale 2 -o " + (test_folder() / "b.vtu").string());
  EXPECT_EQ(converted.code, 0) << converted.output;
  EXPECT_NEAR(volume_of("b.vtu"), 8.0 / 3, 1e-12);
}

TEST(MeshCommand, AFileOfAnotherContentIsRefusedByName) {
  const auto refusal = [](const std::string& name, const std::string& text) {
    const Outcome outcome = run_program("mesh " + test_file(name, text).string());
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    return outcome.output;
  };
  EXPECT_THAT(refusal("a.obj", "version https://git-lfs.github.com/spec/v1\noid sha256:1\nsize 1\n"),
              HasSubstr("a.obj: is a pointer of Git LFS"));
  EXPECT_THAT(refusal("a.msh", "$NOD\n0\n$ENDNOD\n"),
              HasSubstr("version 1 of MSH\n  convert it to version 4.1: gmsh OLD.msh"));
  EXPECT_THAT(refusal("a.vtk", "<?xml version=\"1.0\"?>\n<VTKFile/>\n"), HasSubstr("end its name in .vtu"));
}

TEST(MeshCommand, BadSurfacesAreExitCode2AndDefectsAreWarnings) {
  const auto run = [](const std::string& name, const std::string& text, const std::string& options) {
    return run_program("mesh " + test_file(name, text).string() + " --no-cache -o " +
                       (test_folder() / "a.msh").string() + " " + options);
  };
  const Outcome empty = run("a.obj", "v 0 0 0\n", "");
  EXPECT_EQ(empty.code, 2);
  EXPECT_THAT(empty.output, HasSubstr("a.obj"));
  const std::string open = std::string(kTetrahedron).replace(6, 1, "3");
  const Outcome refused = run("open.off", open, "--method tetgen");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.output, HasSubstr("the surface is open"));
  const Outcome filled = run("open.off", open, "");
  EXPECT_EQ(filled.code, 0) << filled.output;
  EXPECT_THAT(filled.output, HasSubstr("warning: "));
  EXPECT_THAT(filled.output, HasSubstr("3 edges in 1 loop"));
}

/// Returns the processor time of a running process so far [s].
double processor_seconds(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text);
  std::istringstream fields(text.substr(std::min(text.rfind(')') + 1, text.size())));  // the name may have blanks
  std::string skipped;
  double user = 0, system = 0;
  for (int i = 0; i < 11; ++i) fields >> skipped;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// `folder`: for its temporary files.
pid_t start_program(const std::vector<std::string>& arguments, const std::filesystem::path& folder) {
  std::vector<char*> words = {const_cast<char*>(GRIFFITH_PROGRAM)};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const pid_t process = fork();
  if (process != 0) return process;
  setenv("TMPDIR", folder.c_str(), 1);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  execv(words[0], words.data());
  _exit(127);
}

/// End of a program that got a signal in the middle of its work.
struct Interruption {
  int signal = 0;                ///< that ended it; 0: none
  double processor_seconds = 0;  ///< processor time of the program and its children
};

/// Sends the signal once `works` is true.
Interruption interrupt(pid_t process, int signal, const std::function<bool()>& works) {
  int status = 0;
  rusage usage{};
  bool ended = false;
  while (!ended && !works()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ended = wait4(process, &status, WNOHANG, &usage) != 0;
  }
  if (!ended) kill(process, signal), wait4(process, &status, 0, &usage);
  const auto seconds = [](const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * time.tv_usec; };
  return {WIFSIGNALED(status) ? WTERMSIG(status) : 0, seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

/// The whole work takes twelve seconds of processor time. The signal comes when it has taken half a second, or TetGen
/// has its input.
TEST(MeshCommand, AskedToEndItEndsAtOnceAndLeavesNothing) {
  const auto surface = test_file("tetrahedron.off", kTetrahedron);
  const auto folder = test_folder() / "tmp";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    for (const char* method : {"tetgen", "volumetric"}) {
      const pid_t process = start_program(
          {"mesh", surface, "--no-cache", "--element-size", "0.008", "--method", method, "-o", test_folder() / "a.msh"},
          folder);
      const auto works = [&] { return !std::filesystem::is_empty(folder) || processor_seconds(process) > 0.5; };
      const Interruption end = interrupt(process, signal, works);
      EXPECT_EQ(end.signal, signal) << method;
      EXPECT_LT(end.processor_seconds, 4) << signal << ", " << method;
      EXPECT_FALSE(std::filesystem::exists(test_folder() / "a.msh"));
      EXPECT_TRUE(std::filesystem::is_empty(folder)) << signal << ", " << method;
    }
}

}  // namespace
}  // namespace griffith::app
