#include "sim/replace_file.h"

#include <fstream>
#include <system_error>

#include "sim/error.h"

namespace griffith {

void replace_file(const std::filesystem::path& path, std::string_view content) {
  std::filesystem::path beside = path;
  beside += ".part";
  std::ofstream file(beside, std::ios::binary | std::ios::trunc);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(beside, path, error);
  if (file && !error) return;
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  throw InputError(path.string(), "cannot be written", "a writable folder with enough room");
}

}  // namespace griffith
