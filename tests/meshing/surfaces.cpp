#include "surfaces.h"

#include <gtest/gtest.h>

namespace griffith::testing {

namespace fs = std::filesystem;

fs::path test_folder() {
  const ::testing::TestInfo* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder =
      fs::path(::testing::TempDir()) / ("griffith_" + std::string(test->test_suite_name()) + "_" + test->name());
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

fs::path shipped_surface(const std::string& name) { return fs::path(GRIFFITH_SOURCE_DIR) / "scenes" / "meshes" / name; }

}  // namespace griffith::testing
