#include "tests/fuzz/mutate_bytes.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

namespace griffith::fuzz {
namespace {

/// Part of a text.
struct ByteRange {
  std::size_t begin = 0, size = 0;
};

std::size_t place_in(const std::string& text, RandomValues& random) {
  return static_cast<std::size_t>(random.index(static_cast<int>(text.size()) + 1));
}

ByteRange random_range(const std::string& text, RandomValues& random) {
  const std::size_t begin = place_in(text, random);
  const int longest = chance(random, 0.8) ? 8 : 1024;
  return {begin, std::min(text.size() - begin, static_cast<std::size_t>(1 + random.index(longest)))};
}

template <class T>
std::string number_bytes(T value, bool big_endian) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string extreme_number(RandomValues& random) {
  static const std::vector<std::int64_t> kIntegers = {0,         1,          -1,
                                                      2,         5,          127,
                                                      255,       65535,      INT32_MAX,
                                                      INT32_MIN, UINT32_MAX, std::int64_t{1} << 32,
                                                      INT64_MAX, INT64_MIN,  std::int64_t{1} << 61};
  static const std::vector<double> kReals = {0,
                                             -0.0,
                                             1,
                                             -1,
                                             1e308,
                                             -1e308,
                                             1e-308,
                                             5e-324,
                                             1e154,
                                             3.5e38,
                                             1e-40,
                                             std::numeric_limits<double>::quiet_NaN(),
                                             std::numeric_limits<double>::infinity()};
  const bool big_endian = chance(random, 0.3);
  switch (random.index(4)) {
    case 0:
      return number_bytes(static_cast<std::int32_t>(pick(random, kIntegers)), big_endian);
    case 1:
      return number_bytes(pick(random, kIntegers), big_endian);
    case 2:
      return number_bytes(static_cast<float>(pick(random, kReals)), big_endian);
    default:
      return number_bytes(pick(random, kReals), big_endian);
  }
}

void damage_bytes(std::string& bytes, RandomValues& random) {
  const ByteRange at = random_range(bytes, random);
  const std::string piece = bytes.substr(at.begin, at.size);
  switch (random.index(8)) {
    case 0:
      if (!piece.empty()) bytes[at.begin] = static_cast<char>(bytes[at.begin] ^ 1 << random.index(8));
      break;
    case 1:
      if (!piece.empty()) bytes[at.begin] = static_cast<char>(random.index(256));
      break;
    case 2:
      bytes.insert(at.begin, 1 + random.index(8), static_cast<char>(random.index(256)));
      break;
    case 3:
      bytes.erase(at.begin, at.size);
      break;
    case 4:
      bytes.insert(place_in(bytes, random), piece);
      break;
    case 5:
      if (chance(random, 0.3)) bytes.resize(at.begin);
      break;
    default: {
      const std::string number = extreme_number(random);
      bytes.replace(at.begin, std::min(number.size(), bytes.size() - at.begin), number);
    }
  }
}

std::vector<ByteRange> parts_of(const std::string& text, std::string_view separators) {
  std::vector<ByteRange> parts;
  for (std::size_t begin = 0; (begin = text.find_first_not_of(separators, begin)) != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    parts.push_back({begin, end - begin});
    begin = end;
  }
  return parts;
}

void exchange(std::string& text, ByteRange a, ByteRange b) {
  if (a.begin > b.begin) std::swap(a, b);
  if (a.begin + a.size > b.begin) return;
  const std::string first = text.substr(a.begin, a.size), second = text.substr(b.begin, b.size);
  text.replace(b.begin, b.size, first).replace(a.begin, a.size, second);
}

/// A whole number near the one that stands there: counts and indices that are off by a little.
std::string near_number(const std::string& word, RandomValues& random) {
  constexpr std::size_t kMaxDigits = 9;
  const bool whole = !word.empty() && word.size() <= kMaxDigits && word.find_first_not_of("0123456789") == word.npos;
  return whole ? std::to_string(std::stoi(word) - 3 + random.index(7)) : pick(random, extreme_words());
}

void damage_text(std::string& text, RandomValues& random) {
  const bool lines = chance(random, 0.25);
  const std::vector<ByteRange> parts = parts_of(text, lines ? "\n" : " \t\r\n,;\"'<>=/");
  if (parts.empty()) return damage_bytes(text, random);
  const ByteRange at = pick(random, parts), other = pick(random, parts);
  const std::string part = text.substr(at.begin, at.size);
  switch (random.index(lines ? 4 : 8)) {
    case 0:
      text.erase(at.begin, at.size);
      break;
    case 1:
      text.insert(other.begin, part + (lines ? "\n" : " "));
      break;
    case 2:
      exchange(text, at, other);
      break;
    case 3:
      text.replace(other.begin, other.size, part);
      break;
    case 4:
    case 5:
      text.replace(at.begin, at.size, near_number(part, random));
      break;
    default:
      text.replace(at.begin, at.size, pick(random, extreme_words()));
  }
}

int how_often(RandomValues& random) { return chance(random, 0.6) ? 1 : 2 + random.index(3); }

}  // namespace

const std::vector<std::string>& extreme_words() {
  static const std::vector<std::string> kWords = {"0",
                                                  "-0",
                                                  "-1",
                                                  "1",
                                                  "2",
                                                  "0.5",
                                                  "1e10",
                                                  "1e-10",
                                                  "1e38",
                                                  "1e39",
                                                  "1e154",
                                                  "1e200",
                                                  "1e308",
                                                  "-1e308",
                                                  "1e-308",
                                                  "5e-324",
                                                  "1e309",
                                                  "1e-400",
                                                  "nan",
                                                  "inf",
                                                  "-inf",
                                                  "2147483647",
                                                  "2147483648",
                                                  "-2147483648",
                                                  "4294967295",
                                                  "4294967296",
                                                  "9223372036854775807",
                                                  "9223372036854775808",
                                                  "-9223372036854775808",
                                                  "18446744073709551615",
                                                  "18446744073709551616",
                                                  "1000000000",
                                                  "0x7f",
                                                  "1,5",
                                                  "+1",
                                                  "--1",
                                                  "1e",
                                                  "e",
                                                  ".",
                                                  "",
                                                  "\xff\xfe"};
  return kWords;
}

std::string mutate_bytes(std::string bytes, RandomValues& random) {
  for (int i = how_often(random); i > 0; --i) damage_bytes(bytes, random);
  return bytes;
}

std::string mutate_text(std::string text, RandomValues& random) {
  for (int i = how_often(random); i > 0; --i) damage_text(text, random);
  return text;
}

std::string mutate_file(std::string content, RandomValues& random) {
  const bool binary = content.find('\0') != std::string::npos;
  return chance(random, binary ? 0.6 : 0.15) ? mutate_bytes(std::move(content), random)
                                             : mutate_text(std::move(content), random);
}

}  // namespace griffith::fuzz
