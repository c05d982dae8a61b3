// What the project ships needs nothing from outside of it.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace griffith {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = fs::path(GRIFFITH_SOURCE_DIR).lexically_normal();

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Texts of the project: sources, scenes, tests, documents.
std::vector<fs::path> texts() {
  const std::set<std::string> skipped = {".git", "build"};
  const std::set<std::string> kinds = {".cpp", ".h", ".json", ".md", ".txt", ".py", ".script", ".js", ".html", ""};
  std::vector<fs::path> found;
  for (auto entry = fs::recursive_directory_iterator(kRoot); entry != fs::recursive_directory_iterator(); ++entry) {
    if (entry->is_directory() && skipped.contains(entry->path().filename().string())) entry.disable_recursion_pending();
    if (entry->is_regular_file() && kinds.contains(entry->path().extension().string())) found.push_back(entry->path());
  }
  return found;
}

/// Returns references by "../" in `text`, seen from its folder, that lead outside the project.
std::vector<std::string> ways_out(const fs::path& folder, const std::string& text) {
  static const std::regex kUpwards(R"((\.\./)+[\w.-]*)");
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), kUpwards), end; match != end; ++match) {
    const fs::path inside = (folder / match->str()).lexically_normal().lexically_relative(kRoot);
    if (inside.empty() || *inside.begin() == "..") found.push_back(match->str());
  }
  return found;
}

TEST(OwnFiles, NoTextRefersOutsideOfTheProject) {
  const std::regex beside_the_project(R"(GRIFFITH_SOURCE_DIR\W{1,12}\.\.)");
  const std::vector<fs::path> all = texts();
  EXPECT_GT(all.size(), 500u);
  for (const fs::path& path : all) {
    const std::string text = text_of(path);
    for (const std::string& way : ways_out(path.parent_path(), text)) ADD_FAILURE() << path << " refers to " << way;
    EXPECT_FALSE(std::regex_search(text, beside_the_project)) << path;
  }
}

TEST(OwnFiles, AWayOutIsFound) {
  EXPECT_EQ(ways_out(kRoot / "scenes", R"({"path": "../../shared/a.obj"})"), std::vector<std::string>{"../../shared"});
  EXPECT_TRUE(ways_out(kRoot / "tests/pictures", R"("../../scenes/wall.json")").empty());
}

}  // namespace
}  // namespace griffith
