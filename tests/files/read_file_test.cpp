#include "sim/core/read_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "sim/core/error.h"
#include "test_folder.h"

namespace griffith {
namespace {

using ::testing::HasSubstr;
using namespace griffith::testing;

std::string problem_of(const std::filesystem::path& path, std::int64_t max_bytes = 1000) {
  try {
    read_file(path, max_bytes);
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), path.string());
    return error.problem();
  }
  return "none";
}

TEST(ReadFile, GivesEveryByte) {
  const std::string bytes("a\0b\r\n\xff", 6);
  const auto folder = empty_folder();
  EXPECT_EQ(read_file(written(folder / "a", bytes)), bytes);
  EXPECT_EQ(read_file(written(folder / "empty", "")), "");
  std::filesystem::create_symlink("a", folder / "link");
  EXPECT_EQ(read_file(folder / "link"), bytes);
}

TEST(ReadFile, PipesAndDevicesAreRefusedWithoutWaiting) {
  const auto pipe = empty_folder() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(problem_of(pipe), "is not a regular file");
  EXPECT_EQ(problem_of("/dev/zero"), "is not a regular file");
  EXPECT_THROW(require_regular_file(pipe), InputError);
}

TEST(ReadFile, WhatCannotBeReadIsReportedWithItsReason) {
  const auto folder = empty_folder();
  EXPECT_EQ(problem_of(folder), "is a folder");
  EXPECT_EQ(problem_of(folder / "none"), "no such file");
  EXPECT_THAT(problem_of(written(folder / "a", "a") / "b"), HasSubstr("Not a directory"));
}

TEST(ReadFile, AFileBeyondTheLimitIsRefusedBeforeItsMemoryIsTaken) {
  const auto path = written(empty_folder() / "large", "");
  std::filesystem::resize_file(path, std::uintmax_t{1} << 40);  // a hole, which takes no room
  EXPECT_EQ(problem_of(path), "is larger than 1000 bytes");
  EXPECT_EQ(problem_of(path, std::int64_t{5} << 20), "is larger than 5 MB");
}

}  // namespace
}  // namespace griffith
