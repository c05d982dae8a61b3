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

/// Storage of numbers.
enum class Encoding { text, little_endian, big_endian };

/// Returns the little-endian or big-endian number at `bytes`.
template <class T>
T decode_number(const char* bytes, Encoding encoding) {
  char copy[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) copy[i] = bytes[encoding == Encoding::big_endian ? sizeof(T) - 1 - i : i];
  T value;
  std::memcpy(&value, copy, sizeof(T));
  return value;
}
static_assert(std::endian::native == std::endian::little);

/// Parses a whole word as a finite number. Returns false for anything else and for numbers out of T's range.
template <class T>
bool parse_number(std::string_view word, T& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return false;
  if constexpr (std::is_floating_point_v<T>) return std::isfinite(value);
  return true;
}

/// Position in a mesh file held in memory. Every read names the expected item. Anything else causes an InputError that
/// names the file and the line or, for binary numbers, the byte.
class FileCursor {
 public:
  /// Reads the file. White space and any of `separators` separate words. `comment`, if not 0, starts a comment up to
  /// the end of the line.
  explicit FileCursor(const std::filesystem::path& path, std::string_view separators = "", char comment = 0);

  /// Encoding of the following numbers. Words are always text.
  Encoding encoding = Encoding::text;

  /// True if only blanks and comments remain.
  bool at_end();
  /// Returns the next word.
  std::string_view word(const char* expected);
  /// Reads a word that must be `text`.
  void expect(std::string_view text);
  /// Returns the rest of the current line without its line break. The cursor moves past the break.
  std::string_view rest_of_line();
  /// Returns `count` raw bytes.
  std::string_view bytes(std::int64_t count, const char* expected);
  /// Moves past the next occurrence of `text`. Returns false and moves to the end if there is none.
  bool skip_past(std::string_view text);

  /// Returns the next finite number in the current encoding.
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

  /// Rejects a count that is negative or that the rest of the file cannot hold, at `numbers_each` numbers of
  /// `bytes_per_number` bytes (if binary). Prevents a wrong count from filling the memory.
  void require_room(std::int64_t count, std::int64_t numbers_each, std::int64_t bytes_per_number,
                    const char* what) const;

  /// Returns the whole file.
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
  std::size_t start_ = 0;  ///< start of the last item read, for messages
};

}  // namespace griffith
