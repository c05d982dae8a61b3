#include "sim/core/file_path.h"

#include "test_folder.h"

namespace griffith {
namespace {

namespace fs = std::filesystem;
using namespace griffith::testing;

TEST(FilePath, WithinAFolderIsWhatNoLinkLeadsOutOfIt) {
  const fs::path root = empty_folder(), folder = root / "scene";
  fs::create_directories(folder / "below");
  fs::create_directories(root / "outside");
  fs::create_directories(root / "scenes");
  written(root / "outside/secret", "secret");
  for (const char* name : {"scene/a", "scene/below/b", "scenes/c"}) written(root / name, "");
  fs::create_symlink("a", folder / "near");
  fs::create_symlink("../outside/secret", folder / "far");
  fs::create_directory_symlink("../outside", folder / "sub");
  for (const char* name : {"a", "below/b", "near", "below/../a"}) EXPECT_TRUE(is_within(folder, folder / name)) << name;
  for (const char* name : {"far", "sub/secret", "../outside/secret", "../scenes/c", "none", "."})
    EXPECT_FALSE(is_within(folder, folder / name)) << name;
}

}  // namespace
}  // namespace griffith
