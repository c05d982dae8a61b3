#include "sim/core/replace_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>

#include <cstdint>
#include <cstdio>
#include <ctime>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "sim/core/descriptor.h"
#include "sim/core/error.h"
#include "sim/core/termination_hold.h"

namespace griffith {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, int error) {
  throw InputError(path.string(), "cannot be written: " + std::generic_category().message(error),
                   "choose an existing, writable folder with free space");
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : "."; }

/// Returns the end of a chain of links, whether it exists or not.
fs::path links_followed(const fs::path& path) {
  constexpr int kMaxLinks = 40;
  fs::path file = path;
  std::error_code error;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(file, error); ++i)
    file = folder_of(file) / fs::read_symlink(file, error);
  return file;
}

/// Destination of the content.
struct Target {
  fs::path path;
  std::optional<struct stat> old;  ///< status of the file to be replaced, if any
  bool direct = false;             ///< a device or a pipe, written without replacement
};

Target target_of(const fs::path& path) {
  struct stat named {
  }, found{};
  const fs::path file = links_followed(path);
  if (stat(path.c_str(), &named) != 0) {
    if (errno != ENOENT) fail(path, errno);
    return {file, {}};
  }
  if (S_ISDIR(named.st_mode)) throw InputError(path.string(), "is a folder", "give the name of a file in it");
  // The links of /proc, such as /dev/stdout, have no file of that name at their end.
  const bool same = lstat(file.c_str(), &found) == 0 && found.st_dev == named.st_dev && found.st_ino == named.st_ino;
  if (same && S_ISREG(named.st_mode)) return {file, named};
  return {path, {}, true};
}

/// Returns the target. Throws if it is already certain that nothing can be written there.
Target writable_target(const fs::path& path) {
  Target target = target_of(path);
  const bool there = target.direct || target.old;
  if (there && faccessat(AT_FDCWD, target.path.c_str(), W_OK, AT_EACCESS) != 0) fail(path, errno);
  const fs::path folder = folder_of(target.path) / ".";
  if (!target.direct && faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) fail(path, errno);
  return target;
}

bool write_all(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t count = write(file, content.data(), content.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) content.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

constexpr std::string_view kFreshStart = ".griffith_";
constexpr std::size_t kFreshDigits = 16;

/// Returns a name that nobody can have used before.
fs::path fresh_name(const fs::path& folder) {
  std::uint64_t random = 0;
  while (getrandom(&random, sizeof random, 0) != sizeof random) {
  }
  char digits[kFreshDigits + 1];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(random));
  return folder / std::string(kFreshStart).append(digits);
}

bool is_fresh_name(std::string_view name) {
  return name.size() == kFreshStart.size() + kFreshDigits && name.starts_with(kFreshStart) &&
         name.find_first_not_of("0123456789abcdef", kFreshStart.size()) == std::string_view::npos;
}

/// True if nobody writes the file: it belongs to this user, is a minute old, and its lock is free.
bool is_stale(const fs::path& path) {
  constexpr std::time_t kSeconds = 60;
  const Descriptor file(open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  return file.is_open() && fstat(file.number(), &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink == 1 &&
         status.st_uid == geteuid() && std::time(nullptr) - status.st_mtime > kSeconds &&
         flock(file.number(), LOCK_EX | LOCK_NB) == 0;
}

/// Sets owner, group and mode of the old file as far as permitted.
void keep_ownership(int file, const struct stat& old) {
  if (fchown(file, old.st_uid, old.st_gid) != 0 && fchown(file, static_cast<uid_t>(-1), old.st_gid) != 0) errno = 0;
  fchmod(file, old.st_mode & 07777);
}

/// The old content is replaced only for content that is on the disk.
bool reaches_disk(int file) { return fdatasync(file) == 0 || errno == EINVAL || errno == ENOSYS; }

/// Writes the new file `beside` the target. Returns false and sets errno if that fails.
bool write_new(const fs::path& beside, const Target& target, std::string_view content) {
  constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  Descriptor file(open(beside.c_str(), kFlags, target.old ? 0600 : 0666));
  if (!file.is_open()) return false;
  flock(file.number(), LOCK_EX | LOCK_NB);  // marks the file as not stale
  if (target.old) keep_ownership(file.number(), *target.old);
  return write_all(file.number(), content) && (!target.old || reaches_disk(file.number())) && file.close();
}

bool write_directly(const fs::path& path, std::string_view content) {
  Descriptor file(open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC));
  return file.is_open() && write_all(file.number(), content) && file.close();
}

bool write_beside_and_rename(const Target& target, std::string_view content) {
  const TerminationHold hold;
  const fs::path beside = fresh_name(folder_of(target.path));
  if (write_new(beside, target, content) && std::rename(beside.c_str(), target.path.c_str()) == 0) return true;
  const int error = errno;
  if (error != EEXIST) unlink(beside.c_str());
  errno = error;
  return false;
}

}  // namespace

void replace_file(const fs::path& path, std::string_view content) {
  const Target target = writable_target(path);
  const bool written = target.direct ? write_directly(path, content) : write_beside_and_rename(target, content);
  if (!written) fail(path, errno);
}

void remove_stale_files(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> stale;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (is_fresh_name(entry->path().filename().string()) && is_stale(entry->path())) stale.push_back(entry->path());
  for (const fs::path& path : stale) unlink(path.c_str());
}

void check_replaceable(const fs::path& path) {
  const Target target = writable_target(path);
  if (!target.direct) remove_stale_files(folder_of(target.path));
}

}  // namespace griffith
