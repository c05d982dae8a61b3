#pragma once

#include <stdexcept>

namespace griffith::render {

/// No graphics device, a shader that the driver rejects, an image file that can't be read. what() says
/// which.
class RenderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace griffith::render
