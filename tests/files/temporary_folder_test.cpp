#include "sim/core/temporary_folder.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cstdlib>

#include "sim/core/descriptor.h"
#include "test_folder.h"

namespace griffith {
namespace {

namespace fs = std::filesystem;
using namespace griffith::testing;

void make_old(const fs::path& path) {
  fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(1));
}

/// A folder with a file, an hour old.
fs::path old_folder(const fs::path& path) {
  fs::create_directories(path);
  written(path / "file", "left");
  make_old(path);
  return path;
}

TEST(TemporaryFolder, RemovesWhatKilledProgramsLeftAndNothingElse) {
  const fs::path root = empty_folder();
  const char* before = std::getenv("TMPDIR");
  const std::string old_value = before ? before : "";
  setenv("TMPDIR", root.c_str(), 1);
  old_folder(root / "griffith-a1B2c3");
  const fs::path elsewhere = old_folder(root / "of_the_users");
  for (const char* name : {"griffith-notes", "griffith-a1B2c", "griffith_a1B2c3", "other-a1B2c3"}) {
    old_folder(root / name);
  }
  fs::create_directory_symlink(elsewhere, root / "griffith-linked");
  const fs::path young = root / "griffith-young1", used = old_folder(root / "griffith-inUse1");
  fs::create_directories(young);
  const Descriptor lock(open(used.c_str(), O_RDONLY | O_DIRECTORY));
  ASSERT_EQ(flock(lock.number(), LOCK_EX | LOCK_NB), 0);
  {
    const TemporaryFolder first;
    make_old(first.path());
    const TemporaryFolder second;
    EXPECT_TRUE(fs::exists(first.path())) << "it is in use";
  }
  EXPECT_FALSE(fs::exists(root / "griffith-a1B2c3"));
  for (const char* name : {"griffith-a1B2c", "griffith_a1B2c3", "other-a1B2c3", "of_the_users/file"})
    EXPECT_TRUE(fs::exists(root / name)) << name;
  EXPECT_TRUE(fs::exists(young) && fs::exists(used / "file"));
  EXPECT_TRUE(fs::is_symlink(root / "griffith-linked"));
  before ? setenv("TMPDIR", old_value.c_str(), 1) : unsetenv("TMPDIR");
}

}  // namespace
}  // namespace griffith
