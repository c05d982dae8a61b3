#pragma once

#include <span>
#include <string>

#include "sim/core/linear_algebra.h"

namespace griffith::app {

std::string usda_tuple(std::span<const double> values);
std::string usda_tuple(const Vec3& v);
std::string usda_tuple(std::initializer_list<double> values);
std::string usda_array(std::span<const Vec3> vectors);
std::string usda_array(std::span<const Vec2> vectors);

/// Writer of a USD layer as text, indented by its braces.
class UsdaText {
 public:
  /// Writes the header of the layer: meters, y up, frames 0 to `last_frame`, the default prim "World".
  UsdaText(double frames_per_second, int last_frame);

  void line(const std::string& text);
  void open(const std::string& head);  ///< writes a head and its opening brace
  void close();
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  int depth_ = 0;
};

}  // namespace griffith::app
