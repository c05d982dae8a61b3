#pragma once

#include <vector>

#include "app/regress/picture_result.h"

namespace griffith::app {

/// A flat picture with a square in it.
inline render::Image square_picture(int left, std::uint8_t brightness) {
  render::Image image{96, 64, {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const bool inside = left <= x && x < left + 20 && 20 <= y && y < 40;
      for (int channel = 0; channel < 3; ++channel) image.rgba.push_back(inside ? brightness : 220);
      image.rgba.push_back(255);
    }
  return image;
}

inline RegressionPicture some_picture(int left = 30) {
  RegressionPicture picture;
  picture.image = square_picture(left, 90);
  picture.ids = {96, 64, std::vector<std::int32_t>(96 * 64, left)};
  picture.text = "legend Utilization 0 to 1\nlabel " + std::to_string(left) + "\n";
  picture.state_hash = 0xABCDEF + static_cast<std::uint64_t>(left);
  picture.metadata = {{"renderer", "llvmpipe"}, {"camera", "front"}};
  picture.statistics = {{"pieces", left}, {"mass [kg]", 1000}};
  return picture;
}

/// One of each status, with all that text can hold to harm a report.
inline std::vector<PictureResult> one_of_each() {
  const std::string hostile = "<b>&\"'</b>\x1B[31m\xFF";
  std::vector<PictureResult> results = {
      compare_pictures("as ever", some_picture(), some_picture()),
      without_picture("not drawn " + hostile, "scenes/x.json: there is no such file\nsecond line " + hostile),
      without_golden("new one", some_picture()),
      compare_pictures("moved " + hostile, some_picture(30), some_picture(31))};
  for (PictureResult& result : results) {
    result.seconds = 0.25;
    if (result.status != PictureStatus::passed) result.accept_command = "griffith regress 'suite' --accept 'x & y'";
  }
  return results;
}

}  // namespace griffith::app
