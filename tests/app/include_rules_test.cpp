#include <gtest/gtest.h>

#include <algorithm>
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

/// Checks that headers matching `library` are included only in files that match `files`.
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
  expect_only_in(kBullet, "^sim/(contact/bullet/|geometry/convex_hull\\.cpp$)");
  expect_only_in("^(tbb|oneapi/tbb)/", "^sim/core/(parallel|low_priority)\\.cpp$");
  expect_only_in("^nlohmann/",
                 "^(sim/(scene/|recording/(assets|versions)\\.cpp$)|app/(editor/preferences_file|export/"
                 "(bake_json|html_player)|output/"
                 "((mesh_)?statistics|crack_event_file)|"
                 "render/(read_render_jobs|picture_output)|regress/run_suite|"
                 "study/(bench(_report)?|run_record|sweep_folder|sweep_page|find_report))\\.cpp$)");
  expect_only_in("^assimp/", "^sim/meshing/import_objects\\.cpp$");
  expect_only_in("^GLFW/", "^app/editor/window\\.cpp$");
  expect_only_in("^CLI/", "^app/cli/");
  expect_only_in("^archive", "^sim/recording/file_tree\\.cpp$");
  expect_only_in("^tiny_gltf", "^app/export/tiny_gltf\\.h$");
  expect_only_in("^xxhash", "^sim/core/hash_bytes\\.cpp$");
  expect_only_in("^voro", "^sim/splinters/voronoi_cells\\.cpp$");
  expect_only_in("^stb", "^renderer/image\\.cpp$");
  expect_only_in("^EGL/|^epoxy/egl", "^renderer/egl_context\\.cpp$");
}

using Rules = std::map<std::string, std::string>;

/// Each folder below `top` includes what its rule allows, and nothing else of `top`.
void expect_rules_kept(const std::string& top, const Rules& may_include) {
  for (const Include& include : includes_under(top)) {
    if (!include.path.starts_with(top + "/")) continue;
    const auto rule = may_include.find(folder_of(include.file));
    ASSERT_NE(rule, may_include.end()) << "no rule for " << folder_of(include.file) << ": add one";
    EXPECT_TRUE(std::regex_match(folder_of(include.path), std::regex(rule->second)))
        << include.file << " includes " << include.path;
  }
}

TEST(IncludeRules, LowerFoldersOfTheSimulationKnowNoHigherOnes) {
  expect_rules_kept(
      "sim",
      {
          {"sim/core", "^sim/core$"},
          {"sim/geometry", "^sim/(core|geometry)$"},
          {"sim/mesh", "^sim/(core|mesh)$"},
          {"sim/meshing", "^sim/(core|geometry|mesh|meshing)$"},
          {"sim/elasticity", "^sim/(core|elasticity)$"},
          {"sim/solver", "^sim/(core|mesh|elasticity|solver)$"},
          {"sim/fracture", "^sim/(core|mesh|elasticity|solver|fracture)$"},
          {"sim/contact", "^sim/(core|geometry|contact(/bullet)?)$"},
          {"sim/contact/bullet", "^sim/(core|geometry|contact(/bullet)?)$"},
          {"sim/splinters", "^sim/(core|geometry|mesh|meshing|splinters)$"},
          {"sim/explicit", "^sim/(core|geometry|mesh|elasticity|solver|contact|fracture|explicit)$"},
          {"sim/scene", "^sim/(core|mesh|meshing|elasticity|solver|fracture|splinters|scene)$"},
          {"sim/timeline", "^sim/(core|scene|timeline|world)$"},
          {"sim/recording", "^sim/(core|mesh|scene|world(/(state|output|setup))?|timeline|recording)$"},
          {"sim/world", "^sim/(?!timeline|recording).*$"},
          {"sim/world/state",
           "^sim/(?!timeline|recording|explicit|world/(bodies|motion|contact|impacts|explicit|fracture|regime)).*$"},
          {"sim/world/output",
           "^sim/(?!timeline|recording|explicit|world/"
           "(conditions|motion|contact|impacts|explicit|fracture|regime)).*$"},
          {"sim/world/bodies",
           "^sim/(?!timeline|recording|explicit|world/(setup|conditions|contact|impacts|explicit|regime)).*$"},
          {"sim/world/energy",
           "^sim/(?!timeline|recording|world/(setup|conditions|contact|impacts|explicit|fracture|regime)).*$"},
          {"sim/world/conditions",
           "^sim/(?!timeline|recording|explicit|world/(motion|contact|impacts|explicit|fracture)).*$"},
          {"sim/world/fracture",
           "^sim/(?!timeline|recording|explicit|world/(conditions|motion|contact|impacts|explicit|regime)).*$"},
          {"sim/world/motion", "^sim/(?!timeline|recording|explicit|world/(setup|conditions|impacts|fracture)).*$"},
          {"sim/world/contact", "^sim/(?!timeline|recording|explicit|world/(setup|conditions|explicit|fracture)).*$"},
          {"sim/world/regime", "^sim/(?!timeline|recording|explicit|world/(setup|conditions|explicit)).*$"},
          {"sim/world/impacts", "^sim/(?!timeline|recording|world/setup).*$"},
          {"sim/world/explicit", "^sim/(?!timeline|recording|world/(setup|impacts)).*$"},
          {"sim/world/setup", "^sim/(?!timeline|recording|explicit|world/(impacts|explicit|regime)).*$"},
      });
}

/// Tests of a part of the world lie in the folder of its name.
TEST(IncludeRules, FoldersOfTheWorldsTestsMirrorIt) {
  const fs::path root = GRIFFITH_SOURCE_DIR;
  int folders = 0;
  for (const auto& entry : fs::directory_iterator(root / "tests/world")) {
    if (!entry.is_directory()) continue;
    ++folders;
    EXPECT_TRUE(fs::is_directory(root / "sim/world" / entry.path().filename())) << entry.path();
  }
  EXPECT_GT(folders, 10);
}

TEST(IncludeRules, LowerFoldersOfPanelsKnowNoHigherOnes) {
  expect_rules_kept("ui", {{"ui/model", "^ui/model$"},
                           {"ui/widgets", "^ui/(model|widgets)$"},
                           {"ui/dialogs", "^ui/(model|widgets|dialogs)$"},
                           {"ui/panels", "^ui/.*$"}});
}

TEST(IncludeRules, LowerFoldersOfTheProgramKnowNoHigherOnes) {
  expect_rules_kept("app", {{"app/shared", "^app/shared$"},
                            {"app/picture", "^app/(shared|picture)$"},
                            {"app/output", "^app/(shared|picture|output)$"},
                            {"app/bake", "^app/(picture|output|bake)$"},
                            {"app/export", "^app/(output|bake|export)$"},
                            {"app/editor", "^app/(shared|picture|output|bake|export|editor)$"},
                            {"app/render", "^app/(shared|picture|output|editor|render)$"},
                            {"app/regress", "^app/(shared|output|render|regress)$"},
                            {"app/study", "^app/(shared|output|study)$"},
                            {"app/validate", "^app/(shared|render|study|validate)$"},
                            {"app/cli", "^app/.*$"}});
}

/// Printed text may contain names from files of strangers, so it goes through print(), which escapes it.
TEST(IncludeRules, WhatIsPrintedIsEscaped) {
  static const std::regex kRaw("std::(printf|fprintf|fputs|puts|putchar|cout|cerr|clog)\\b");
  static const std::regex kAllowed("/(output/output|shared/progress)\\.cpp$");
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(GRIFFITH_SOURCE_DIR) / "app")) {
    const std::string path = entry.path().generic_string();
    if (!path.ends_with(".cpp") || std::regex_search(path, kAllowed)) continue;
    ++files;
    std::ifstream file(entry.path());
    int number = 0;
    for (std::string line; std::getline(file, line); ++number)
      EXPECT_FALSE(std::regex_search(line, kRaw)) << path << ":" << number + 1;
  }
  EXPECT_GT(files, 100);
}

/// Pictures are compared as they are, whatever made them.
TEST(IncludeRules, RegressionKnowsNeitherWorldsNorDrawing) {
  for (const char* forbidden : {kGraphics, kImGui, "^ui/", "^sim/(?!(core|scene)/)", "^renderer/(?!(image|error)\\.h)"})
    expect_none("app/regress", forbidden);
}

/// Two types of one name in one namespace violate the one-definition rule, and no linker reports it.
TEST(IncludeRules, NoTypeHasTheNameOfAnother) {
  static const std::regex kNamespace("^namespace ([\\w:]+) \\{"),
      kType("^(?:struct|class) (\\w+)( final)?( : .*)? \\{");
  std::map<std::string, std::string> file_of_type;
  for (const char* folder : {"sim", "renderer", "ui", "app"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(GRIFFITH_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".h") continue;
      std::ifstream file(entry.path());
      std::string space;
      std::smatch match;
      for (std::string line; std::getline(file, line);) {
        if (std::regex_search(line, match, kNamespace)) space = match[1];
        if (!std::regex_search(line, match, kType)) continue;
        const auto [first, is_new] = file_of_type.emplace(space + "::" + match[1].str(), entry.path().string());
        EXPECT_TRUE(is_new) << first->first << " is in " << first->second << " and in " << entry.path();
      }
    }
  EXPECT_GT(file_of_type.size(), 200u);
}

TEST(IncludeRules, ExamplesKnowThePackageAlone) {
  for (const char* forbidden : {"^(sim|renderer|ui|app)/", "^griffith/sim/", kBullet, kImGui, kGraphics})
    expect_none("examples", forbidden);
}

TEST(IncludeRules, OwnHeadersAreIncludedFromTheRoot) {
  for (const char* folder : {"sim", "renderer", "ui", "app"}) {
    for (const Include& include : includes_under(folder)) {
      EXPECT_EQ(include.path.find("../"), std::string::npos) << include.file << " includes " << include.path;
    }
  }
}

TEST(IncludeRules, PartsOfTheEditorKnowOnlyThoseBeforeThem) {
  const std::vector<std::string> parts = {"scene_document", "edit_recovery", "known_scenes", "viewport",
                                          "run_controller", "world_builder", "run_analysis", "run_files",
                                          "scripting",      "editor"};
  const auto place_of = [&](const std::string& path) {
    return std::ranges::find(parts, fs::path(path).stem().string()) - parts.begin();
  };
  int known = 0;
  for (const Include& include : includes_under("app/editor")) {
    const auto from = place_of(include.file), to = place_of(include.path);
    if (std::max(from, to) == std::ssize(parts) || folder_of(include.path) != "app/editor") continue;
    EXPECT_LE(to, from) << include.file << " includes " << include.path;
    known += to < from;
  }
  EXPECT_GT(known, 15);
}

}  // namespace
