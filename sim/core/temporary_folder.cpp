#include "sim/core/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "sim/core/error.h"

namespace griffith {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  constexpr char kRemedy[] = "TMPDIR has to name a folder that may be written to and has room; without it that is /tmp";
  std::error_code error;
  const fs::path folder = fs::temp_directory_path(error);
  if (error) throw InputError("TMPDIR", "names no folder for temporary files", kRemedy);
  std::string name = (folder / "griffith_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw InputError(name, "cannot be made: " + std::generic_category().message(errno), kRemedy);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace griffith
