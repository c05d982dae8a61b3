#include "app/regress/compare_text.h"

#include <gtest/gtest.h>

#include <random>

namespace griffith::app {

/// For messages of tests.
void PrintTo(const DiffLine& line, std::ostream* out) { *out << " -+~"[static_cast<int>(line.kind)] << line.text; }

namespace {

/// A letter a line: "a b -c +d ~".
std::string shown(const std::vector<DiffLine>& diff) {
  std::string text;
  for (const DiffLine& line : diff)
    text += (text.empty() ? "" : " ") +
            std::string(line.kind == DiffLine::Kind::same      ? ""
                        : line.kind == DiffLine::Kind::removed ? "-"
                        : line.kind == DiffLine::Kind::added   ? "+"
                                                               : "~") +
            line.text;
  return text;
}

TEST(CompareText, EqualOnesHaveNoDifference) {
  EXPECT_TRUE(compare_text("", "").empty());
  EXPECT_TRUE(compare_text("a\nb\n", "a\nb").empty());
}

TEST(CompareText, ChangesStandAmongTheirContext) {
  EXPECT_EQ(shown(compare_text("a\nb\nc\nd\ne\nf\ng\n", "a\nb\nc\nx\ne\nf\ng\n", 1)), "~ c -d +x e ~");
  EXPECT_EQ(shown(compare_text("a\nb\n", "a\nb\nc\n")), "a b +c");
  EXPECT_EQ(shown(compare_text("a\nb\n", "b\n")), "-a b");
  EXPECT_EQ(shown(compare_text("", "a\n")), "+a");
  EXPECT_EQ(shown(compare_text("a\n\nb", "a\nb")), "a - b") << "an empty line";
}

TEST(CompareText, AnInsertedLineDoesNotChangeTheRest) {
  EXPECT_EQ(shown(compare_text("a\nb\nc\nd\n", "x\na\nb\ny\nc\nd\n", 9)), "+x a b +y c d");
}

/// Taken alone, what is kept and removed is the one text, what is kept and added the other.
TEST(CompareText, BothTextsCanBeReadFromIt) {
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i) {
    const auto text = [&] {
      std::string lines;
      for (int k = static_cast<int>(random() % 12); k > 0; --k) lines += std::string(1, 'a' + random() % 3) + "\n";
      return lines;
    };
    const std::string golden = text(), actual = text();
    if (golden == actual) continue;
    std::string before, now;
    for (const DiffLine& line : compare_text(golden, actual, 100)) {
      if (line.kind != DiffLine::Kind::added) before += line.text + "\n";
      if (line.kind != DiffLine::Kind::removed) now += line.text + "\n";
    }
    EXPECT_EQ(before, golden);
    EXPECT_EQ(now, actual);
  }
}

TEST(CompareText, LongTextsThatHaveNothingInCommonAreReportedInTime) {
  std::string golden, actual;
  for (int i = 0; i < 20000; ++i) {
    golden += "g" + std::to_string(i) + "\n";
    actual += "a" + std::to_string(i) + "\n";
  }
  EXPECT_EQ(compare_text(golden, actual).size(), 40000u);
}

}  // namespace
}  // namespace griffith::app
