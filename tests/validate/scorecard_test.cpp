#include "app/validate/scorecard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "app/cli/command_line.h"
#include "sim/core/read_file.h"
#include "sim/core/replace_file.h"
#include "tests/files/test_folder.h"

namespace griffith::app {
namespace {

std::string published_page() { return read_file(std::filesystem::path(GRIFFITH_SOURCE_DIR) / "docs/scorecard.md"); }

template <class... Arguments>
int validate(const Arguments&... arguments) {
  const std::vector<const char*> all = {"griffith", "validate", arguments...};
  return run(static_cast<int>(all.size()), all.data());
}

TEST(Scorecard, HasEveryExperimentOnce) {
  std::set<std::string> keys;
  for (const Experiment& experiment : experiments()) {
    EXPECT_TRUE(keys.insert(experiment.key).second) << experiment.key;
    EXPECT_FALSE(experiment.source.empty() || experiment.measured.empty() || experiment.acceptance.empty());
    EXPECT_EQ(experiment.meshes.size(), 3) << experiment.key;
  }
  std::set<std::string> published;
  for (const auto& [key, entry] : read_scorecard(published_page())) published.insert(key);
  EXPECT_EQ(published, keys) << "griffith validate --out docs/scorecard.md writes the page";
}

TEST(Scorecard, IsWrittenAsItWasRead) { EXPECT_EQ(scorecard_page(read_scorecard(published_page())), published_page()); }

/// Quick experiments give what the page says. Those that pass there still pass.
class QuickExperiment : public ::testing::TestWithParam<std::string> {};

/// Returns the number of meshes to try: the finest of a plate or a long bar takes ten seconds or more.
std::size_t meshes_to_try(const std::string& key) { return key == "kalthoff_winkler" || key == "spall" ? 2 : 3; }

/// Returns what a section says before its result.
std::string description_in(const std::string& section) { return section.substr(0, section.find("Result: ")); }

/// Returns the lines of a section's table, each without its spread.
std::vector<std::string> values_in(const std::string& section) {
  std::vector<std::string> lines;
  std::istringstream text(section);
  for (std::string line; std::getline(text, line);)
    if (line.starts_with("| ")) lines.push_back(line.substr(0, line.rfind('|', line.size() - 2) + 1));
  return lines;
}

TEST_P(QuickExperiment, ReadsAsThePageSays) {
  Experiment experiment = *std::ranges::find(experiments(), GetParam(), &Experiment::key);
  const std::size_t meshes = meshes_to_try(GetParam());
  const bool is_whole = experiment.meshes.size() == meshes;
  experiment.meshes.resize(meshes);
  const Judgment judgment = judge(experiment, [](const std::string&) {});
  const ScorecardEntry now = scorecard_entry(experiment, judgment),
                       published = read_scorecard(published_page())[GetParam()];
  const std::string remedy = "griffith validate " + GetParam() + " --out docs/scorecard.md";
  EXPECT_EQ(description_in(now.section), description_in(published.section)) << remedy;
  for (const std::string& line : values_in(now.section))
    EXPECT_THAT(published.section, ::testing::HasSubstr("\n" + line)) << remedy;
  EXPECT_TRUE(judgment.passes() || published.row.find("fail") != std::string::npos) << remedy;
  if (is_whole) {
    EXPECT_EQ(now.row, published.row) << remedy;
    EXPECT_EQ(now.section, published.section) << remedy;
  }
}

std::vector<std::string> quick_keys() {
  std::vector<std::string> keys;
  for (const Experiment& experiment : experiments())
    if (experiment.quick) keys.push_back(experiment.key);
  return keys;
}

INSTANTIATE_TEST_SUITE_P(Scorecard, QuickExperiment, ::testing::ValuesIn(quick_keys()),
                         [](const auto& test) { return test.param; });

TEST(ValidateCommand, ReplacesThePartOfAnExperimentAndKeepsOthers) {
  const std::filesystem::path page = testing::empty_folder() / "page.md";
  replace_file(page, scorecard_page({{"uniaxial_tension", {"| [uniaxial_tension](#a) | old |", "old\n"}},
                                     {"strip", {"| [strip](#b) | kept |", "## kept\n"}}}));
  EXPECT_EQ(validate("uniaxial_tension", "--meshes", "1", "--out", page.c_str()), kDone);
  const Scorecard scorecard = read_scorecard(read_file(page));
  EXPECT_EQ(scorecard.at("strip"), (ScorecardEntry{"| [strip](#b) | kept |", "## kept\n"}));
  EXPECT_THAT(scorecard.at("uniaxial_tension").section, ::testing::HasSubstr("## Uniaxial tension of glass"));
}

TEST(ValidateCommand, FailsOnlyIfItIsStrict) {
  const std::filesystem::path page = testing::empty_folder() / "page.md";
  EXPECT_EQ(validate("uniaxial_tension", "--meshes", "1", "--strict", "--out", page.c_str()), kDone);
  EXPECT_EQ(validate("branching", "--meshes", "1", "--out", page.c_str()), kDone);
  const bool passes = read_file(page).find("fail") == std::string::npos;
  EXPECT_EQ(validate("branching", "--meshes", "1", "--strict", "--out", page.c_str()), passes ? kDone : kFailed);
}

TEST(ValidateCommand, RefusesAnUnknownExperiment) {
  EXPECT_EQ(validate("nothing"), kBadInput);
  EXPECT_EQ(validate("--list"), kDone);
}

}  // namespace
}  // namespace griffith::app
