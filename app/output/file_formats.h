#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/core/error.h"

namespace griffith::app {

/// Returns ".glb, .usda or .csv".
inline std::string listed(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
    text.append(i == 0 ? "" : i + 1 < items.size() ? ", " : " or ").append(items[i]);
  return text;
}

/// Lists formats of a table for help: ".vtu (ParaView) or .msh (Gmsh)".
std::string formats_text(const auto& formats) {
  std::vector<std::string> items;
  for (const auto& format : formats)
    items.push_back(std::string(format.extension) + " (" + std::string(format.content) + ")");
  return listed(items);
}

/// Lists their extensions: ".vtu or .msh".
std::string extensions_text(const auto& formats) {
  std::vector<std::string> items;
  for (const auto& format : formats) items.emplace_back(format.extension);
  return listed(items);
}

/// Throws InputError unless the path ends in an extension, such as ".tar.zst". `kind`: the kind of file, such as
/// "recording".
inline void require_extension(const std::filesystem::path& path, const std::string& extension, const char* kind) {
  if (!path.string().ends_with(extension))
    throw InputError(path.string(), std::string("is not the name of a ") + kind, "use the extension " + extension);
}

/// Returns the format with the path's extension. Throws InputError, which lists all, if there is none.
const auto& format_of(const auto& formats, const std::filesystem::path& path, const char* extension = "extension") {
  for (const auto& format : formats)
    if (path.extension() == format.extension) return format;
  throw InputError(path.string(), std::string("has no supported ") + extension, "use " + extensions_text(formats));
}

}  // namespace griffith::app
