#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "app/regress/report.h"
#include "tests/app/program.h"
#include "tests/regress/results.h"

namespace griffith::app {
namespace {

/// XML parser that prints the suite's totals, then name, time, element, type and message of each test case.
constexpr char kParser[] = R"py(
import sys, xml.etree.ElementTree as tree
suite = tree.parse(sys.argv[1]).getroot().find('testsuite')
print(*(suite.get(key) for key in ('name', 'tests', 'failures', 'errors', 'skipped', 'time')), sep='|')
for case in suite.findall('testcase'):
    outcome = list(case)
    found = (outcome[0].tag, outcome[0].get('type'), outcome[0].get('message')) if outcome else ('passed',)
    print(case.get('classname'), case.get('name'), case.get('time'), *found, sep='|')
)py";

std::string parsed(const std::string& xml) {
  const auto script = test_file("parse.py", kParser), input = test_file("junit.xml", xml), out = test_folder() / "out";
  const std::string command =
      "PYTHONIOENCODING=utf-8 python3 " + script.string() + " " + input.string() + " > " + out.string();
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::ostringstream text;
  text << std::ifstream(out).rdbuf();
  return text.str();
}

TEST(JUnit, AParserReadsWhatHappened) {
  const std::string name = "<b>&\"'</b>\uFFFD[31m\uFFFD";
  std::vector<PictureResult> results = one_of_each();
  results[3].reason = "100 pixels are off";
  EXPECT_EQ(parsed(junit_xml("suite <1>", results)),
            "suite <1>|4|2|1|0|1.000\n"
            "suite <1>|as ever|0.250|passed\n"
            "suite <1>|not drawn " +
                name + "|0.250|error|error|scenes/x.json: there is no such file\n" +
                "suite <1>|new one|0.250|failure|missing_golden|There is no golden picture. Look at this one and "
                "accept it if it is correct.\n"
                "suite <1>|moved " +
                name + "|0.250|failure|failed|100 pixels are off\n");
}

TEST(JUnit, NoPicturesAreASuiteToo) { EXPECT_EQ(parsed(junit_xml("none", {})), "none|0|0|0|0|0.000\n"); }

TEST(JUnit, DetailsSayHowToAccept) {
  EXPECT_NE(junit_xml("s", one_of_each()).find("Accept: griffith regress &#39;suite&#39; --accept &#39;x &amp; y&#39;"),
            std::string::npos);
}

}  // namespace
}  // namespace griffith::app
