#pragma once

#include <string>
#include <vector>

#include "renderer/image.h"

namespace griffith::app {

/// Many pictures in one, in rows, each with its caption below. Keeps them small as they come.
class ContactSheet {
 public:
  /// `columns` >= 1; 0: as many as make the sheet about as wide as high.
  explicit ContactSheet(int columns = 0) : columns_(columns) {}

  void add(const render::Image& image, std::string caption);
  /// Draws the sheet. Needs a current OpenGL context, for the captions. Throws InputError, naming `where`, for more
  /// pictures than an image has room for.
  render::Image image(const std::string& where) const;

 private:
  struct Cell {
    render::Image picture;
    std::string caption;
  };
  int columns_;
  std::vector<Cell> cells_;
};

}  // namespace griffith::app
