#include "sim/core/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <system_error>

#include "sim/core/descriptor.h"
#include "sim/core/error.h"

namespace griffith {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
  if (errno == ENOENT) throw InputError(path.string(), "no such file", "check the path");
  throw InputError(path.string(), "cannot be read: " + std::generic_category().message(errno),
                   "name a file that exists and may be read");
}

void require_regular(const std::filesystem::path& path, const struct stat& status) {
  if (S_ISDIR(status.st_mode)) throw InputError(path.string(), "is a folder", "name a file in it");
  if (!S_ISREG(status.st_mode))
    throw InputError(path.string(), "is not a regular file",
                     "pipes and devices are not read: save the content as a file");
}

std::string size_text(std::int64_t bytes) {
  constexpr std::int64_t kMegabyte = 1 << 20;
  return bytes < kMegabyte ? std::to_string(bytes) + " bytes" : std::to_string(bytes / kMegabyte) + " MB";
}

}  // namespace

void require_regular_file(const std::filesystem::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) fail(path);
  require_regular(path, status);
}

std::string read_file(const std::filesystem::path& path, std::int64_t max_bytes) {
  // Without O_NONBLOCK, opening a pipe would wait for its writer.
  const Descriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  struct stat status {};
  if (!file.is_open() || fstat(file.number(), &status) != 0) fail(path);
  require_regular(path, status);
  if (status.st_size > max_bytes)
    throw InputError(path.string(), "is larger than " + size_text(max_bytes), "is it the intended file?");
  std::string content(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t filled = 0;
  while (filled < content.size()) {
    const ssize_t count = read(file.number(), content.data() + filled, content.size() - filled);
    if (count == 0) break;  // the file was truncated meanwhile
    if (count < 0 && errno != EINTR) fail(path);
    if (count > 0) filled += static_cast<std::size_t>(count);
  }
  content.resize(filled);
  return content;
}

}  // namespace griffith
