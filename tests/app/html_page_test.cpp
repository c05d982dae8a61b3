#include "app/output/html_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace griffith::app {
namespace {

TEST(HtmlPage, WhatMarkupMeansIsEscaped) {
  EXPECT_EQ(escape_markup("<a href=\"x\">R&D's</a>"), "&lt;a href=&quot;x&quot;&gt;R&amp;D&#39;s&lt;/a&gt;");
  EXPECT_EQ(escape_markup("5 µm, 1 ≤ ν, 𝜎\n\t"), "5 µm, 1 ≤ ν, 𝜎\n\t");
}

TEST(HtmlPage, WhatIsNoTextIsReplaced) {
  EXPECT_EQ(escape_markup(std::string("a\0b\x1B\x7F", 5)), "a\uFFFDb\uFFFD\uFFFD");
  EXPECT_EQ(escape_markup("\xFF|\xC3"), "\uFFFD|\uFFFD") << "a byte of none, the first of two alone";
  EXPECT_EQ(escape_markup("\xC0\xBC"), "\uFFFD\uFFFD") << "'<' in two bytes";
  EXPECT_EQ(escape_markup("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD") << "half of a surrogate pair";
  EXPECT_EQ(escape_markup("\xEF\xBF\xBF"), "\uFFFD\uFFFD\uFFFD") << "U+FFFF";
  EXPECT_EQ(escape_markup("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD") << "beyond U+10FFFF";
}

/// The examples of RFC 4648.
TEST(HtmlPage, DataUriIsBase64) {
  const std::string start = "data:image/png;base64,";
  EXPECT_EQ(png_data_uri(""), start);
  EXPECT_EQ(png_data_uri("f"), start + "Zg==");
  EXPECT_EQ(png_data_uri("fo"), start + "Zm8=");
  EXPECT_EQ(png_data_uri("foo"), start + "Zm9v");
  EXPECT_EQ(png_data_uri("foobar"), start + "Zm9vYmFy");
  EXPECT_EQ(png_data_uri(std::string("\xFB\xFF\0", 3)), start + "+/8A");
}

TEST(HtmlPage, PageHoldsItsPartsAndNeedsNoOtherFile) {
  const std::string page = html_page("a < b", "<script>let x;</script>", "<p>hello</p>");
  EXPECT_THAT(page, ::testing::HasSubstr("<title>a &lt; b</title>"));
  EXPECT_THAT(page, ::testing::HasSubstr("<script>let x;</script></head>"));
  EXPECT_THAT(page, ::testing::HasSubstr("<body>\n<p>hello</p></body>"));
  EXPECT_THAT(page, ::testing::HasSubstr("prefers-color-scheme: dark"));
  for (const char* outside : {"http:", "https:", "<link", "src=", "url("})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
}

}  // namespace
}  // namespace griffith::app
