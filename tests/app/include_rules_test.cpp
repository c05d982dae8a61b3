#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Include {
  std::string file;  ///< relative to the root
  std::string path;  ///< as written
};

std::vector<Include> includes_under(const std::string& folder) {
  static const std::regex kInclude("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]");
  const fs::path root = GRIFFITH_SOURCE_DIR;
  std::vector<Include> result;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const std::string extension = entry.path().extension();
    if (extension != ".cpp" && extension != ".h") continue;
    std::ifstream file(entry.path());
    std::smatch match;
    for (std::string line; std::getline(file, line);) {
      if (std::regex_search(line, match, kInclude)) result.push_back({fs::relative(entry.path(), root), match[1]});
    }
  }
  EXPECT_FALSE(result.empty()) << folder;
  return result;
}

std::string folder_of(const std::string& path) { return fs::path(path).parent_path(); }

void expect_none(const std::string& folder, const std::string& forbidden) {
  const std::regex pattern(forbidden);
  for (const Include& include : includes_under(folder)) {
    EXPECT_FALSE(std::regex_search(include.path, pattern)) << include.file << " includes " << include.path;
  }
}

/// What matches `library` is included in files that match `files` alone.
void expect_only_in(const std::string& library, const std::string& files) {
  const std::regex pattern(library), allowed(files);
  for (const char* folder : {"sim", "renderer", "ui", "app"}) {
    for (const Include& include : includes_under(folder)) {
      if (!std::regex_search(include.path, pattern)) continue;
      EXPECT_TRUE(std::regex_search(include.file, allowed)) << include.file << " includes " << include.path;
    }
  }
}

constexpr char kGraphics[] = "^(GL/|GLES|EGL/|epoxy/|GLFW/)";
constexpr char kImGui[] = "^(imgui|backends/imgui|imgui/)";
constexpr char kBullet[] = "^(bt[A-Z]|Bullet|LinearMath/)";

TEST(IncludeRules, SimulationKnowsNothingAboveIt) {
  for (const char* forbidden : {kGraphics, kImGui, "^(renderer|ui|app)/", "^(CLI|spdlog)/"})
    expect_none("sim", forbidden);
}

TEST(IncludeRules, RendererKnowsNeitherPhysicsNorPanels) {
  for (const char* forbidden : {kImGui, kBullet, "^(sim|ui|app)/", "^GLFW/"}) expect_none("renderer", forbidden);
}

TEST(IncludeRules, PanelsMakeNoGraphicsCallAndKnowNoWorld) {
  for (const char* forbidden : {kGraphics, kBullet, "^(renderer|app)/", "^backends/", "^sim/world/world\\.h$"}) {
    expect_none("ui", forbidden);
  }
}

TEST(IncludeRules, ThirdPartyLibrariesStayInTheirPlaces) {
  expect_only_in(kBullet, "^sim/contact/");
  expect_only_in("^(tbb|oneapi/tbb)/", "^sim/parallel\\.cpp$");
  expect_only_in("^nlohmann/", "^(sim/scene/|app/((mesh_)?statistics|crack_event_file)\\.cpp$)");
  expect_only_in("^assimp/", "^sim/meshing/import_objects\\.cpp$");
  expect_only_in("^GLFW/", "^app/window\\.cpp$");
  expect_only_in("^CLI/", "^app/command_line\\.cpp$");
  expect_only_in("^voro", "^sim/splinters/voronoi_cells\\.cpp$");
  expect_only_in("^stb", "^renderer/image\\.cpp$");
  expect_only_in("^EGL/|^epoxy/egl", "^renderer/egl_context\\.cpp$");
}

TEST(IncludeRules, LowerFoldersOfTheSimulationKnowNoHigherOnes) {
  const std::map<std::string, std::string> may_include = {
      {"sim", "^sim$"},
      {"sim/mesh", "^sim(/mesh)?$"},
      {"sim/meshing", "^sim(/mesh|/meshing)?$"},
      {"sim/elasticity", "^sim(/mesh|/elasticity)?$"},
      {"sim/solver", "^sim(/mesh|/elasticity|/solver)?$"},
      {"sim/fracture", "^sim(/mesh|/elasticity|/solver|/fracture)?$"},
      {"sim/contact", "^sim(/mesh|/contact)?$"},
      {"sim/splinters", "^sim(/mesh|/meshing|/splinters)?$"},
      {"sim/shock", "^sim(/mesh|/elasticity|/solver|/contact|/shock)?$"},
      {"sim/scene", "^sim(/mesh|/meshing|/elasticity|/solver|/fracture|/splinters|/scene)?$"},
      {"sim/world", "^sim(/.*)?$"},
  };
  for (const Include& include : includes_under("sim")) {
    if (!include.path.starts_with("sim/")) continue;
    const auto rule = may_include.find(folder_of(include.file));
    ASSERT_NE(rule, may_include.end()) << "no rule for " << folder_of(include.file) << ": add one";
    EXPECT_TRUE(std::regex_match(folder_of(include.path), std::regex(rule->second)))
        << include.file << " includes " << include.path;
  }
}

TEST(IncludeRules, ExamplesKnowThePackageAlone) {
  for (const char* forbidden : {"^(sim|renderer|ui|app)/", kBullet, kImGui, kGraphics})
    expect_none("examples", forbidden);
}

TEST(IncludeRules, OwnHeadersAreIncludedFromTheRoot) {
  for (const char* folder : {"sim", "renderer", "ui", "app"}) {
    for (const Include& include : includes_under(folder)) {
      EXPECT_EQ(include.path.find("../"), std::string::npos) << include.file << " includes " << include.path;
    }
  }
}

}  // namespace
