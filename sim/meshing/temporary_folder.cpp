#include "sim/meshing/temporary_folder.h"

#include <cstdlib>

#include "sim/error.h"

namespace griffith {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "griffith_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw InputError(name, "cannot be made", "TMPDIR has to name a folder that may be written to and has room");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace griffith
