#pragma once

#include <span>
#include <string>

#include "sim/core/linear_algebra.h"

namespace griffith::app {

/// A number, tuple or array as USD's text has it.
std::string usda_number(double value);
std::string usda_tuple(std::span<const double> values);
std::string usda_tuple(const Vec3& v);
std::string usda_tuple(std::initializer_list<double> values);
std::string usda_array(std::span<const Vec3> vectors);
std::string usda_array(std::span<const Vec2> vectors);

/// A USD layer in text while it is written, indented by its braces.
class UsdaText {
 public:
  /// Begins with what the layer says of itself: metres, y up, frames 0 to `last_frame`, the default prim "World".
  UsdaText(double frames_per_second, int last_frame);

  void line(const std::string& text);
  void open(const std::string& head);  ///< a head and its opening brace
  void close();
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  int depth_ = 0;
};

}  // namespace griffith::app
