#include "sim/replace_file.h"

#include <fstream>
#include <system_error>

#include "sim/error.h"

namespace griffith {
namespace {

namespace fs = std::filesystem;

bool write(const fs::path& path, std::string_view content) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  return bool(file);
}

bool write_beside_and_rename(const fs::path& path, std::string_view content) {
  fs::path beside = path;
  beside += ".part";
  std::error_code error;
  if (write(beside, content)) {
    fs::rename(beside, path, error);
    if (!error) return true;
  }
  std::error_code ignored;
  fs::remove(beside, ignored);
  return false;
}

}  // namespace

void replace_file(const fs::path& path, std::string_view content) {
  std::error_code error;
  // A link stays a link; what is no file (a pipe, a terminal) is written to as it is.
  const fs::path target = fs::is_symlink(path, error) ? fs::canonical(path, error) : path;
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) throw InputError(path.string(), "is a folder", "give the name of a file in it");
  const bool file = !fs::exists(status) || fs::is_regular_file(status);
  if (file ? write_beside_and_rename(target, content) : write(target, content)) return;
  throw InputError(path.string(), "cannot be written", "choose a folder that exists, may be written to and has room");
}

}  // namespace griffith
