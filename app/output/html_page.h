#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace griffith::app {

/// A UTF-8 character.
struct Utf8Character {
  std::size_t length = 0;  ///< number of bytes; 0 for invalid bytes or a character that XML does not allow
  std::uint32_t code = 0;
};
/// Returns the first character of `text`, which must not be empty.
Utf8Character first_character(std::string_view text);

/// Escapes text for HTML and XML, between tags and in quoted attributes. Invalid characters, control characters and
/// bytes that are not UTF-8, become U+FFFD; a carriage return, with which a terminal overwrites a line, becomes its
/// numeric reference.
std::string escape_markup(std::string_view text);

/// Encodes bytes as base64 with padding (RFC 4648), on one line.
std::string base64(std::string_view bytes);

/// Returns the data URI of a PNG file's bytes, for the attribute src of an image.
std::string png_data_uri(std::string_view png);

/// Returns a complete page that needs no other file. `title` is text; `head` (styles, scripts) and `body` are HTML. Its
/// style follows the user's light or dark scheme and defines the colors --page, --panel, --line, --text, --muted,
/// --good, --bad, --warn and --accent.
std::string html_page(std::string_view title, std::string_view head, std::string_view body);

}  // namespace griffith::app
