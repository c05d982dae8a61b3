#include "app/validate/scorecard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

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

/// Experiments of a few seconds give what the page says. Those that pass there still pass.
class QuickExperiment : public ::testing::TestWithParam<std::string> {};

TEST_P(QuickExperiment, ReadsAsThePageSays) {
  const auto experiment = std::ranges::find(experiments(), GetParam(), &Experiment::key);
  const ScorecardEntry now = scorecard_entry(*experiment, judge(*experiment, [](const std::string&) {}));
  const ScorecardEntry published = read_scorecard(published_page())[GetParam()];
  EXPECT_EQ(now.row, published.row) << "griffith validate " << GetParam() << " --out docs/scorecard.md";
  EXPECT_EQ(now.section, published.section);
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
