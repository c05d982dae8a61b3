#pragma once

#include <span>
#include <string_view>

namespace griffith {

/// Something that colours can show, per node or tet.
struct ViewQuantity {
  std::string_view key;    ///< as in a scene file: "von_mises"
  std::string_view label;  ///< as in a menu or a legend: "von Mises stress"
  std::string_view unit;   ///< "Pa"; "-" for a ratio, "" for an id
};

/// All quantities, in the order in which menus show them.
std::span<const ViewQuantity> view_quantities();
/// All colour maps' names, in the order in which menus show them.
std::span<const std::string_view> color_map_names();

}  // namespace griffith
