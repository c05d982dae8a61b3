#include "app/output/output.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <span>
#include <system_error>

#include "app/output/html_page.h"
#include "sim/core/replace_file.h"

namespace griffith::app {

namespace {

std::string formatted(const char* format, std::va_list arguments) {
  std::va_list again;
  va_copy(again, arguments);
  std::string text(static_cast<std::size_t>(std::max(std::vsnprintf(nullptr, 0, format, again), 0)), '\0');
  va_end(again);
  std::vsnprintf(text.data(), text.size() + 1, format, arguments);
  return text;
}

/// Prints text with the program's own line breaks, for columns and paragraphs.
void print_lines(std::FILE* file, std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::fputs(printable(text.substr(0, end)).c_str(), file);
    if (end == std::string_view::npos) return;
    std::fputc('\n', file);
    text.remove_prefix(end + 1);
  }
}

/// True for invisible characters that control a terminal: C0, DEL, C1, and marks that reorder or hide their neighbors.
bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || (code >= 0x200B && code <= 0x200F) ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2060 && code <= 0x206F) || code == 0xFEFF;
}

std::string escape_of(std::string_view bytes) {
  std::string text;
  for (const unsigned char byte : bytes) {
    char escape[8];
    std::snprintf(escape, sizeof escape, "\\x%02x", byte);
    text += escape;
  }
  return text;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const Utf8Character character = first_character(text);
    const std::string_view bytes = text.substr(0, std::max<std::size_t>(character.length, 1));
    shown += character.length == 0 || is_control(character.code) ? escape_of(bytes) : std::string(bytes);
    text.remove_prefix(bytes.size());
  }
  return shown;
}

void print(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  print_lines(stdout, formatted(format, arguments));
  va_end(arguments);
}

void print_error(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  print_lines(stderr, formatted(format, arguments));
  va_end(arguments);
}

void explain(const InputError& error) {
  print_error("griffith: %s: %s\n", printable(error.where()).c_str(), printable(error.problem()).c_str());
  if (!error.remedy().empty()) print_error("  %s\n", printable(error.remedy()).c_str());
}

void save_picture(const std::filesystem::path& path, const render::Image& image) {
  replace_file(path, render::encode_png(image));
}

void check_folder(const std::filesystem::path& folder) {
  if (folder.empty()) throw InputError("the folder", "has no path", "name a writable folder");
  std::error_code error;
  std::filesystem::path there = std::filesystem::absolute(folder).lexically_normal();
  while (!std::filesystem::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  if (!std::filesystem::is_directory(there, error) || access(there.c_str(), W_OK | X_OK) != 0)
    throw InputError(folder.string(), "cannot be created as a folder", "name a writable folder");
  remove_stale_files(folder);
}

void check_stdout() {
  const bool failed_before = std::ferror(stdout) != 0;
  bool written = std::fflush(stdout) == 0 && !failed_before;
  // Some file systems report a failed write only when the file is closed; closing a copy reports it too.
  if (const int copy = dup(STDOUT_FILENO); written && copy >= 0) written = close(copy) == 0;
  if (written) return;
  const std::string reason = failed_before ? "" : ": " + std::generic_category().message(errno);
  throw InputError("stdout", "cannot be written" + reason, "free some space");
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
