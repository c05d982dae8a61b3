#include "app/output/output.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <span>
#include <system_error>

#include "sim/core/replace_file.h"

namespace griffith::app {

void explain(const InputError& error) {
  std::fprintf(stderr, "griffith: %s: %s\n", error.where().c_str(), error.problem().c_str());
  if (!error.remedy().empty()) std::fprintf(stderr, "  %s\n", error.remedy().c_str());
}

void save_picture(const std::filesystem::path& path, const render::Image& image) {
  replace_file(path, render::encode_png(image));
}

void check_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::path there = std::filesystem::absolute(folder).lexically_normal();
  while (!std::filesystem::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  if (!std::filesystem::is_directory(there, error) || access(there.c_str(), W_OK | X_OK) != 0)
    throw InputError(folder.string(), "is no folder and cannot be made one", "name a folder that may be written to");
}

void check_stdout() {
  const bool failed_before = std::ferror(stdout) != 0;
  bool written = std::fflush(stdout) == 0 && !failed_before;
  // Some file systems report a failed write only when the file is closed; a copy's closing tells, too.
  if (const int copy = dup(STDOUT_FILENO); written && copy >= 0) written = close(copy) == 0;
  if (written) return;
  const std::string reason = failed_before ? "" : ": " + std::generic_category().message(errno);
  throw InputError("stdout", "cannot be written" + reason, "send the output where there is room");
}

void Outputs::write(const std::function<void()>& output) try { output(); } catch (const InputError& error) {
  failures_.push_back(error);
}

void Outputs::finish() const {
  if (failures_.empty()) return;
  for (const InputError& error : std::span(failures_).first(failures_.size() - 1)) explain(error);
  throw failures_.back();
}

}  // namespace griffith::app
