#pragma once

#include <span>
#include <string_view>

namespace griffith {

/// Something that colours can show, per node or tet.
struct ViewQuantity {
  std::string_view key;    ///< as in a scene file: "von_mises"
  std::string_view label;  ///< as in a menu or a legend: "von Mises stress"
  std::string_view unit;   ///< "Pa"; "-" for a ratio, "" for an id
  bool is_signed = false;  ///< values below 0 mean the opposite of those above
};

/// Something that a picture can show besides the bodies.
struct ViewLayerInfo {
  std::string_view key;    ///< as in a scene file: "stress_axes"
  std::string_view label;  ///< as in a menu: "Principal stress axes"
  std::string_view hint;   ///< what it shows, a sentence
};

/// All layers, by ViewLayer.
std::span<const ViewLayerInfo> view_layers();

/// All quantities, in the order in which menus show them.
std::span<const ViewQuantity> view_quantities();
/// All ways to draw elements, by ElementStyle.
std::span<const std::string_view> element_style_names();
/// All qualities of pictures, by PictureQuality.
std::span<const std::string_view> picture_quality_names();
/// All colour maps' names, in the order in which menus show them; first "automatic", which is the one that suits.
std::span<const std::string_view> color_map_names();

}  // namespace griffith
