#pragma once

#include <span>
#include <string_view>

namespace griffith {

/// Quantity that colors can show, per node or tet.
struct ViewQuantity {
  std::string_view key;    ///< as in a scene file: "von_mises"
  std::string_view label;  ///< as in a menu or a legend: "von Mises stress"
  std::string_view unit;   ///< "Pa"; "-" for a ratio, "" for an id
  bool is_signed = false;  ///< values below 0 have the opposite meaning of those above
};

/// Layer that a picture can show besides the bodies.
struct ViewLayerInfo {
  std::string_view key;    ///< as in a scene file: "stress_axes"
  std::string_view label;  ///< as in a menu: "Principal stress axes"
  std::string_view hint;   ///< a sentence about its content
};

/// Returns all layers, by ViewLayer.
std::span<const ViewLayerInfo> view_layers();

/// Returns all quantities, in the order of menus.
std::span<const ViewQuantity> view_quantities();
/// Returns all styles of drawing elements, by ElementStyle.
std::span<const std::string_view> element_style_names();
/// Returns all qualities of pictures, by PictureQuality.
std::span<const std::string_view> picture_quality_names();
/// Returns the names of all color maps, in the order of menus. The first one, "automatic", chooses a suitable map.
std::span<const std::string_view> color_map_names();

}  // namespace griffith
