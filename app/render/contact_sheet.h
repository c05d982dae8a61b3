#pragma once

#include <string>
#include <vector>

#include "renderer/image.h"

namespace griffith::app {

/// Many pictures in one, in rows with captions. Scales them down as they arrive.
class ContactSheet {
 public:
  /// `columns` >= 1; 0: for a sheet that is about square.
  explicit ContactSheet(int columns = 0) : columns_(columns) {}

  void add(const render::Image& image, std::string caption);
  /// Draws the sheet. Needs a current OpenGL context for the captions. Throws InputError, naming `where`, for more
  /// pictures than fit into an image.
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
