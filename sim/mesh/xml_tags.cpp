#include "sim/mesh/xml_tags.h"

namespace griffith {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

/// Reads key="value" pairs. `text`: the tag between its name and its end.
void read_attributes(FileCursor& cursor, std::string_view text, XmlTag& tag) {
  while (true) {
    const std::size_t key_begin = text.find_first_not_of(kBlanks);
    if (key_begin == std::string_view::npos) return;
    const std::size_t equals = text.find('=', key_begin);
    const std::size_t open = equals == std::string_view::npos ? equals : text.find_first_not_of(kBlanks, equals + 1);
    if (open == std::string_view::npos || (text[open] != '"' && text[open] != '\''))
      cursor.fail("tag <" + tag.name + "> has a broken attribute", "expected name=\"value\"");
    const std::size_t close = text.find(text[open], open + 1);
    if (close == std::string_view::npos) cursor.fail("tag <" + tag.name + "> has an open quote", "close it");
    std::string_view key = text.substr(key_begin, equals - key_begin);
    key = key.substr(0, key.find_first_of(kBlanks));
    tag.attributes.emplace_back(key, text.substr(open + 1, close - open - 1));
    text.remove_prefix(close + 1);
  }
}

}  // namespace

std::string XmlTag::attribute(std::string_view key, std::string_view fallback) const {
  for (const auto& [name_of_attribute, value] : attributes)
    if (name_of_attribute == key) return value;
  return std::string(fallback);
}

bool next_xml_tag(FileCursor& cursor, XmlTag& tag) {
  while (cursor.skip_past("<")) {
    const std::size_t begin = cursor.offset() - 1;
    const std::string_view rest = cursor.text().substr(begin + 1);
    if (rest.starts_with("!--") || rest.starts_with("?")) {
      cursor.skip_past(rest[0] == '!' ? "-->" : "?>");
      continue;
    }
    const std::size_t length = rest.find('>');
    cursor.seek(begin);
    cursor.bytes(1, "a tag");  // place of later messages
    if (length == std::string_view::npos) cursor.fail("a tag has no end", "expected >");
    cursor.seek(begin + 1 + length + 1);

    std::string_view inside = rest.substr(0, length);
    tag = {};
    tag.begin = begin;
    tag.end = cursor.offset();
    tag.closes = inside.starts_with("/");
    if (tag.closes) inside.remove_prefix(1);
    tag.is_empty = inside.ends_with("/");
    if (tag.is_empty) inside.remove_suffix(1);
    const std::size_t name_length = std::min(inside.find_first_of(kBlanks), inside.size());
    tag.name = inside.substr(0, name_length);
    read_attributes(cursor, inside.substr(name_length), tag);
    return true;
  }
  return false;
}

}  // namespace griffith
