#pragma once

#include <array>

#include "renderer/color_map.h"
#include "renderer/gl_objects.h"

namespace griffith::render {

/// All color maps on the device, for the passes that show scalars.
class ColorTables {
 public:
  ColorTables();

  /// Binds the table of `map` for shaders.
  void bind(ColorMap map) const;

 private:
  std::array<Texture, kColorMaps.size()> tables_;
};

}  // namespace griffith::render
