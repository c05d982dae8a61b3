#pragma once

#include <gtest/gtest.h>

#include <string>

#include "sim/mesh/box_pattern.h"

namespace griffith::testing {

/// Names a pattern in a test's name.
inline std::string pattern_name(const ::testing::TestParamInfo<BoxPattern>& info) {
  constexpr const char* kNames[] = {"kuhn", "five_tet", "bcc"};
  return kNames[static_cast<int>(info.param)];
}

}  // namespace griffith::testing
