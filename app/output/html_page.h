#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace griffith::app {

/// A character of UTF-8.
struct Utf8Character {
  std::size_t length = 0;  ///< number of bytes; 0 if they are no character, or one that XML may not hold
  std::uint32_t code = 0;
};
/// The character that `text`, which is not empty, begins with.
Utf8Character first_character(std::string_view text);

/// Text as HTML and XML show it, between tags and in quoted attributes. What neither may hold, control characters and
/// bytes that are not UTF-8, becomes U+FFFD; a carriage return, by which a terminal writes over a line, its number.
std::string escape_markup(std::string_view text);

/// Bytes as base64 with padding (RFC 4648), on one line.
std::string base64(std::string_view bytes);

/// The data URI of a PNG file's bytes, for the attribute src of an image.
std::string png_data_uri(std::string_view png);

/// A whole page that needs no other file. `title` is text; `head` (styles, scripts) and `body` are HTML. Its style
/// follows the reader's light or dark scheme and defines the colours --page, --panel, --line, --text, --muted, --good,
/// --bad, --warn and --accent.
std::string html_page(std::string_view title, std::string_view head, std::string_view body);

}  // namespace griffith::app
