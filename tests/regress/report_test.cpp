#include "app/regress/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "sim/scene/scene_difference.h"
#include "tests/app/program.h"
#include "tests/regress/results.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string report_of(const std::vector<PictureResult>& results) {
  return report_html({"wall suite", "llvmpipe", "griffith 0.1.0", "griffith regress suite --accept", 1}, results);
}

/// The tags that are closed wrongly or not at all, outside of styles and scripts.
std::vector<std::string> unbalanced(std::string html) {
  html = std::regex_replace(html, std::regex("data:image/png;base64,[A-Za-z0-9+/=]*"), "");
  html = std::regex_replace(html, std::regex("<(style|script)>[^]*?</(style|script)>"), "");
  static const std::set<std::string> kEmpty = {"meta", "img", "input", "!DOCTYPE"};
  static const std::regex kTag("<(/?)([!A-Za-z0-9]+)[^>]*>");
  std::vector<std::string> open, wrong;
  for (std::sregex_iterator tag(html.begin(), html.end(), kTag), end; tag != end; ++tag) {
    const std::string name = (*tag)[2];
    if (kEmpty.contains(name)) continue;
    if ((*tag)[1].length() == 0) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      wrong.push_back(name);
    } else {
      open.pop_back();
    }
  }
  wrong.insert(wrong.end(), open.begin(), open.end());
  return wrong;
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Report, WhatFailedComesFirstAndIsExplained) {
  const std::string page = report_of(one_of_each());
  const auto at = [&](const std::string& part) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
    return page.find(part);
  };
  EXPECT_LT(at("moved &lt;b&gt;"), at("not drawn &lt;b&gt;"));
  EXPECT_LT(at("not drawn &lt;b&gt;"), at("data-name=\"new one\""));
  EXPECT_LT(at("data-name=\"new one\""), at("data-name=\"as ever\""));
  for (const char* part :
       {"<title>3 failed: wall suite</title>", "the simulation changed", "Around the worst tile, at (",
        "<tr class=\"differs\"><td>pieces</td><td class=\"number\">30</td><td class=\"number\">31</td>",
        "<tr><td>mass [kg]</td><td class=\"number\" colspan=\"2\">1000</td></tr>",
        "<tr class=\"broken\"><td>pixels off in the picture</td>", "<span class=\"removed\">- label 30</span>",
        "<span class=\"added\">+ label 31</span>", "gone: 30; new: 31", "--accept &#39;x &amp; y&#39;",
        "second line &lt;b&gt;"})
    EXPECT_THAT(page, HasSubstr(part));
}

TEST(Report, IsOnePageOfSoundHtml) {
  const std::string page = report_of(one_of_each());
  EXPECT_THAT(unbalanced(page), ::testing::IsEmpty());
  EXPECT_THAT(unbalanced("<p><b>x</p>"), Not(::testing::IsEmpty()));
  EXPECT_EQ(count(page, "src=\""), count(page, "src=\"data:image/png;base64,"));
  for (const char* outside : {"http:", "https:", "<link", "url(", "<b>&\"", "\x1B", "\xFF"})
    EXPECT_THAT(page, Not(HasSubstr(outside)));
}

TEST(Report, PicturesThatPassedAreUnfoldedWhenThereIsNothingElse) {
  const std::vector<PictureResult> results = one_of_each();
  EXPECT_THAT(report_of({results[0]}), HasSubstr("<details class=\"passed\" open>"));
  EXPECT_THAT(report_of({results[0]}), Not(HasSubstr("--accept")));
  EXPECT_THAT(report_of(results), HasSubstr("<details class=\"passed\"><summary>1 passed"));
  EXPECT_THAT(unbalanced(report_of({})), ::testing::IsEmpty());
}

TEST(Report, ADifferenceOfSizeIsShownWithoutAComparison) {
  RegressionPicture small = some_picture();
  small.image = render::part_of(small.image, 0, 0, 40, 30);
  const PictureResult result = compare_pictures("smaller", some_picture(), small);
  EXPECT_EQ(result.status, PictureStatus::failed);
  const std::string page = report_of({result});
  EXPECT_THAT(page, HasSubstr("the size is 40×30, that of the golden picture 96×64"));
  EXPECT_THAT(page, Not(HasSubstr("class=\"stage\"")));
  EXPECT_THAT(unbalanced(page), ::testing::IsEmpty());
}

/// A picture with a scene that has a wall, and another speed of its shot.
RegressionPicture picture_of_scene(double speed, int left = 30) {
  Scene scene;
  scene.bodies.resize(1);
  scene.bodies[0].name = "wall";
  scene.projectiles.resize(1);
  scene.projectiles[0].speed = speed;
  RegressionPicture picture = some_picture(left);
  picture.scene = full_scene_text(scene);
  return picture;
}

TEST(PictureResults, ChangedFieldsOfTheSceneAreNamed) {
  const PictureResult changed = compare_pictures("a", picture_of_scene(10), picture_of_scene(12, 31));
  EXPECT_THAT(changed.reason, HasSubstr("1 field of the scene changed, projectiles/0/speed: 10, now 12."));
  EXPECT_THAT(report_of({changed}), HasSubstr("<tr class=\"differs\"><td>projectiles/0/speed</td><td>10</td>"
                                              "<td>12</td></tr>"));
  const PictureResult same = compare_pictures("a", picture_of_scene(10), picture_of_scene(10, 31));
  EXPECT_THAT(same.reason, HasSubstr("No field of the scene changed; the program or a file of the scene did."));
  const PictureResult unknown = compare_pictures("a", some_picture(), picture_of_scene(10, 31));
  EXPECT_THAT(unknown.reason, Not(HasSubstr("of the scene")));
  EXPECT_EQ(compare_pictures("a", picture_of_scene(10), picture_of_scene(12)).status, PictureStatus::passed)
      << "what changes nothing decides nothing";
}

TEST(PictureResults, TextAndIdsFailByThemselves) {
  RegressionPicture other = some_picture();
  other.text += "label 5\n";
  EXPECT_EQ(compare_pictures("a", some_picture(), other).reason,
            "Picture: identical. Text: 1 line is removed or added.");
  other = some_picture();
  other.ids.ids.assign(96 * 64, 4);
  EXPECT_EQ(compare_pictures("a", some_picture(), other).status, PictureStatus::failed);
  other.ids = {};
  EXPECT_EQ(compare_pictures("a", some_picture(), other).status, PictureStatus::failed) << "a forgotten file";
  EXPECT_EQ(compare_pictures("a", other, some_picture()).status, PictureStatus::failed);
  other = some_picture();
  other.statistics[0].second = 99;
  EXPECT_EQ(compare_pictures("a", some_picture(), other).status, PictureStatus::passed) << "reported, no rule";
  other.state_hash.reset();
  const PictureResult result = compare_pictures("a", some_picture(), other);
  EXPECT_EQ(result.status, PictureStatus::failed);
  EXPECT_EQ(result.simulation_changed, std::nullopt);
}

}  // namespace
}  // namespace griffith::app
