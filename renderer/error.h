#pragma once

#include <stdexcept>

namespace griffith::render {

/// Error such as a missing graphics device, a shader that the driver rejects, or an unreadable image file. what()
/// describes it.
class RenderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace griffith::render
