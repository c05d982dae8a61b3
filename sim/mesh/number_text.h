#pragma once

#include <charconv>
#include <string>

namespace griffith {

/// Appends the shortest text that reads back as the same number, then `end`.
template <class T>
void append_number(std::string& text, T value, char end) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  text += end;
}

}  // namespace griffith
