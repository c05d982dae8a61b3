#include <gtest/gtest.h>

#include "tests/validation/validation_case.h"

namespace griffith::validation {

// Googletest finds it by this name: what a failure and a list of tests call a case.
void PrintTo(const Case& validation_case, std::ostream* stream) { *stream << validation_case.name; }

namespace {

class Validation : public ::testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(Cases, Validation, ::testing::ValuesIn(cases().begin(), cases().end()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST_P(Validation, IsWithinItsTolerances) {
  const std::vector<Row> rows = GetParam().run(Extent::test);
  EXPECT_FALSE(rows.empty());
  for (const Row& row : rows)
    EXPECT_TRUE(row.passes()) << row.mesh.pattern << ", " << row.mesh.resolution << ": " << row.quantity
                              << ": expected " << row.expected << ", got " << row.got;
}

}  // namespace
}  // namespace griffith::validation
