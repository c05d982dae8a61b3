#include "renderer/color_tables.h"

#include "renderer/shader_program.h"

namespace griffith::render {

ColorTables::ColorTables() {
  glActiveTexture(GL_TEXTURE0 + kColorTableUnit);
  for (const ColorMap map : kColorMaps) {
    glBindTexture(GL_TEXTURE_2D, tables_[static_cast<std::size_t>(map)].id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kColorTableSize, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, color_table(map).data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
}

void ColorTables::bind(ColorMap map) const {
  glActiveTexture(GL_TEXTURE0 + kColorTableUnit);
  glBindTexture(GL_TEXTURE_2D, tables_[static_cast<std::size_t>(map)].id());
}

}  // namespace griffith::render
