#include "sim/core/replace_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <atomic>
#include <csignal>
#include <thread>
#include <vector>

#include "sim/core/descriptor.h"
#include "sim/core/error.h"
#include "test_folder.h"

namespace griffith {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using namespace griffith::testing;

unsigned mode_of(const fs::path& path) {
  struct stat status {};
  EXPECT_EQ(stat(path.c_str(), &status), 0);
  return status.st_mode & 07777;
}

std::string problem_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.problem();
  }
  return "none";
}

TEST(ReplaceFile, KeepsTheModeOfTheOldFileAndGivesANewOneTheUsualOne) {
  const fs::path folder = empty_folder(), old = written(folder / "old", "old");
  ASSERT_EQ(chmod(old.c_str(), 0600), 0);
  const mode_t mask = umask(027);
  replace_file(old, "new");
  replace_file(folder / "new", "new");
  umask(mask);
  EXPECT_EQ(mode_of(old), 0600u);
  EXPECT_EQ(mode_of(folder / "new"), 0640u);
  EXPECT_EQ(text_of(old), "new");
  EXPECT_EQ(files_in(folder), 2);
}

TEST(ReplaceFile, WhatAKilledProgramLeftGoesWithTheNextCheck) {
  const fs::path folder = empty_folder();
  const auto old_file = [&](const std::string& name) {
    const fs::path file = written(folder / name, "left");
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1));
    return file;
  };
  const fs::path stale = old_file(".griffith_0123456789abcdef"), used = old_file(".griffith_00000000000000aa");
  const fs::path young = written(folder / ".griffith_00000000000000bb", "young");
  const fs::path users = old_file(".griffith_notes"), linked = folder / ".griffith_00000000000000cc";
  fs::create_symlink(users, linked);
  const Descriptor lock(open(used.c_str(), O_RDONLY));
  ASSERT_EQ(flock(lock.number(), LOCK_EX | LOCK_NB), 0);
  check_replaceable(folder / "result");
  EXPECT_FALSE(fs::exists(stale));
  for (const fs::path& kept : {used, young, users}) EXPECT_TRUE(fs::exists(kept)) << kept;
  EXPECT_TRUE(fs::is_symlink(linked));
}

TEST(ReplaceFile, TouchesNothingThatLiesBesideIt) {
  const fs::path folder = empty_folder(), victim = written(folder / "victim", "victim");
  written(folder / ".part", "mine");
  fs::create_symlink("victim", folder / "out.part");
  replace_file(folder / "out", "new");
  EXPECT_EQ(text_of(victim), "victim");
  EXPECT_EQ(text_of(folder / ".part"), "mine");
  EXPECT_TRUE(fs::is_symlink(folder / "out.part"));
  EXPECT_EQ(files_in(folder), 4);
}

TEST(ReplaceFile, LinksStayLinksAndTheFileAtTheirEndIsReplacedOrMade) {
  const fs::path folder = empty_folder();
  fs::create_directory(folder / "deep");
  written(folder / "deep/file", "old");
  fs::create_symlink("deep/middle", folder / "link");
  fs::create_symlink("file", folder / "deep/middle");
  fs::create_symlink("deep/made", folder / "dangling");
  replace_file(folder / "link", "new");
  replace_file(folder / "dangling", "made");
  EXPECT_EQ(text_of(folder / "deep/file"), "new");
  EXPECT_EQ(text_of(folder / "deep/made"), "made");
  for (const char* link : {"link", "deep/middle", "dangling"}) EXPECT_TRUE(fs::is_symlink(folder / link)) << link;
  EXPECT_EQ(files_in(folder), 3);
  EXPECT_EQ(files_in(folder / "deep"), 3);
}

TEST(ReplaceFile, LinksToNowhereAreReportedAndRemoveNothing) {
  const fs::path folder = empty_folder();
  written(folder / ".part", "mine");
  fs::create_symlink("/no/such/folder/x", folder / "nowhere");
  fs::create_symlink("loop", folder / "loop");
  EXPECT_THAT(problem_of([&] { replace_file(folder / "nowhere", "x"); }), HasSubstr("No such file or directory"));
  EXPECT_THAT(problem_of([&] { replace_file(folder / "loop", "x"); }), HasSubstr("symbolic links"));
  EXPECT_EQ(files_in(folder), 3);
}

/// The limit on file sizes stands in for a full disk; it needs no rights.
TEST(ReplaceFile, AFullDiskLeavesTheOldFileAndNothingElse) {
  const fs::path folder = empty_folder(), path = written(folder / "out", "old");
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit usual{};
  getrlimit(RLIMIT_FSIZE, &usual);
  const rlimit small = {4096, usual.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string problem = problem_of([&] { replace_file(path, std::string(100'000, 'x')); });
  setrlimit(RLIMIT_FSIZE, &usual);
  EXPECT_THAT(problem, HasSubstr("cannot be written: File too large"));
  EXPECT_EQ(text_of(path), "old");
  EXPECT_EQ(files_in(folder), 1);
}

TEST(ReplaceFile, AFullDeviceIsReportedAndStaysADevice) {
  EXPECT_THAT(problem_of([] { replace_file("/dev/full", "x"); }), HasSubstr("No space left on device"));
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  EXPECT_EQ(problem_of([] { replace_file("/dev/null", "x"); }), "none");
}

TEST(ReplaceFile, APipeIsWrittenTo) {
  const fs::path pipe = empty_folder() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string read;
  std::thread reader([&] { read = text_of(pipe); });
  replace_file(pipe, "through the pipe");
  reader.join();
  EXPECT_EQ(read, "through the pipe");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(ReplaceFile, ManyWritersAtOnceAllSucceed) {
  const fs::path folder = empty_folder();
  std::atomic<int> failures = 0;
  std::vector<std::thread> writers;
  for (int i = 0; i < 64; ++i)
    writers.emplace_back([&, i] {
      failures += problem_of([&] { replace_file(folder / "out", std::string(10'000, char('0' + i))); }) != "none";
    });
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(failures, 0);
  const std::string text = text_of(folder / "out");
  EXPECT_EQ(text, std::string(10'000, text.at(0)));
  EXPECT_EQ(files_in(folder), 1);
}

TEST(ReplaceFile, WhatCannotBeIsReportedBefore) {
  const fs::path folder = empty_folder(), file = written(folder / "file", "x");
  EXPECT_EQ(problem_of([&] { check_replaceable(folder / "new"); }), "none");
  EXPECT_EQ(problem_of([&] { check_replaceable(file); }), "none");
  EXPECT_EQ(problem_of([&] { check_replaceable(folder); }), "is a folder");
  EXPECT_THAT(problem_of([&] { check_replaceable(folder / "none/x"); }), HasSubstr("No such file or directory"));
  EXPECT_THAT(problem_of([&] { check_replaceable(file / "x"); }), HasSubstr("Not a directory"));
  EXPECT_EQ(files_in(folder), 1);
}

}  // namespace
}  // namespace griffith
