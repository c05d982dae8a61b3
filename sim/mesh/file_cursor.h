#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>

namespace griffith {

/// How numbers are stored.
enum class Encoding { text, little_endian, big_endian };

/// The little-endian or big-endian number at `bytes`.
template <class T>
T decode_number(const char* bytes, Encoding encoding) {
  char copy[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) copy[i] = bytes[encoding == Encoding::big_endian ? sizeof(T) - 1 - i : i];
  T value;
  std::memcpy(&value, copy, sizeof(T));
  return value;
}
static_assert(std::endian::native == std::endian::little);

/// Parses a whole word as a finite number; false when it is something else or out of T's range.
template <class T>
bool parse_number(std::string_view word, T& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return false;
  if constexpr (std::is_floating_point_v<T>) return std::isfinite(value);
  return true;
}

/// A position in a mesh file held in memory. Every read names what it expects there; what it finds instead is answered
/// with an InputError that names the file and the line or, where numbers are binary, the byte.
class FileCursor {
 public:
  /// Reads the file. Words are parted by white space and by any of `separators`; `comment`, if not 0, starts a comment
  /// that lasts to the end of the line.
  explicit FileCursor(const std::filesystem::path& path, std::string_view separators = "", char comment = 0);

  /// Encoding of the numbers that follow; words are text always.
  Encoding encoding = Encoding::text;

  /// Whether only blanks and comments remain.
  bool at_end();
  /// The next word.
  std::string_view word(const char* expected);
  /// Reads a word that must be `text`.
  void expect(std::string_view text);
  /// What is left of the current line, without its line break; the cursor moves behind the break.
  std::string_view rest_of_line();
  /// `count` raw bytes.
  std::string_view bytes(std::int64_t count, const char* expected);
  /// Moves behind the next occurrence of `text`; false, and to the end, when there is none.
  bool skip_past(std::string_view text);

  /// The next number, in the current encoding; finite.
  template <class T>
  T number(const char* expected) {
    T value{};
    if (encoding == Encoding::text) {
      const std::string_view found = word(expected);
      if (!parse_number(found, value)) fail_expecting(expected, found);
    } else {
      value = decode_number<T>(bytes(sizeof(T), expected).data(), encoding);
      if constexpr (std::is_floating_point_v<T>)
        if (!std::isfinite(value)) fail_expecting(expected, "a number that is not finite");
    }
    return value;
  }

  /// Refuses a count that is negative or that the rest of the file cannot hold, at `numbers_each` numbers of
  /// `bytes_per_number` bytes (if binary): a wrong count must not fill the memory.
  void require_room(std::int64_t count, std::int64_t numbers_each, std::int64_t bytes_per_number,
                    const char* what) const;

  /// All of the file.
  std::string_view text() const { return text_; }
  std::size_t offset() const { return offset_; }
  void seek(std::size_t offset) { offset_ = offset; }

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const;
  [[noreturn]] void fail_expecting(const char* expected, std::string_view found) const;

 private:
  bool is_blank(char c) const;

  std::string name_, text_;
  std::string separators_;
  char comment_;
  std::size_t offset_ = 0;
  std::size_t start_ = 0;  ///< of what was read last, for messages
};

}  // namespace griffith
