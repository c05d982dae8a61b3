#pragma once

#include <span>
#include <string_view>

namespace griffith {

/// Layer that a picture can show besides the bodies.
struct ViewLayerInfo {
  std::string_view key;    ///< as in a scene file: "stress_axes"
  std::string_view label;  ///< as in a menu: "Principal stress axes"
  std::string_view hint;   ///< a sentence about its content
};

/// Returns all layers, by ViewLayer.
std::span<const ViewLayerInfo> view_layers();

/// Returns all styles of drawing elements, by ElementStyle.
std::span<const std::string_view> element_style_names();
/// Returns all qualities of pictures, by PictureQuality.
std::span<const std::string_view> picture_quality_names();
/// Returns the names of all color maps, in the order of menus. The first one, "automatic", chooses a suitable map.
std::span<const std::string_view> color_map_names();

}  // namespace griffith
