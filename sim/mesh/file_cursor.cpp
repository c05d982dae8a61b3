#include "sim/mesh/file_cursor.h"

#include <algorithm>
#include <limits>

#include "sim/core/error.h"
#include "sim/core/file_content.h"

namespace griffith {

FileCursor::FileCursor(const std::filesystem::path& path, std::string_view separators, char comment)
    : name_(path.string()), text_(read_expected_file(path)), separators_(separators), comment_(comment) {}

bool FileCursor::is_blank(char c) const {
  return c == ' ' || (c >= '\t' && c <= '\r') || separators_.find(c) != std::string::npos;
}

bool FileCursor::at_end() {
  while (offset_ < text_.size()) {
    if (comment_ != 0 && text_[offset_] == comment_)
      rest_of_line();
    else if (is_blank(text_[offset_]))
      ++offset_;
    else
      return false;
  }
  return true;
}

std::string_view FileCursor::word(const char* expected) {
  const bool ended = at_end();
  start_ = offset_;
  if (ended) fail_expecting(expected, "the end of the file");
  while (offset_ < text_.size() && !is_blank(text_[offset_])) ++offset_;
  return std::string_view(text_).substr(start_, offset_ - start_);
}

void FileCursor::expect(std::string_view expected) {
  const std::string name(expected);
  const std::string_view found = word(name.c_str());
  if (found != expected) fail_expecting(name.c_str(), found);
}

std::string_view FileCursor::rest_of_line() {
  start_ = offset_;
  const std::size_t end = std::min(text_.find('\n', offset_), text_.size());
  offset_ = std::min(end + 1, text_.size());
  std::string_view line = std::string_view(text_).substr(start_, end - start_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view FileCursor::bytes(std::int64_t count, const char* expected) {
  start_ = offset_;
  if (count < 0 || static_cast<std::size_t>(count) > text_.size() - offset_)
    fail_expecting(expected, "the end of the file");
  offset_ += count;
  return std::string_view(text_).substr(start_, count);
}

bool FileCursor::skip_past(std::string_view wanted) {
  const std::size_t found = text_.find(wanted, offset_);
  offset_ = found == std::string::npos ? text_.size() : found + wanted.size();
  return found != std::string::npos;
}

void FileCursor::require_room(std::int64_t count, std::int64_t numbers_each, std::int64_t bytes_per_number,
                              const char* what) const {
  // A number takes at least a digit and a blank as text.
  const double each = double(numbers_each) * double(encoding == Encoding::text ? 2 : bytes_per_number);
  const double room = double(text_.size() - offset_) + 1;
  if (count < 0 || count > std::numeric_limits<std::int32_t>::max() || double(count) * each > room)
    fail("announces " + std::to_string(count) + " " + what, "the rest of the file cannot hold so many");
}

void FileCursor::fail(const std::string& problem, const std::string& remedy) const {
  const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(start_), '\n');
  const std::string place =
      encoding == Encoding::text ? ":" + std::to_string(line) : ", byte " + std::to_string(start_);
  throw InputError(name_ + place, problem, remedy);
}

void FileCursor::fail_expecting(const char* expected, std::string_view found) const {
  std::string shown;
  for (char c : found.substr(0, 40)) shown += c >= ' ' && c <= '~' ? c : '?';
  fail("found " + shown, std::string("expected ") + expected);
}

}  // namespace griffith
