#include "sim/core/temporary_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "sim/core/descriptor.h"
#include "sim/core/error.h"

namespace griffith {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kStart = "griffith-";
constexpr std::size_t kRandomLength = 6;

/// Returns the lock of the folder if the folder is this user's and nobody holds its lock.
Descriptor lock_of(const fs::path& folder) {
  Descriptor lock(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  struct stat status {};
  const bool mine = lock.is_open() && fstat(lock.number(), &status) == 0 && status.st_uid == geteuid();
  return mine && flock(lock.number(), LOCK_EX | LOCK_NB) == 0 ? std::move(lock) : Descriptor(-1);
}

bool is_old(const fs::path& folder) {
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(folder, error);
  return !error && fs::file_time_type::clock::now() - time > std::chrono::minutes(1);
}

/// Removes the folders of killed programs: those with such a name whose lock nobody holds. A folder without a lock may
/// be about to get one, but is young.
void remove_stale_folders(const fs::path& among) {
  std::error_code error;
  for (fs::directory_iterator entry(among, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(kStart) || name.size() != kStart.size() + kRandomLength || !is_old(entry->path())) continue;
    std::error_code ignored;
    if (const Descriptor lock = lock_of(entry->path()); lock.is_open()) fs::remove_all(entry->path(), ignored);
  }
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  constexpr char kRemedy[] = "set TMPDIR to a writable folder with free space; the default is /tmp";
  std::error_code error;
  const fs::path folder = fs::temp_directory_path(error);
  if (error) throw InputError("TMPDIR", "names no folder for temporary files", kRemedy);
  remove_stale_folders(folder);
  std::string name = (folder / kStart).string() + "XXXXXX";
  if (mkdtemp(name.data()) == nullptr)
    throw InputError(name, "cannot be created: " + std::generic_category().message(errno), kRemedy);
  path_ = name;
  const Descriptor lock = lock_of(path_);
  lock_ = fcntl(lock.number(), F_DUPFD_CLOEXEC, 0);  // keeps the lock
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) close(lock_);
}

}  // namespace griffith
