#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/mesh/file_cursor.h"

namespace griffith {

/// Start tag, end tag or empty tag (`<a/>`).
struct XmlTag {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  bool closes = false;    ///< </name>
  bool is_empty = false;  ///< <name/>
  std::size_t begin = 0;  ///< offset of its `<`
  std::size_t end = 0;    ///< offset after its `>`

  /// Returns an attribute's value, or `fallback`.
  std::string attribute(std::string_view key, std::string_view fallback = "") const;
};

/// Reads the next tag at or after the cursor, which moves past it. Skips text, comments and declarations. Returns false
/// if there is none. Supports the XML that VTK writes, without entities and CDATA.
bool next_xml_tag(FileCursor& cursor, XmlTag& tag);

}  // namespace griffith
