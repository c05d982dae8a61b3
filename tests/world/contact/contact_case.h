#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

#include "sim/world/world.h"

namespace griffith::testing {

/// One point of the grid on which a law of contact is tried.
struct ContactCase {
  double size;       ///< largest length of the bodies [m]
  int refinement;    ///< 1: elements as large as the scene has them, 2: half as large
  double time_step;  ///< [s]
};

inline std::ostream& operator<<(std::ostream& stream, const ContactCase& at) {
  return stream << at.size << " m, elements / " << at.refinement << ", step 1/" << std::lround(1 / at.time_step)
                << " s";
}

/// True if the whole grid is asked for.
inline bool all_contact_cases() { return std::getenv("GRIFFITH_ALL_CONTACT_CASES") != nullptr; }

/// A law of contact over cases. Those that are known to be missed (contact_gaps.txt) are skipped and reported as such,
/// unless GRIFFITH_ALL_CONTACT_CASES is set.
template <class Case>
class ContactLaw : public ::testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    if (all_contact_cases()) return;
    const ::testing::TestInfo& test = *::testing::UnitTest::GetInstance()->current_test_info();
    const std::string name = std::string(test.test_suite_name()) + "." + test.name();
    std::ifstream gaps(GRIFFITH_SOURCE_DIR "/tests/world/contact/contact_gaps.txt");
    ASSERT_TRUE(gaps.is_open());
    for (std::string gap; std::getline(gaps, gap);)
      if (gap == name) GTEST_SKIP() << "known to be missed";
  }
};

/// The grid of these sizes, two meshes and steps of 1/30, 1/60 and 1/250 s. A third of it unless
/// GRIFFITH_ALL_CONTACT_CASES is set: three sizes have each pair of a mesh and a step once. A fourth size would repeat
/// those of the first and has the first mesh alone.
inline std::vector<ContactCase> contact_cases(const std::vector<double>& sizes) {
  const bool all = all_contact_cases();
  const double steps[] = {1.0 / 30, 1.0 / 60, 1.0 / 250};
  std::vector<ContactCase> cases;
  for (int size = 0; size < static_cast<int>(sizes.size()); ++size)
    for (int mesh = 0; mesh < 2; ++mesh)
      for (int step = 0; step < 3; ++step)
        if (all || ((size + mesh + step) % 3 == 0 && (size < 3 || mesh == 0)))
          cases.push_back({sizes[size], mesh + 1, steps[step]});
  return cases;
}

/// "10mm_mesh2_step60": the name of a case in the list of tests.
inline std::string case_name(const ContactCase& at) {
  return std::to_string(std::lround(1000 * at.size)) + "mm_mesh" + std::to_string(at.refinement) + "_step" +
         std::to_string(std::lround(1 / at.time_step));
}

inline std::string contact_case_name(const ::testing::TestParamInfo<ContactCase>& info) {
  return case_name(info.param);
}

/// Records a figure with its expected value in the test's report, so that runs can be compared.
inline void record(const std::string& name, double got, const std::string& expected) {
  char text[64];
  std::snprintf(text, sizeof text, "%.4g (%s)", got, expected.c_str());
  ::testing::Test::RecordProperty(name, text);
}

inline std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

inline void check_near(const std::string& name, double got, double expected, double fraction = 0.02) {
  record(name, got, short_text(expected) + " within " + short_text(100 * fraction) + " %");
  EXPECT_NEAR(got, expected, fraction * std::abs(expected)) << name;
}

inline void check_at_most(const std::string& name, double got, double bound) {
  record(name, got, "<= " + short_text(bound));
  EXPECT_LE(got, bound) << name;
}

inline void check_equal(const std::string& name, int got, int expected) {
  record(name, got, std::to_string(expected));
  EXPECT_EQ(got, expected) << name;
}

}  // namespace griffith::testing
